"""The name of a variant: a digest of all that its numbers depend on."""

from contextlib import suppress
from functools import lru_cache
from hashlib import file_digest, sha256
from pathlib import Path

from flexbearing import inputs
from flexbearing.case import Head
from flexbearing.quantities.attributes import FORMAT

LENGTH = 32  # characters that are kept, 128 bits


def identity(case: Head) -> str:
    """Digest of the format of results and of a complete case in SI units as JSON, keys in their order.

    Parameters
    ----------
    case : Head
        as it was read; files that it names enter with their content

    Returns
    -------
    str
        32 hexadecimal characters
    """
    files = "".join(_content(path) for path in case.named_files)
    text = f"{FORMAT} {case.model_dump_json()} {files}"
    return sha256(text.encode()).hexdigest()[:LENGTH]


@lru_cache(maxsize=64)
def _content(path: Path) -> str:
    """Digest of a file; that there is none is told when the part is made."""
    with suppress(inputs.Unreadable), inputs.opened(path) as file:
        return file_digest(file, "sha256").hexdigest()
    return ""
