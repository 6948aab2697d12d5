"""What one run left behind, as arrays that cannot change."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.case.family import Family
from flexbearing.case.head import next_to, value_at
from flexbearing.outputs import Outputs, Value
from flexbearing.quantities.attributes import GRADES
from flexbearing.quantities.summary import summary
from flexbearing.results.checks import require_same_names
from flexbearing.results.content import ITERATIONS

if TYPE_CHECKING:
    from xarray import DataTree

Arrays = Mapping[str, np.ndarray]
NOTHING: Arrays = MappingProxyType({})


TIMES = "created", "wall_time_s", "seconds", "machine"  # by which two results of one case differ
OF_FILES = ("slice_error",)  # what a run computes only for a file


@dataclass(frozen=True, kw_only=True, eq=False)
class Result:
    """What one run left behind, in SI units; names as in the layout.

    Two results are equal where everything in them is but times and the place of the file.
    """

    path: Path | None  # of its file; None where nothing was written
    attributes: Mapping[str, Any]  # JSON attributes are mappings again, lists are tuples
    rigid: Arrays  # empty when the run ended before it was solved
    flexible: Arrays  # likewise; of ball bearings also between rigid rings
    iterations: tuple[Arrays, ...]  # from the first to the last
    family: Family  # of the bearing

    @property
    def end_states(self) -> "Result":
        """The same without its iterations, which it then says."""
        attributes = MappingProxyType({**self.attributes, "left_out": ITERATIONS})
        return replace(self, path=None, iterations=(), attributes=attributes)

    @property
    def kind(self) -> str:
        """Name of the family."""
        return self.family.kind

    @property
    def place(self) -> str:
        """Its file, or where there is none its title: what a message names."""
        return str(self.path) if self.path else f"result of {self.attributes['title']!r}"

    @property
    def stem(self) -> str:
        """Stem of the names of files that are made of it: that of its file, or of the case."""
        return Path(self.path or self.attributes.get("case_file") or self.kind).stem

    @property
    def files(self) -> tuple[Path, ...]:
        """Its file, its case, and files that the case names: no output may replace one of them."""
        stated = self.attributes.get("case_file")
        case = Path(stated) if isinstance(stated, str) else None
        names = [value_at(self.attributes.get("case_si"), key) for key in self.family.case().file_keys]
        own = [file for file in (self.path, case) if file]
        return (*own, *(named for file in own for named in next_to(file, names)))

    @property
    def dangers(self) -> tuple[Mapping[str, str], ...]:
        """Notes that whoever acts on the answer must heed, each with its code and text."""
        return tuple(note for note in self.attributes["notes"] if note["grade"] == GRADES[0])

    def __getitem__(self, output: str) -> Value:
        """A scalar by its name, "max_roller_load [kN]", or "life [h]", the most detailed life."""
        return self.outputs[output]

    @property
    def outputs(self) -> Outputs:
        """Every scalar with its value, unit and meaning, by name; `search` finds some."""
        return Outputs(self.family.layout(), self._blocks)

    @property
    def plot(self) -> Any:
        """Its pictures: `plot.loads()`, `plot.pressure()` and what `dir(plot)` names."""
        return self.family.report().plots(self)

    def report(self, file: str | Path, **options: Any) -> Path:
        """Write its report, as `flexbearing report` with the same options; returns the file."""
        return self.family.write_report()(self, file, **options)[0]

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Result):
            return NotImplemented
        return (
            self.kind == other.kind
            and _timeless(dict(self.attributes)) == _timeless(dict(other.attributes))
            and len(self.iterations) == len(other.iterations)
            and all(map(_same, self._arrays, other._arrays))
        )

    def __repr__(self) -> str:
        return self.card.text().rstrip()

    def _repr_html_(self) -> str:
        return self.card.html()

    @property
    def card(self) -> Any:
        """Its answer in a few lines, a `flexbearing.report.card.Card`."""
        return self.family.card()(self)

    def __reduce__(self) -> tuple[Any, ...]:
        arrays = [dict(block) for block in self._arrays]
        return _restored, (self.path, dict(self.attributes), arrays, self.family)

    @property
    def _blocks(self) -> dict[str, Arrays]:
        return {"rigid": self.rigid, "flexible": self.flexible}

    @property
    def _different_blocks(self) -> dict[str, Arrays]:
        """The same; of a case without a flexible part one alone, as both are equal."""
        alike = self.rigid.keys() == self.flexible.keys() and _same(self.rigid, self.flexible)
        return {"rigid": self.rigid} if alike else self._blocks

    @property
    def _arrays(self) -> tuple[Arrays, ...]:
        return (self.rigid, self.flexible, *self.iterations)

    def to_xarray(self) -> "DataTree":
        """Blocks and iterations with named dimensions, places along them and units.

        Returns
        -------
        xarray.DataTree
            groups `rigid`, `flexible` and `iterations`, in SI units; the attributes are texts and numbers

        Raises
        ------
        ImportError
            where xarray is not installed; it comes with `flexbearing[studies]`
        """
        from flexbearing.results.labelled import labelled

        groups = {**self._different_blocks, ITERATIONS: self.stacked}
        simple = {name: each for name, each in self.attributes.items() if isinstance(each, str | int | float)}
        return labelled(self.family.layout(), groups, simple)

    def summary(self) -> dict[str, Any]:
        """Numbers of the run as one object that JSON can hold; a name carries its unit."""
        return summary(self.family.layout(), self.attributes, self._blocks)

    @property
    def stacked(self) -> Arrays:
        """Every dataset of the iterations, stacked over them; empty without any."""
        names = self.iterations[0] if self.iterations else ()
        return {name: np.stack([state[name] for state in self.iterations]) for name in names}

    def history(self, name: str) -> np.ndarray:
        """Stack a dataset over the iterations.

        Parameters
        ----------
        name : str
            a dataset of the iterations, such as ``load_change``

        Returns
        -------
        array (iterations, ...)
            stacked; without iterations, an array of length 0

        Raises
        ------
        NotInLayout
            for a name that iterations do not have
        """
        known = self.family.layout().datasets("iteration")
        if name not in known:
            require_same_names({**dict.fromkeys(known), name: None}, known, "history")
        if not self.iterations:
            return np.empty(0)
        return np.stack([state[name] for state in self.iterations])


def _timeless(record: Any) -> Any:
    """A record without times and without what only files have, at any depth."""
    if isinstance(record, Mapping):
        return {name: _timeless(item) for name, item in record.items() if name not in TIMES + OF_FILES}
    return [_timeless(item) for item in record] if isinstance(record, list) else record


def _same(one: Arrays, other: Arrays) -> bool:
    """Whether two groups hold the same numbers, but for times."""
    return one.keys() == other.keys() and all(
        np.array_equal(one[name], other[name], equal_nan=True) for name in one if name not in TIMES
    )


def _restored(
    path: Path | None, attributes: dict[str, Any], arrays: list[dict[str, np.ndarray]], family: Family
) -> Result:
    """A result that was pickled; its arrays cannot change either."""
    for array in (array for group in arrays for array in group.values()):
        array.flags.writeable = False
    rigid, flexible, *iterations = map(MappingProxyType, arrays)
    return Result(
        path=path,
        attributes=MappingProxyType(attributes),
        rigid=rigid,
        flexible=flexible,
        iterations=tuple(iterations),
        family=family,
    )
