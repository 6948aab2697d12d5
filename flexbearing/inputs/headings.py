"""Headings of a table that was read."""

from collections import Counter
from collections.abc import Sequence

from flexbearing.inputs.file import Unreadable

LONGEST = 60  # characters of a heading in a message


def require_different(headings: Sequence[str]) -> None:
    """Refuse a heading that stands twice, before the cells below are looked at.

    Raises
    ------
    Unreadable
        naming the first one
    """
    twice = next((name for name, count in Counter(headings).items() if count > 1), None)
    if twice is not None:
        raise Unreadable(f"has several columns {twice[:LONGEST]!r}; one of them is enough")
