"""What messages quote of a case: short, in one line, without control characters."""

from collections.abc import Collection
from itertools import islice

from flexbearing.printable import printable

MOST = 8  # texts of a list
LONGEST = 60  # characters of a value or a key that are quoted


def excerpt(text: str, longest: int = LONGEST) -> str:
    r"""Quote a text from elsewhere.

    >>> print(excerpt("50 um\n"), excerpt("clearance", 5))
    50 um\n clear... (9 characters)
    """
    beginning = printable(text[:longest]).replace("\n", "\\n").replace("\t", "\\t")
    return beginning if len(text) <= longest else f"{beginning}... ({len(text)} characters)"


def enumerated(texts: Collection[str]) -> str:
    """Enumerate the first texts, each an excerpt, and say how many more there are.

    >>> enumerated([str(number) for number in range(10)])
    '0, 1, 2, 3, 4, 5, 6, 7 and 2 more'
    """
    left = f" and {len(texts) - MOST} more" if len(texts) > MOST else ""
    return ", ".join(islice(texts, MOST)) + left
