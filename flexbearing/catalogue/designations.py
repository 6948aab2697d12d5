"""Bearings by their designation: tables of catalogue pages that users extend."""

import re
from collections.abc import Iterable, Iterator, Mapping
from difflib import get_close_matches
from pathlib import Path

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.case.quantity import Mass, Speed
from flexbearing.catalogue.entries import ENTRIES

TABLE = "designations.csv"
LARGEST = 2**20  # bytes of a table, some 10 000 bearings
CLOSE, MOST, LONGEST = 0.6, 5, 40  # share of letters, names and letters of a proposal
_SUFFIXES = re.compile(
    r"(?P<bearing>.+?)(?:-?(?:2?RS[1HLR]?|2?RZ|2?Z|ZZ))?(?:[-/ ]+(?P<clearance>C[1-5N]))?", re.I
)
ABOUT = ("designation", "like", "source")  # columns besides entries of a page
FURTHER = {"mass": Mass, "reference_speed": Speed, "limiting_speed": Speed}  # that a selection reads


def designated(name: str, *folders: Path) -> dict[str, str] | None:
    """Entries of a bearing with its like and source, from the first folder whose table has it, else shipped.

    Where none has the whole name, suffixes of seals are left out, and one of clearance is its class.

    Raises `BadCase` for a table that cannot be read.
    """
    known: dict[str, dict[str, str]] = {}
    for row in _known(folders):
        known.setdefault(plain(row["designation"]), {key: text for key, text in row.items() if text})
    parts = _SUFFIXES.fullmatch(name)
    if plain(name) in known or parts is None or plain(parts["bearing"]) not in known:
        return known.get(plain(name))
    clearance = {"clearance_class": parts["clearance"].upper()} if parts["clearance"] else {}
    return known[plain(parts["bearing"])] | clearance


def unknown(name: str, *folders: Path) -> str:
    """What to say of a name that no table has: the nearest ones, and where more go."""
    known: dict[str, str] = {}
    for row in _known(folders):
        known.setdefault(plain(row["designation"]), row["designation"])
    near = [known[each] for each in get_close_matches(plain(name), known, cutoff=CLOSE)]
    names = ", ".join(each[:LONGEST] for each in (near or [*known.values()])[:MOST])
    words = f"near {'is' if len(near) == 1 else 'are'}" if near else "it has bearings such as"
    return f"{name} is in no table of designations, {words} {names}; more are rows of a {TABLE} in its folder"


def _known(folders: Iterable[Path]) -> Iterator[Mapping[str, str]]:
    """Rows of all tables, those of users first."""
    for table in tables(*folders):
        yield from (row for _, row in numbered_rows(table))


def tables(*folders: Path) -> list[Path]:
    """Tables of some folders, and the shipped one."""
    return [folder / TABLE for folder in (*folders, Path(__file__).parent) if (folder / TABLE).exists()]


def numbered_rows(table: Path) -> Iterator[tuple[int, Mapping[str, str]]]:
    """Rows of a table by its headings, each with its line in the file.

    Raises `BadCase` for a table that cannot be read.
    """
    try:
        lines = inputs.numbered_cells(inputs.text(table, LARGEST), LARGEST)
        _, heads = next(lines, (1, []))
        inputs.require_different(heads)
        known = (*ABOUT, *ENTRIES, *FURTHER)
        if unknown := [head for head in heads if head not in known]:
            raise BadCase(f"{table}: {unknown[0][:60]!r} is no column; they are {', '.join(known)}.")
        if missing := [head for head in ("designation", "like") if head not in heads]:
            raise BadCase(f"{table}: has no column {missing[0]}.")
        for number, cells in lines:
            if len(cells) != len(heads):
                raise BadCase(f"{table}: line {number} has {len(cells)} cells, its header {len(heads)}.")
            yield number, dict(zip(heads, cells, strict=True))
    except inputs.Unreadable as problem:
        raise BadCase(f"{table}: {problem}") from problem


def plain(name: str) -> str:
    """A designation as makers write it, NU 2210 or nu2210."""
    return name.replace(" ", "").replace("-", "").upper()
