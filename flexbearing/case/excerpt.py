"""What messages quote of a case: short, in one line, without control characters."""

from flexbearing.printable import printable

LONGEST = 60  # characters of a value or a key that are quoted


def excerpt(text: str, longest: int = LONGEST) -> str:
    r"""Quote a text from elsewhere.

    Parameters
    ----------
    text : str
        of any length
    longest : int
        characters that are quoted

    Returns
    -------
    str
        its beginning, with its length where that is not all

    >>> print(excerpt("50 um\n"), excerpt("clearance", 5))
    50 um\n clear... (9 characters)
    """
    beginning = printable(text[:longest]).replace("\n", "\\n").replace("\t", "\\t")
    return beginning if len(text) <= longest else f"{beginning}... ({len(text)} characters)"
