"""An output quantity: what it is, where the solved model holds it, and how people see it."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import KW_ONLY, dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

Place = Literal["state", "iteration", "block"]


@dataclass(frozen=True)
class Unit:
    """A unit that people read."""

    name: str  # empty for plain numbers
    scale: float = 1.0  # of a value in SI units to this unit


def unchanged(values: np.ndarray) -> np.ndarray:
    """The values themselves."""
    return values


@dataclass(frozen=True)
class SummaryValue:
    """A number or a list of the summary, and its row on the page if it has one."""

    key: str  # in the block of the summary, with its unit; "losses_W.drag" is drag in the object losses_W
    reduction: Callable[..., Any] = unchanged  # of the arrays of the quantities named in `of`
    label: str = ""  # of its row on the page; empty: in the JSON summary only
    digits: str = ""  # format specification of its row
    _: KW_ONLY
    of: tuple[str, ...] = ()  # quantities it is computed from; empty: the one it is declared with
    unit: Unit | None = None  # None: that of the quantity
    in_si: bool = False  # the summary holds it in SI units, its row in the unit for people
    parts: tuple[str, ...] = ()  # names of its entries, such as inner and outer
    entries: tuple[str, ...] = ()  # names of the numbers of a short list, such as y and z, or that of a part
    speed: str = ""  # quantity by which its revolutions become a time
    section: str = ""  # of the page
    compared: bool = True  # whether its change from block to block means something
    error: str = ""  # name of its estimated numerical error in the attribute error_estimate
    error_relative: bool = True  # the estimate is over the value
    error_of: tuple[str, ...] = ()  # those of its entries that have this error; empty: all


@dataclass(frozen=True)
class Quantity:
    """An output quantity of the model, and a dataset of the result file."""

    name: str
    symbol: str  # as in the theory pages; empty where those have none
    axes: str  # symbols of its axes by spaces, "Z K" or "race"; empty for a scalar
    unit: str  # SI
    place: Place  # "state": in iterations and blocks; else only there
    meaning: str  # with its sign
    _: KW_ONLY
    source: str = ""  # solved part and attribute that hold it, "state.loads.0"; empty: "state.<name>"
    people: Unit | None = None  # the unit for people; None: the SI unit
    summary: tuple[SummaryValue, ...] = ()
    optional: bool = False  # absent where the case does not give what it needs
    infinite: bool = False  # may hold infinities also in a solution
    gaps: bool = False  # may hold NaN also in a solution, where its meaning says so

    @cached_property
    def shape(self) -> tuple[str, ...]:
        """Axes one by one, ``("Z", "K")``."""
        return tuple(self.axes.split())

    @cached_property
    def path(self) -> tuple[str | int, ...]:
        """The words of `source`, indices among them as numbers."""
        words = (self.source or f"state.{self.name}").split(".")
        return tuple(int(word) if word.isdigit() else word for word in words)

    @property
    def unit_for_people(self) -> Unit:
        """Unit of tables and pictures."""
        return self.people or Unit("" if self.unit == "1" else self.unit)

    @property
    def axis_label(self) -> str:
        """Name and unit for people, "cage slip [%]"."""
        unit = self.unit_for_people.name
        return self.name.replace("_", " ") + (f" [{unit}]" if unit else "")

    def for_people(self, values: Any) -> Any:
        """Values in the unit for people, from SI units."""
        return values * self.unit_for_people.scale


def with_defaults(quantities: Iterable[Quantity]) -> tuple[SummaryValue, ...]:
    """Every value of the summary in the order of declaration, its quantity's name and unit filled in."""
    return tuple(
        replace(value, of=value.of or (entry.name,), unit=value.unit or entry.unit_for_people)
        for entry in quantities
        for value in entry.summary
    )


def taken(quantities: Iterable[Quantity], solved: Mapping[str, Any]) -> dict[str, np.ndarray]:
    """Take quantities of C cases from the solved parts of their models, as their `source` says.

    Raises `AttributeError` if a part does not have the attribute that a source names.
    """
    values = {entry.name: _of_cases(entry.path, solved.get(str(entry.path[0]))) for entry in quantities}
    return {name: np.asarray(value, dtype=float) for name, value in values.items() if value is not None}


def row(table: Mapping[str, np.ndarray], case: int) -> dict[str, np.ndarray]:
    """The quantities of one of the cases."""
    return {name: values[case] for name, values in table.items()}


def _of_cases(path: tuple[str | int, ...], part: Any) -> Any:
    """The value of all cases at a source."""
    if not isinstance(part, list):
        return _followed(path, part, cases=True)
    each = [_followed(path, one, cases=False) for one in part]
    known = [np.asarray(value, dtype=float) for value in each if value is not None]
    if len(known) == len(each):
        return np.array(known)
    return np.array([np.full_like(known[0], np.nan) if v is None else v for v in each]) if known else None


def _followed(path: tuple[str | int, ...], part: Any, *, cases: bool) -> Any:
    """The value at a source: attributes, names of a mapping, numbers as indices, methods called."""
    value: Any = part
    for word in path[1:]:
        if value is None:
            return None
        if isinstance(word, int):
            value = value[:, word] if cases else value[word]
        else:
            value = value[word] if isinstance(value, Mapping) else getattr(value, word)
        value = value() if callable(value) else value
    return value
