"""Tables and folded parts in Markdown."""

from collections.abc import Iterable, Sequence


def table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """Lines of a table; none without rows."""
    lines = [f"|{'|'.join(map(_cell, row))}|" for row in rows]
    return [f"|{'|'.join(head)}|", f"|{'---|' * len(head)}", *lines, ""] if lines else []


def folded(title: str, lines: Sequence[str]) -> list[str]:
    """Lines under a title that opens them; none without lines."""
    shown = title.replace("&", "&amp;").replace("<", "&lt;")
    return [f"<details><summary>{shown}</summary>", "", *lines, "</details>", ""] if lines else []


def _cell(text: str) -> str:
    return text.replace("|", "\\|")
