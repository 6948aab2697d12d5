"""Tables of pages that commands compute: each stands between two comments and is made from a stored CSV."""

import re
from pathlib import Path

DOCS = Path(__file__).parents[1] / "docs"
_BLOCK = r"<!-- computed: {name} -->\n(.*?)<!-- end -->"


def tables(page: Path) -> dict[str, str]:
    """Tables of a page by name, as they stand there."""
    found = re.findall(_BLOCK.format(name="(.+?)"), page.read_text(encoding="utf-8"), re.DOTALL)
    return {name: table.strip() for name, table in found}


def fill(page: Path, computed: dict[str, str]) -> None:
    """Replace the tables of a page; every name must stand there."""
    text = page.read_text(encoding="utf-8")
    for name, table in computed.items():
        block = f"<!-- computed: {name} -->\n\n{table.strip()}\n\n<!-- end -->"
        text, count = re.subn(
            _BLOCK.format(name=re.escape(name)), lambda _, b=block: b, text, flags=re.DOTALL
        )
        if count != 1:
            raise SystemExit(f"{page}: {count} places for the table {name}")
    page.write_text(text, encoding="utf-8")
