"""Numbers in files of other programs: short, of ASCII digits, finite, of a size to compute with."""

import re

LONGEST = 64  # characters of a number; 17 digits and an exponent take 24
LARGEST = 1e100  # its square is finite
_NUMBER = re.compile(r"([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+))(?:[DEde]?([+-][0-9]+)|[DEde]([0-9]+))?", re.ASCII)
_WHOLE = re.compile(r"[+-]?[0-9]+", re.ASCII)


class BadNumber(ValueError):
    """A text that is no number, or none of the allowed size; the message quotes its beginning."""


def number(text: str, largest: float = LARGEST) -> float:
    """A finite number; 1.5D+06 is that of Fortran, 1.5+6 that of Nastran.

    Raises `BadNumber` for anything else, nan and infinity among it.

    >>> number(" 1.5D+06 ")
    1500000.0
    """
    bare = _short(text)
    parts = _NUMBER.fullmatch(bare)
    if parts is None:
        raise BadNumber(f"{bare!r} is no number")
    value = float(bare if parts.lastindex == 1 else f"{parts[1]}e{parts[2] or parts[3]}")
    if abs(value) > largest:
        raise BadNumber(f"{bare} is above {largest:g}")
    return value


def whole(text: str, least: int, most: int) -> int:
    """A whole number between two others.

    Raises `BadNumber` for anything else, 1.5 and digits of other scripts among it.

    >>> whole("16", 1, 100)
    16
    """
    bare = _short(text)
    if not _WHOLE.fullmatch(bare):
        raise BadNumber(f"{bare!r} is no whole number")
    value = int(bare)
    if not least <= value <= most:
        raise BadNumber(f"{value} is not between {least} and {most}")
    return value


def _short(text: str) -> str:
    """A text without blanks around it that is short enough for a number."""
    bare = text.strip()
    if len(bare) > LONGEST:
        raise BadNumber(f"{bare[:20]!r}... is longer than a number, {len(text)} characters")
    return bare
