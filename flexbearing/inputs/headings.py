"""Headings of a table that was read."""

from collections import Counter
from collections.abc import Sequence

from flexbearing.inputs.file import Unreadable

LONGEST = 60  # characters of a heading in a message


def require_different(names: Sequence[str], what: str = "columns") -> None:
    """Refuse a heading that stands twice, before the cells below are looked at; or the name of another thing.

    Raises
    ------
    Unreadable
        naming the first one
    """
    twice = next((name for name, count in Counter(names).items() if count > 1), None)
    if twice is not None:
        raise Unreadable(f"has several {what} {twice[:LONGEST]!r}; one of them is enough")
