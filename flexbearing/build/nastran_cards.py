"""Cards of a Nastran file: free, small or large fields, with their continuations."""

from collections.abc import Iterable, Iterator
from itertools import chain

from flexbearing.inputs import Unreadable

MOST_FIELDS = 2**22  # of a card; a million numbers in a column of a matrix


def cards(lines: Iterable[str], wanted: str) -> Iterator[list[str]]:
    """Fields of every card of a name, without the name.

    Raises
    ------
    Unreadable
        for a card with more than `MOST_FIELDS`
    """
    fields: list[str] = []
    for line in chain(lines, [wanted]):
        text = line.partition("$")[0].rstrip()
        head = text.split(",", 1)[0][:8].strip().upper() if text else ""
        if text and fields and (head in ("", "*") or head[0] in "+*"):
            fields += _fields(text)
            if len(fields) > MOST_FIELDS:
                raise Unreadable(f"has a card {wanted} with more than {MOST_FIELDS} fields")
            continue
        if fields:
            yield fields
        fields = _fields(text) if head.rstrip("*") == wanted and text != wanted else []


def _fields(text: str) -> list[str]:
    """Fields of a line behind its name: four of 16 characters behind a star, else eight of 8."""
    large = "*" in text.split(",", 1)[0][:8]
    count = 4 if large else 8
    if "," in text:
        words = text.split(",")[1:]
    else:
        size = 64 // count
        fixed = text.expandtabs()
        words = [fixed[8 + size * k : 8 + size * (k + 1)] for k in range(count)]
    return [word.strip() for word in [*words, *[""] * count][:count]]
