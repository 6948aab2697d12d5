"""Writes the reference pages into a folder."""

import sys
from pathlib import Path

from flexbearing.reference import pages


def write(folder: Path) -> None:
    """Write all pages; pages of the folders `case` and `result` that are no longer made go."""
    made = {folder / name: text for name, text in pages().items()}
    for old in {*folder.glob("case/*.md"), *folder.glob("result/*.md")} - set(made):
        old.unlink()
    for path, text in made.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")


if __name__ == "__main__":
    write(Path(sys.argv[1]))
