"""Texts of a user or of a drawing as messages quote them."""

import json
from collections.abc import Iterable

LONGEST = 60  # characters of a text
MOST = 20  # texts of a list


def shortened(text: str, longest: int = LONGEST) -> str:
    r"""Write the beginning of a text in one line, without control characters.

    >>> print(shortened("foot\n"), shortened("raceway", 4))
    foot\n race...
    """
    beginning = "".join(
        letter if letter.isprintable() else json.dumps(letter)[1:-1] for letter in text[:longest]
    )
    return beginning if len(text) <= longest else f"{beginning}..."


def enumerated(texts: Iterable[str]) -> str:
    """Enumerate the first texts in alphabetical order, and say how many more there are; "none" of none."""
    ordered = sorted(texts)
    left = f" and {len(ordered) - MOST} more" if len(ordered) > MOST else ""
    return (", ".join(ordered[:MOST]) or "none") + left
