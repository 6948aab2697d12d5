"""The bearings of a table as cases, and what keeps one from being rated."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import pi
from pathlib import Path
from typing import Any, get_args

from pydantic_core import PydanticCustomError

from flexbearing.case import BadCase, understood
from flexbearing.catalogue import page as pages
from flexbearing.catalogue.designations import FURTHER, numbered_rows
from flexbearing.catalogue.entries import ENTRIES, LIKES
from flexbearing.catalogue.new import case_text
from flexbearing.families import FAMILIES
from flexbearing.select.application import UNITS, Application

# Assumed: mass over that of a steel ring of the same d, D and B. Makers' 6205 to 6310 have 0.65 to 0.70.
FILL, STEEL = 0.67, 7850.0  # [-], [kg/m^3]
SIZES = "bore", "outside", "width"


@dataclass(frozen=True, kw_only=True)
class Candidate:
    """A bearing of a table."""

    designation: str
    like: str
    entries: Mapping[str, str]  # of its page, as the table has them
    source: str
    sizes: tuple[float, float, float]  # d, D, B [m]
    given_mass: float | None = None  # [kg]
    reference_speed: float | None = None  # [rad/s]
    limiting_speed: float | None = None  # [rad/s]

    @property
    def mass(self) -> float:
        """The given mass, else an estimate [kg]."""
        bore, outside, width = self.sizes
        estimate = FILL * STEEL * pi / 4 * (outside**2 - bore**2) * width
        return estimate if self.given_mass is None else self.given_mass

    @property
    def rollers(self) -> bool:
        """Whether its rolling elements are rollers."""
        return LIKES[self.like].kind in ("cylindrical_roller", "tapered_roller")

    def case(self, application: Application) -> Any:
        """The case that `flexbearing new` makes of its page, with the largest loads and speed.

        Raises `BadCase` where it does not carry such loads, and where no case can be made of its page.
        """
        text, _ = case_text(self.like, dict(self.entries) | self._largest(application), Path(self.file))
        case: Any = understood(text, Path(self.file), {}, FAMILIES)
        life = case.life.model_copy(update={"reliability": application.reliability})
        return case.model_copy(update={"life": life})

    @property
    def file(self) -> str:
        """Name of its case, as `flexbearing new` writes it."""
        return f"{self.designation.replace(' ', '').replace('/', '-').lower()}.toml"

    def _largest(self, application: Application) -> dict[str, str]:
        """Entries with which its page is read; the application has other rows besides."""
        wanted, largest = LIKES[self.like], {}
        for name in ("load", "axial", "speed"):
            value = float(abs(application.speed if name == "speed" else application.of(name)).max())
            if value:
                largest[name] = f"{value!r} {UNITS[name]}"
        for name in largest.keys() - {*wanted.taken}:
            raise BadCase(f"takes no {ENTRIES[name].meaning}")
        for name in wanted.needed:
            if name in UNITS and wanted.must_be_given(name, largest):
                raise BadCase(f"needs a load: {ENTRIES[name].meaning}")
        return largest


def candidates(tables: Iterable[Path]) -> Iterator[Candidate]:
    """Bearings of some tables; of two with the same designation the first one.

    Raises `BadCase` naming file, line and column of a cell that cannot be read.
    """
    known = set[str]()
    for table in tables:
        for line, row in numbered_rows(table):
            found = _candidate(row, f"{table}: line {line}")
            if found.designation not in known:
                known.add(found.designation)
                yield found


def _candidate(row: Mapping[str, str], where: str) -> Candidate:
    designation, like = row["designation"], row["like"]
    if not designation:
        raise BadCase(f"{where}, column designation: it is empty.")
    if like not in LIKES:
        raise BadCase(f"{where}, column like: {like[:40]!r} is none of {', '.join(LIKES)}.")
    wanted = LIKES[like]
    entries = {name: text for name, text in row.items() if name in ENTRIES and text}
    for name in entries:
        if name not in wanted.taken:
            raise BadCase(f"{where}, column {name}: a {like} takes none.")
    needed = [name for name in wanted.needed if name not in UNITS]
    for name in needed:
        if name not in entries:
            raise BadCase(f"{where}, column {name}: it is empty; a {like} needs it.")
    values = {name: _cell(name, text, like, where) for name, text in entries.items()}
    further = {name: _further(name, text, where) for name in FURTHER if (text := row.get(name))}
    bore, outside, width = (values[name].si for name in SIZES)
    if not bore < outside:
        raise BadCase(f"{where}, column outside: {entries['outside']} is not above the bore.")
    return Candidate(
        designation=designation,
        like=like,
        entries=entries,
        source=row.get("source", ""),
        sizes=(bore, outside, width),
        given_mass=further.get("mass"),
        reference_speed=further.get("reference_speed"),
        limiting_speed=further.get("limiting_speed"),
    )


def _cell(name: str, text: str, like: str, where: str) -> pages.Value:
    try:
        return pages.value(name, text, like)
    except BadCase as problem:
        raise BadCase(f"{where}, column {name}: {problem}") from problem


def _further(name: str, text: str, where: str) -> float:
    kind = get_args(FURTHER[name])[1]
    try:
        value = kind.to_si(text)
    except PydanticCustomError as problem:
        raise BadCase(f"{where}, column {name}: {text[:40]!r} {problem}.") from None
    if value <= 0:
        raise BadCase(f"{where}, column {name}: {text[:40]} must be above zero.")
    return float(value)
