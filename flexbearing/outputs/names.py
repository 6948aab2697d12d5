"""The names of scalar outputs: what there is, and the number behind a name."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from functools import lru_cache
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.outputs.value import Conversion, Value, WrongUnit, conversion, quoted
from flexbearing.quantities import Quantity, SummaryValue
from flexbearing.quantities.layout import FIXED, Layout
from flexbearing.quantities.quantity import unchanged, with_defaults

Block = Mapping[str, NDArray]  # the arrays of an end state, in SI units
ROLLER, PROBE = "roller", "probe"  # dimensions of arrays
BLOCKS = ("flexible", "rigid")  # a bare name means the first of them that there is
_WANTED = re.compile(r"\s*(?:(?P<block>rigid|flexible)\.)?(?P<name>[\w.]+)\s*(?:\[(?P<unit>[^]]*)\]\s*)?")
_OF_ONE = re.compile(r"(?P<quantity>\w+)\.(?P<number>[1-9][0-9]{0,3})")
_PLAIN = "1"  # the unit of plain numbers


class UnknownOutput(ValueError):
    """A name that no output has; the message says the nearest one and where all are listed."""


class AbsentOutput(ValueError):
    """An output that a result does not have; the message says why."""


@dataclass(frozen=True)
class Output:
    """A scalar of an end state."""

    name: str  # "max_roller_load", "peak_pressure.inner"
    unit: str  # of the summary; "1" for plain numbers
    meaning: str
    declared: SummaryValue  # with its quantities and unit
    place: tuple[int, ...]  # among the numbers of its reduction

    @property
    def key(self) -> str:
        """Its name in the summary, with the unit: "peak_pressure_MPa.inner"."""
        named = filter(None, (self.declared.parts, self.declared.entries))
        return ".".join([self.declared.key, *(names[n] for names, n in zip(named, self.place, strict=True))])

    def is_beyond(self, block: Block) -> bool:
        """Whether the case has fewer rollers or probes."""
        one_of_many = self.declared.reduction is unchanged and self.place
        return bool(one_of_many) and self.place[-1] >= block[self.declared.of[0]].shape[-1]

    def numbers(self, block: Block) -> Any:
        """Its number in `unit`, an array (C) of a block of C cases; NaN where the case does not give it."""
        entry = self.declared
        if any(name not in block for name in entry.of) or self.is_beyond(block):
            return float("nan")
        arrays = [block[name] for name in entry.of]
        value = entry.reduction(*arrays)
        if self.place:
            value = value[(..., *self.place)]
        assert entry.unit is not None  # a layout fills it in
        return value if entry.in_si else value * entry.unit.scale

    def rounds_to_zero(self, number: float) -> bool:
        """Whether a number in `unit` is zero to the printed digit, so that no ratio to it says anything."""
        digits = self.declared.digits or ".4g"
        return not float(format(number, ".0f" if digits == "d" else digits).replace(",", ""))


@dataclass(frozen=True)
class RequestedOutput:
    """An output that was requested, with the block it is taken from and the unit it is given in."""

    output: Output
    block: str  # "rigid" or "flexible"; empty: flexible where there is such a block, else rigid
    unit: str
    conversion: Conversion

    @property
    def name(self) -> str:
        """As it was requested, without the unit."""
        return f"{self.block}.{self.output.name}" if self.block else self.output.name

    @property
    def estimated(self) -> bool:
        """Whether a target estimates its error; not of states between rigid raceways beside others."""
        declared = self.output.declared
        of_entry = not declared.error_of or self.output.name.rpartition(".")[2] in declared.error_of
        return bool(declared.error) and of_entry and self.block != "rigid"

    def error(self, estimates: Mapping[str, float | None], number: float) -> float:
        """Estimated error of its number in `unit`, by the names of `SummaryValue.error`; NaN without one."""
        declared = self.output.declared
        estimate = estimates.get(declared.error) if self.estimated else None
        if estimate is None:
            return float("nan")
        if declared.error_relative:
            return estimate * abs(number)
        scale = 1.0 if declared.in_si or declared.unit is None else declared.unit.scale
        return estimate * scale * self.conversion.factor

    def chosen(self, blocks: Mapping[str, Block]) -> Block:
        """The block that it is taken from; empty where there is none."""
        names = (self.block,) if self.block else BLOCKS
        return next((blocks[name] for name in names if blocks.get(name)), {})

    def number(self, blocks: Mapping[str, Block]) -> float:
        """Its number in `unit`, from the blocks `rigid` and `flexible` of a run; NaN where there is none."""
        return float(self.numbers(blocks))

    def numbers(self, blocks: Mapping[str, Block]) -> Any:
        """The same of blocks of C cases (C), or of one."""
        block = self.chosen(blocks)
        numbers = self.output.numbers(block) * self.conversion.factor
        if self.conversion.per_speed and self.output.declared.speed in block:
            with np.errstate(divide="ignore"):  # for ever, where nothing turns
                return numbers / np.abs(block[self.output.declared.speed])
        return numbers

    def value(self, blocks: Mapping[str, Block]) -> Value:
        """The same with its unit.

        Raises `AbsentOutput` where there is no such block, or the case does not give what it is computed
        from.
        """
        block = self.chosen(blocks)
        if not block:
            raise AbsentOutput(f"{self.name}: there is no {self.block or 'solved'} block.")
        if missing := [name for name in self.output.declared.of if name not in block]:
            raise AbsentOutput(f"{self.name}: the case does not give {missing[0]}.")
        if self.output.is_beyond(block):
            raise AbsentOutput(f"{self.name}: the case has fewer.")
        turning = self.output.declared.speed and not self.conversion.per_speed
        speed = float(block[self.output.declared.speed]) if turning else None
        return Value(self.number(blocks), self.unit, speed)


@lru_cache(maxsize=8)
def _by_name(layout: Layout) -> dict[str, Output]:
    axes = {entry.name: entry.shape for entry in layout.quantities}
    found: dict[str, Output] = {}
    for quantity in layout.quantities:
        for entry in with_defaults([quantity]):
            for output in _scalars(quantity, entry, axes):
                found[output.name] = output
    return found


def outputs(layout: Layout) -> tuple[Output, ...]:
    """List every scalar output of a kind of bearing."""
    return tuple(_by_name(layout).values())


def of_rollers(layout: Layout) -> Mapping[str, Quantity]:
    """Quantities with a number for every roller, by name; `requested` takes each, "inner_load.1"."""
    return numbered_by(layout, ROLLER)


def numbered_by(layout: Layout, dimension: str) -> Mapping[str, Quantity]:
    """Quantities with a number for every roller, or every probe, by name."""
    symbols = {axis.symbol for axis in layout.axes if axis.name == dimension}
    return {entry.name: entry for entry in layout.quantities if entry.axes in symbols}


def _of_one(layout: Layout, name: str) -> Output | None:
    """The number of one roller or probe, counted from 1."""
    parts = _OF_ONE.fullmatch(name)
    numbered = {**numbered_by(layout, ROLLER), **numbered_by(layout, PROBE)}
    quantity = numbered.get(parts["quantity"]) if parts else None
    if parts is None or quantity is None:
        return None
    unit, place = quantity.unit_for_people, (int(parts["number"]) - 1,)
    declared = SummaryValue(name, of=(quantity.name,), unit=unit)
    return Output(name, unit.name or _PLAIN, quantity.meaning, declared, place)


@lru_cache(maxsize=1024)
def requested(layout: Layout, text: str) -> RequestedOutput:
    """Understand a name with block and unit.

    Raises `UnknownOutput` for another name, with the nearest one, the main ones and where all are listed;
    `WrongUnit` for a unit that cannot be read or is of another kind, with those that are allowed.
    """
    known = _by_name(layout)
    parts = _WANTED.fullmatch(text)
    name = parts["name"] if parts else text[:100]  # the nearest name takes time with its length
    output = known.get(name) or _of_one(layout, name)
    if parts is None or output is None:
        near = get_close_matches(name, known, n=1, cutoff=0.4)
        hint = f" Did you mean {near[0]}?" if near else ""
        raise UnknownOutput(
            f"{quoted(text)}: no output has this name.{hint} The main ones are {', '.join(layout.main)}; "
            'the documents list all under "The result file".'
        )
    unit = output.unit if parts["unit"] is None else parts["unit"].strip()
    try:
        way = conversion(output.unit, unit, turning=bool(output.declared.speed))
    except WrongUnit as problem:
        raise WrongUnit(f"{quoted(text)}: {problem}") from None
    return RequestedOutput(output, parts["block"] or "", unit, way)


def _scalars(
    quantity: Quantity, entry: SummaryValue, axes: Mapping[str, tuple[str, ...]]
) -> Iterator[Output]:
    """The scalars of a value of the summary: itself, or its parts and entries; none of a list."""
    named = [names for names in (entry.parts, entry.entries) if names]
    if np.shape(_trial(entry, axes)) != tuple(map(len, named)):
        return
    unit = _unit(quantity, entry)
    name = re.sub(rf"_{re.escape(_spelt(unit))}(?=\.|$)", "", entry.key, count=1)
    meaning = quantity.meaning if entry.reduction is unchanged else entry.label.strip() or quantity.meaning
    for place in product(*(range(len(names)) for names in named)):
        words = [names[number] for names, number in zip(named, place, strict=True)]
        yield Output(".".join([name, *words]), unit, ", ".join([meaning, *words]), entry, place)


def _trial(entry: SummaryValue, axes: Mapping[str, tuple[str, ...]]) -> Any:
    """The reduction of arrays of ones, whose shape distinguishes a number from a list."""
    lengths = {axis: len(fixed.entries) for axis, fixed in FIXED.items()}
    return entry.reduction(*(np.ones([lengths.get(axis, 3) for axis in axes[name]]) for name in entry.of))


def _unit(quantity: Quantity, entry: SummaryValue) -> str:
    """The one unit of a value; of several, "N, N m", the one that its key names."""
    assert entry.unit is not None  # a layout fills it in
    units = (quantity.unit if entry.in_si else entry.unit.name).split(", ")
    spelt = [unit for unit in units if re.search(rf"_{re.escape(_spelt(unit))}(\.|$)", entry.key)]
    return (spelt or units)[0] or _PLAIN


def _spelt(unit: str) -> str:
    """A unit as keys of the summary write it, "N_per_m"."""
    return unit.replace("%", "percent").replace("/", "_per_").replace(" ", "")
