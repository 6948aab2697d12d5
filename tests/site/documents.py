"""Markdown of README and site: sections, tables, blocks of commands with their output."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from tests.places import ROOT

GENERATED = (
    "docs/reference/api/",
    "docs/_build/",
    "docs/evidence/",
    "docs/reference/case",
    "docs/reference/result",
    "docs/reference/study.md",
    "docs/reference/optimise.md",
)
FENCE = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```", re.M | re.S)
FIGURE = re.compile(r"\d\.\d|\d %|\d (?:m?s|h|N|kN|GiB|MB)\b")
COMMAND = re.compile(
    r"`(?:python -m|flexbearing|pytest|make) ?[\w.]|^(?:    |\$ )?(?:python -m|flexbearing|pytest|make) "
    r"|\{code-cell\}|tests/\S+\.py|`benchmarks[./]\w+|`test_\w+\.py`",
    re.M,
)


@dataclass(frozen=True)
class Section:
    """A heading with what follows it, and the section that it is part of."""

    page: str
    title: str
    text: str
    before: str  # the section that encloses it, up to its first heading below

    @property
    def figures(self) -> int:
        """Measured numbers in tables: those with a decimal point, a per cent sign or a unit."""
        rows = [line for line in self.text.splitlines() if line.lstrip().startswith("|")]
        return sum(len(FIGURE.findall(row)) for row in rows)

    @property
    def commanded(self) -> bool:
        return bool(COMMAND.search(self.text) or COMMAND.search(self.before))


def pages() -> list[Path]:
    found = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]
    return [path for path in found if not path.relative_to(ROOT).as_posix().startswith(GENERATED)]


def sections(path: Path) -> Iterator[Section]:
    """Sections of a page, headings in code blocks left out."""
    text = FENCE.sub(lambda block: re.sub(r"^#", " #", block[0], flags=re.M), path.read_text("utf-8"))
    above: dict[int, str] = {}
    for piece in re.split(r"^(?=#{1,4} )", text, flags=re.M):
        heading = re.match(r"(#{1,4}) (.*)", piece)
        level = len(heading[1]) if heading else 0
        above = {depth: body for depth, body in above.items() if depth < level}
        title = heading[2] if heading else ""
        yield Section(path.relative_to(ROOT).as_posix(), title, piece, above[max(above)] if above else "")
        above[level] = piece


@dataclass(frozen=True)
class Command:
    """A command of a console block with the lines that the page shows of its output."""

    line: str
    shown: tuple[str, ...]


def consoles(path: Path) -> list[list[Command]]:
    """Console blocks of a page: lines after a dollar, continued by a backslash, each with its output."""
    blocks = []
    for language, body in FENCE.findall(path.read_text("utf-8")):
        if language == "console":
            pieces = re.split(r"^\$ ", re.sub(r"\\\n *", "", body), flags=re.M)[1:]
            lines = [piece.rstrip("\n").split("\n") for piece in pieces]
            blocks.append([Command(first, tuple(rest)) for first, *rest in lines])
    return blocks
