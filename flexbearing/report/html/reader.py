"""Numbers of a result in the units of a report, each with its place in the file."""

import tomllib
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, wraps
from pathlib import Path
from typing import Any, Concatenate, ParamSpec, TypeVar

import numpy as np

from flexbearing.case import understood
from flexbearing.case.declarations import toml
from flexbearing.findings import Record, stored
from flexbearing.printable import all_printable
from flexbearing.quantities import SummaryValue, Unit
from flexbearing.quantities.effects import Effects, effects
from flexbearing.quantities.layout import Layout
from flexbearing.quantities.life_records import FactoredLife, factored_lives
from flexbearing.report.html.document import Number
from flexbearing.report.html.units import Units, converted, units_in_words
from flexbearing.results import BadResult, Result

_LABELS = {  # of labels that do not name a method or a part, by whose capacities its life is of
    ("life L10", True): "basic life L10, Lundberg and Palmgren",
    ("life L10", False): "reference life L10r of the raceway",
    ("loaded share of that roller", True): "loaded share of the length of the most pressed roller",
}
P = ParamSpec("P")
T = TypeVar("T")


@dataclass(frozen=True)
class Reader:
    """A result, as a report requires it."""

    result: Result
    units: Units

    @cached_property
    def layout(self) -> Layout:
        """Declarations of its quantities."""
        return self.result.family.layout()

    @cached_property
    def summary(self) -> dict[str, Any]:
        """Its summary."""
        return all_printable(self.result.summary())

    @cached_property
    def attributes(self) -> dict[str, Any]:
        """Its root attributes."""
        return all_printable(dict(self.result.attributes))

    @cached_property
    def blocks(self) -> dict[str, Mapping[str, np.ndarray]]:
        """End states by name; where nothing is flexible, the flexible one is the rigid one and left out."""
        named = {"rigid": self.result.rigid, "flexible": self.result.flexible}
        solved = {name: block for name, block in named.items() if block}
        repeated = len(solved) == 2 and "structure" in self.attributes and not self.attributes["structure"]
        return {"rigid": solved["rigid"]} if repeated else solved

    @cached_property
    def known(self) -> dict[Any, Any]:
        """Answers of functions that are asked in many places of a page, see `once`."""
        return {}

    @cached_property
    def written(self) -> dict[str, str]:
        """Keys of the case file and the settings on top of it, each as it was written.

        Raises `BadResult` where the stored case is no TOML.
        """
        try:
            case = tomllib.loads(self.result.attributes["case_text"])
        except (tomllib.TOMLDecodeError, RecursionError) as problem:
            raise BadResult(f"{self.result.place}: the case in it is no TOML: {problem}") from problem
        texts = {path: toml(value).strip('"') for path, value in flat(case)}
        for setting in self.attributes["case_overrides"]:
            path, _, value = setting.partition("=")
            texts[path.strip()] = value.strip()
        return texts

    @property
    def case_name(self) -> str:
        """Name of its case file without the folder; CASE.toml where it is not known."""
        return (self.attributes.get("case_file") or "CASE.toml").replace("\\", "/").rpartition("/")[2]

    @cached_property
    def bearing(self) -> Mapping[str, Any]:
        """Bearing of its case, in SI units; empty where the case has none."""
        return self.attributes["case_si"].get("bearing", {})

    @property
    def by_authors(self) -> bool:
        """Whether its life is of capacities of Lundberg and Palmgren, not of C_r."""
        return "capacity" in (self.attributes["case_si"].get("life") or {})

    @property
    def last(self) -> str:
        """The end state that answers the case; empty without any."""
        return next(reversed(self.blocks), "")

    @cached_property
    def case(self) -> Any:
        """Its case, read again; raises `BadCase` where this program refuses it."""
        return self.case_with(())

    def case_with(self, settings: Sequence[str]) -> Any:
        """Its case with further settings, "key=value"; raises `BadCase` where that is none."""
        family, about = self.result.family, self.result.attributes
        file = Path(about.get("case_file") or self.result.place)
        return understood(
            about["case_text"], file, [*about["case_overrides"], *settings], {family.kind: family}
        )

    @cached_property
    def findings(self) -> tuple[Record, ...]:
        """Its findings."""
        return stored(self.attributes)

    @cached_property
    def effects(self) -> Effects | None:
        """Effects of inputs that are not known; None where they were not computed."""
        stored = self.attributes.get("assumed_effects")
        return effects(stored) if stored else None

    @cached_property
    def lives(self) -> dict[str, FactoredLife]:
        """Its lives with their factors, by end state."""
        return factored_lives(self.attributes.get("life") or {})

    @property
    def clearance_words(self) -> str:
        """What the clearance of the result is: without temperatures it is that of parts equally warm."""
        found = self.attributes["clearance"]
        warm = not found["steps"] or self.attributes["case_si"]["operation"].get("temperatures")
        return "operating clearance" if warm else "clearance, mounted and turning, all parts equally warm"

    @cached_property
    def codes(self) -> set[str]:
        """Codes of its notes."""
        return {note["code"] for note in self.attributes["notes"]}

    def notes(self, grade: str) -> tuple[str, ...]:
        """Texts of the notes of a grade."""
        return tuple(
            units_in_words(note["text"]) for note in self.attributes["notes"] if note["grade"] == grade
        )

    def error_path(self, name: str) -> str:
        """Path among the attributes of an estimated error: by the target, else by slices; empty: none."""
        for estimate in ("error_estimate", "slice_error"):
            if name and (self.attributes.get(estimate) or {}).get(name) is not None:
                return f"{estimate}/{name}"
        return ""

    def declared(self, entry: SummaryValue, block: str, *place: str | int) -> Number:
        """A value of the summary, or one of its parts."""
        path = ["summary", block, *entry.key.split("."), *place]
        value: Any = self.summary[block]
        for step in path[2:]:
            value = None if value is None else value[step]
        unit = unit_of(entry).name
        stored = self.layout[entry.of[0]].unit if entry.in_si else unit
        return self.units.number(value, stored, unit, entry.digits or ".4g", "/".join(map(str, path)))

    def label(self, entry: SummaryValue) -> str:
        """Label of a value of the summary, lives with their method."""
        return _LABELS.get((entry.label.strip(), self.by_authors), entry.label)

    def output(self, name: str, unit: str, digits: str, block: str = "") -> Number:
        """A scalar output of the last end state, or another, in a unit of itself or of its revolutions."""
        asked = f"{block or self.last}.{name} [{unit}]"
        value = self.result[asked].number
        return self.units.number(float(value), unit, unit, digits, f"outputs/{asked}")

    def element(self, block: str, name: str, *index: int, digits: str = ".4g") -> Number:
        """An element of an array of an end state."""
        quantity = self.layout[name]
        value = float(self.blocks[block][name][index])
        of = "/".join(map(str, [block, name, *index]))
        return self.units.number(value, quantity.unit, quantity.unit_for_people.name, digits, of)

    def of_attribute(self, path: str, stored: str, people: str, digits: str) -> Number:
        """A number in a root attribute, at a path such as "clearance/steps/0/change_m"."""
        value: Any = self.attributes
        for step in path.split("/"):
            value = value[int(step)] if isinstance(value, list | tuple) else value[step]
        return self.units.number(value, stored, people, digits, f"attributes/{path}")

    def scalar(self, output: Any) -> Number:
        """A main output of the last end state."""
        unit = unit_of(output.declared).name
        si = self.layout[output.declared.of[0]].unit if output.declared.in_si else unit
        asked = f"{self.last}.{output.name}"
        shown = "kN/mm" if unit == "N/m" else unit
        value = float(self.result[asked].number)
        return self.units.number(value, si, shown, output.declared.digits or ",.4g", f"outputs/{asked}")

    def change(self, before: str, after: str) -> Number | str:
        """Change from one place of the summary to another in percent; empty where it means nothing."""
        one, other = self._at(before), self._at(after)
        if one is None or other is None or one == 0:
            return ""
        return self.units.number(100 * (other - one) / abs(one), "%", "%", "+.1f", f"change/{before}:{after}")

    def _at(self, path: str) -> Any:
        value: Any = self.summary
        for step in path.split("/")[1:]:
            value = None if value is None else value[int(step) if isinstance(value, list) else step]
        return value

    def drawn(
        self, block: str, name: str, index: tuple[Any, ...] = (), people: str = ""
    ) -> tuple[list[Any], str, str]:
        """Values of an array for a figure, None where there is no number, their unit and their place."""
        quantity = self.layout[name]
        shown = self.units.of(people or quantity.unit_for_people.name)
        array = self.blocks[block][name][index]
        values = converted(array, quantity.unit, shown)
        return (
            listed(values),
            shown,
            f"{block}/{name}" + "".join(f"/{'*' if isinstance(step, slice) else step}" for step in index),
        )


def flat(table: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Every value of nested tables by its dotted key."""
    for name, value in table.items():
        if isinstance(value, Mapping) and value:
            yield from flat(value, f"{prefix}{name}.")
        else:
            yield f"{prefix}{name}", value


def listed(values: np.ndarray) -> Any:
    """Lists of numbers with six digits, None for what is not finite."""
    if values.ndim == 0:
        return float(f"{values:.6g}") if np.isfinite(values) else None
    return [listed(value) for value in values]


def unit_of(entry: SummaryValue) -> Unit:
    """The unit of a value, which every layout fills in."""
    assert entry.unit is not None
    return entry.unit


def places(entry: SummaryValue) -> Iterator[tuple[str, tuple[str | int, ...]]]:
    """Words and steps to every number of a value of the summary: of its parts, and of their entries."""
    for part in entry.parts or ("",):
        for number, name in enumerate(entry.entries or ("",)):
            words = ", ".join(filter(None, [part, name]))
            yield words, (*([part] if part else []), *([number] if name else []))


def once(function: Callable[Concatenate[Reader, P], T]) -> Callable[Concatenate[Reader, P], T]:
    """Compute what a function finds in a reader once for all who ask; its arguments must be hashable."""

    @wraps(function)
    def known(reader: Reader, *arguments: P.args, **named: P.kwargs) -> T:
        asked = (function, arguments, tuple(named.items()))
        if asked not in reader.known:
            reader.known[asked] = function(reader, *arguments, **named)
        return reader.known[asked]

    return known
