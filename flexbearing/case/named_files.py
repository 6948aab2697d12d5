"""Content of the files that a case names."""

from functools import lru_cache
from hashlib import sha256
from pathlib import Path

from flexbearing.case.head import Head


def digests(case: Head) -> str:
    """Digests of all of them, one after the other; that there is none is told when the part is made."""
    return "".join(_digest(path) for path in case.named_files)


@lru_cache(maxsize=64)
def _digest(path: Path) -> str:
    return sha256(path.read_bytes()).hexdigest() if path.is_file() else ""
