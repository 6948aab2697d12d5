"""What every case file begins with, for any bearing."""

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache, reduce
from hashlib import file_digest
from pathlib import Path
from typing import Any, ClassVar, Self

from pydantic import PrivateAttr

from flexbearing import inputs
from flexbearing.case.quantity import Section, key

KIND = (
    "family of the bearing; it decides which other keys there are. The first line of the file, above every "
    "[section]; without it the case is a roller bearing"
)


def value_at(tables: Any, key: str) -> Any:
    """What nested tables have at a dotted key; None where it is not given."""
    for name in key.split("."):
        tables = tables.get(name) if isinstance(tables, Mapping) else None
    return tables


def next_to(case: Path, names: Iterable[Any]) -> tuple[Path, ...]:
    """Files with some names next to a case; what is no name is left out."""
    return tuple(case.parent / name for name in names if isinstance(name, str))


@dataclass(frozen=True)
class Source:
    """Where a case came from."""

    path: str
    text: str  # of the file, letter by letter
    overrides: tuple[str, ...]  # "key=value" settings on top of it


class ReportHead(Section):
    """Who and what the first page of a report names; all of it may be left out."""

    project: str | None = key("project or machine", None, example="Gearbox G12")
    part: str | None = key("number or name of the part", None, example="Planet bearing, item 31")
    revision: str | None = key("revision of the computation", None, example="B")
    date: str | None = key("date on the report, as text", None, example="2026-03-14")
    author: str | None = key("who computed it", None, example="A. Bauer")
    checker: str | None = key("who checked it", None, example="C. Dietz")


class Head(Section):
    """Keys of every case."""

    file_keys: ClassVar[tuple[str, ...]] = ()  # those that name a file next to the case

    kind: str = key(KIND)
    title: str = key(
        "what the case is, in words; without it the name of the file",
        "",
        example="A bearing between two rings",
    )
    assumed: tuple[str, ...] = key(
        "keys whose values the source of the case does not give", (), example=["outer.bars"], strict=False
    )
    calibrated: Mapping[str, str] = key(
        "keys whose values were fitted, each with what to",
        {},
        example={"bearing.clearance": "measured deflection"},
    )
    report: ReportHead = key("names on the first page of a report; no result depends on them", {})

    _source: Source = PrivateAttr(default=Source("", "", ()))
    _nodes_of: Any = PrivateAttr(default=None)

    @property
    def source(self) -> Source:
        """File and settings that the case was read from."""
        return self._source

    @property
    def nodes_of(self) -> Self | None:
        """Case whose meshes are taken, their nodes moved to the dimensions of this one; None: its own."""
        return self._nodes_of

    def on_nodes_of(self, other: Self | None) -> Self:
        """The same case on the moved nodes of another one, from which it differs little."""
        case = self.model_copy()
        case._nodes_of = other
        return case

    @property
    def input_files(self) -> tuple[Path, ...]:
        """Files that the case was read from, which no output may replace."""
        return (*((Path(self.source.path),) if self.source.path else ()), *self.named_files)

    @property
    def named_files(self) -> tuple[Path, ...]:
        """Files that the case names, whose content is a part of it, and unknowns beside a CalculiX matrix."""
        names = [
            name
            for name in (reduce(_part, key.split("."), self) for key in self.file_keys)
            if name is not None
        ]
        files = next_to(Path(self.source.path), names) if names else ()
        return (*files, *(file.with_suffix(".dof") for file in files if file.suffix.lower() == ".sti"))

    def to_json(self) -> dict[str, Any]:
        """Values in SI units, as JSON can hold them."""
        return self.model_dump(mode="json")


def _part(section: Any, name: str) -> Any:
    """A key of a table; None where the case has no such table."""
    return getattr(section, name, None)


def digests(case: Head) -> str:
    """Digests of all of them, one after the other; that there is none is reported when the part is made."""
    return "".join(map(_digest, case.named_files))


def _digest(path: Path) -> str:
    with suppress(inputs.Unreadable):
        return _content(inputs.stamp(path))
    return ""


@lru_cache(maxsize=64)
def _content(stamp: inputs.Stamp) -> str:
    with inputs.opened(stamp.path) as file:
        return file_digest(file, "sha256").hexdigest()
