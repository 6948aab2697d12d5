"""What the result file of one bearing family holds, and what its summary repeats."""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

from flexbearing.quantities.attributes import COMMON, HEAD, Attribute
from flexbearing.quantities.forms import TEXT, Anything, Record
from flexbearing.quantities.quantity import Quantity, SummaryValue, with_defaults
from flexbearing.quantities.reductions import RACES, ROWS, XYZ, YZ


@dataclass(frozen=True)
class Axis:
    """An axis of arrays."""

    symbol: str  # in `Quantity.axes`
    name: str  # of the dimension: "roller"
    entries: tuple[str, ...] = ()  # what stands along it; empty where the case decides how many there are
    coordinate: str = ""  # quantity of a block with the places along it, "roller_azimuth"


_DIRECTIONS = (*XYZ, "about y", "about z")
FIXED = {  # of every kind of bearing, by symbol
    name: Axis(name, name, entries)
    for name, entries in {
        "race": RACES,
        "transverse": YZ,
        "slope": ("dz/dx", "dy/dx"),
        "radial_force": YZ,
        "force": _DIRECTIONS,
        "row": ROWS,
        "row_force": XYZ,
        "displacement": _DIRECTIONS,
        "part": ("outwards", "along"),
        "bar_end": ("ring", "flange"),
        "roller_end": ("-x", "+x"),
        "circle": ("inner raceway", "roller centres", "outer raceway"),
        "turning": ("outer ring", "ball about x", "ball about radius"),
    }.items()
}
ITERATION = Axis("iteration", "iteration")


@dataclass(frozen=True, kw_only=True, eq=False)  # one of each family: comparing them would take time
class Layout:
    """Quantities, blocks and root attributes of one family of bearings."""

    conventions: str  # directions, for the reference
    axes: tuple[Axis, ...] = ()  # beside those that every kind of bearing has
    quantities: tuple[Quantity, ...]
    blocks: tuple[str, ...]  # that a converged run has
    further_blocks: tuple[str, ...] = ()  # that only some cases have
    further_attributes: tuple[Attribute, ...] = ()  # beside the common ones
    main: tuple[str, ...] = ()  # outputs that a result is known by, five at most
    weighed: tuple[
        tuple[str, str], ...
    ] = ()  # outputs beside lives that effects of inputs are computed for, and their words
    weighed_in_results: tuple[tuple[str, str], ...] = ()  # further ones, not among the main results of a page
    head: tuple[str, ...] = HEAD  # root attributes that the summary repeats
    case_keys: tuple[
        tuple[str, str, str], ...
    ] = ()  # key in the block, section and key of a text of the case

    def datasets(self, place: Literal["iteration", "block"]) -> dict[str, Quantity]:
        """Quantities of an iteration or of a block, by name."""
        return self._datasets[place]

    @cached_property
    def _datasets(self) -> dict[str, dict[str, Quantity]]:
        places = ("iteration", "block")
        return {
            place: {entry.name: entry for entry in self.quantities if entry.place in ("state", place)}
            for place in places
        }

    @cached_property
    def attributes(self) -> dict[str, Attribute]:
        """Root attributes, by name; the case has the keys that the summary repeats."""
        entries = {entry.name: entry for entry in (*COMMON, *self.further_attributes)}
        for _, table, key in self.case_keys:
            having = Record({table: Record({key: TEXT}, further=Anything())}, further=Anything())
            entries["case_si"] = replace(entries["case_si"], form=having)
        return entries

    @cached_property
    def axis(self) -> dict[str, Axis]:
        """Every axis by its symbol."""
        return {axis.symbol: axis for axis in (ITERATION, *self.axes, *FIXED.values())}

    @cached_property
    def summary(self) -> tuple[SummaryValue, ...]:
        """Values of the summary, with their quantities and units."""
        return with_defaults(self.quantities)

    def __getitem__(self, name: str) -> Quantity:
        return self.datasets("block").get(name) or self.datasets("iteration")[name]
