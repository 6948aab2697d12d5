"""Content of the files that a case names."""

from contextlib import suppress
from functools import lru_cache
from hashlib import file_digest
from pathlib import Path

from flexbearing import inputs
from flexbearing.case.head import Head


def digests(case: Head) -> str:
    """Digests of all of them, one after the other; that there is none is reported when the part is made."""
    return "".join(map(_digest, case.named_files))


def _digest(path: Path) -> str:
    with suppress(inputs.Unreadable):
        return _content(inputs.stamp(path))
    return ""


@lru_cache(maxsize=64)
def _content(stamp: inputs.Stamp) -> str:
    with inputs.opened(stamp.path) as file:
        return file_digest(file, "sha256").hexdigest()
