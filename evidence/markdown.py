"""Numbers and rows of tables in Markdown."""


def shown(value: float, digits: int = 6) -> str:
    """A number with some digits."""
    return f"{value:.{digits}g}".replace("e-0", "e-").replace("e+0", "e")


def cells(*texts: str) -> str:
    """A row of a table."""
    return f"|{'|'.join(texts)}|"
