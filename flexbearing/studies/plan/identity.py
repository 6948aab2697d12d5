"""The name of a variant: a digest of all that its numbers depend on."""

from hashlib import sha256

from flexbearing.case import Head
from flexbearing.case.head import digests
from flexbearing.quantities.attributes import FORMAT

NAMES = {"report"}  # names on a page, on which no number depends
LENGTH = 32  # characters that are kept, 128 bits


def identity(case: Head) -> str:
    """Digest of the format of results and of a complete case in SI units as JSON, keys in their order."""
    text = f"{FORMAT} {case.model_dump_json(exclude=NAMES)} {digests(case)}"
    return sha256(text.encode()).hexdigest()[:LENGTH]
