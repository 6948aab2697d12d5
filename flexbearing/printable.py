"""Texts from elsewhere, made fit for a terminal or a picture."""

import re
from collections.abc import Collection
from itertools import islice
from typing import Any

# Control characters but for the end of a line, and marks that turn the direction of what follows.
_UNFIT = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
MOST = 8  # texts of a list
LONGEST = 60  # characters of a value or a key that are quoted
LONGEST_LINE = 500  # characters of a message in a line


def printable(text: str) -> str:
    r"""Write characters that would control a terminal as their codes, ``\x1b``; ends of lines stay.

    >>> print(printable("Ring \x1b[31mred"))
    Ring \x1b[31mred
    """
    return _UNFIT.sub(lambda found: found[0].encode("unicode_escape").decode(), text)


def all_printable(value: Any) -> Any:
    """Every text made printable within lists, tuples and mappings of texts and numbers."""
    if isinstance(value, str):
        return printable(value)
    if isinstance(value, dict):
        return {all_printable(name): all_printable(item) for name, item in value.items()}
    if isinstance(value, list | tuple):
        return type(value)(all_printable(item) for item in value)
    return value


def excerpt(text: str, longest: int = LONGEST) -> str:
    r"""Quote a text from elsewhere.

    >>> print(excerpt("50 um\n"), excerpt("clearance", 5))
    50 um\n clear... (9 characters)
    """
    beginning = printable(text[:longest]).replace("\n", "\\n").replace("\t", "\\t")
    return beginning if len(text) <= longest else f"{beginning}... ({len(text)} characters)"


def one_line(problem: object, longest: int = LONGEST_LINE) -> str:
    r"""Join the lines of a message.

    >>> one_line("no life\nno load"), one_line("no life", 2)
    ('no life; no load', 'no... (7 characters)')
    """
    return excerpt("; ".join(str(problem).splitlines()), longest)


def enumerated(texts: Collection[str]) -> str:
    """Enumerate the first texts, each an excerpt, and say how many more there are.

    >>> enumerated([str(number) for number in range(10)])
    '0, 1, 2, 3, 4, 5, 6, 7 and 2 more'
    """
    left = f" and {len(texts) - MOST} more" if len(texts) > MOST else ""
    return ", ".join(islice(texts, MOST)) + left
