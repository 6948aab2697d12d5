"""What may be kept on disk: every class, with the form of each of its fields.

A file names a class by its place in this table; nothing else is ever imported, called or made.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from importlib import import_module
from math import isfinite, isnan, prod
from typing import Any

import numpy as np

FORCE = 1e3  # [N/N] or [N m/N]: of a bar per roller force
GROWTH = 1000.0  # [m] per strain: a radius is below
HALF_TURN = 3.15  # [rad]
METRE = 1.0  # [m/N] or [m]: no raceway gives way by a metre, at a newton or before it is loaded


class WrongForm(ValueError):
    """A value that is not as the table has it."""


@dataclass(frozen=True)
class Number:
    """A number, not NaN."""

    infinite: bool = False  # may be inf
    optional: bool = False  # may be None

    def problem(self, value: Any, sizes: dict[str, int]) -> str:
        """What a value of another form is; empty for one of this form, as in all other forms."""
        known = type(value) in (int, float) and not isnan(value) and (isfinite(value) or self.infinite)
        return "" if known else f"{value!r} is no number"


@dataclass(frozen=True)
class Count:
    """A whole number, zero or more."""

    optional: bool = False  # may be None

    def problem(self, value: Any, sizes: dict[str, int]) -> str:
        """What it is else."""
        return "" if type(value) is int and 0 <= value < 2**63 else f"{value!r} is no count"


@dataclass(frozen=True)
class Choice:
    """One of some texts, numbers or flags."""

    allowed: tuple[str | int | bool, ...]
    optional: bool = False  # may be None

    def problem(self, value: Any, sizes: dict[str, int]) -> str:
        """What it is else."""
        known = any(type(value) is type(each) and value == each for each in self.allowed)
        return "" if known else f"{value!r} is none of {self.allowed}"


@dataclass(frozen=True)
class Numbers:
    """Numbers by name."""

    optional: bool = False  # may be None

    def problem(self, value: Any, sizes: dict[str, int]) -> str:
        """What it is else, or the first of it that is no number."""
        if not isinstance(value, dict) or not all(isinstance(name, str) for name in value):
            return f"a {type(value).__name__} is no mapping of names"
        return next(filter(None, (Number().problem(number, sizes) for number in value.values())), "")


@dataclass(frozen=True)
class Array:
    """Finite numbers along axes: each a size, or a symbol that has one size in the whole object."""

    axes: tuple[str, ...]  # one form after the other, "Z M Z M"
    kinds: str = "f"  # of the dtype
    largest: float = METRE  # size of a number
    optional: bool = False  # may be None

    def problem(self, value: Any, sizes: dict[str, int]) -> str:
        """What it is else; `sizes` learns those of the symbols."""
        if not isinstance(value, np.ndarray) or value.dtype.kind not in self.kinds:
            return f"a {type(value).__name__} is no array of {self.kinds}"
        forms = [form.split() for form in self.axes]
        form = next((form for form in forms if _fits(form, value.shape, sizes)), None)
        if form is None:
            return f"shape {value.shape} is none of {self.axes} with {sizes}"
        sizes.update(zip(form, value.shape, strict=True))
        known = np.abs(value).max() <= self.largest  # NaN is not, either
        return "" if known else f"a number is above {self.largest:g}, or none"


@dataclass(frozen=True)
class Kept:
    """An object of a class of the table."""

    name: str
    optional: bool = False  # may be None

    def problem(self, value: Any, sizes: dict[str, int]) -> str:
        """What it is else, or which field of it is not of its form."""
        record, kind = RECORDS.get(self.name), type(value)
        if record is None or (kind.__module__, kind.__qualname__) != (record.module, self.name):
            return f"{kind.__module__}.{kind.__qualname__} is no {self.name}"
        return _of_fields(self.name, {field: plain(getattr(value, field)) for field in record.fields})


Form = Number | Count | Choice | Numbers | Array | Kept


@dataclass(frozen=True)
class Record:
    """Where a class is defined, and its fields."""

    module: str
    fields: Mapping[str, Form]

    def made(self, name: str, values: Mapping[str, Any]) -> Any:
        """An object of the class; its own checks may refuse the values."""
        return getattr(import_module(self.module), name)(**values)


RECORDS = {
    "RacewayCompliance": Record(
        "fem.raceway.compliance",
        {
            "azimuths": Array(("Z",), largest=1e3),
            "absolute": Array(("Z M Z M",)),
            "translation": Array(("2 Z M",)),
            "support_stiffness": Number(infinite=True),
            "unknowns": Count(),
            "elements": Count(),
            "seconds": Numbers(),
            "initial_deviation": Array(("Z M",)),
            "initial_translation": Array(("2",)),
            "support_error": Number(optional=True),
            "bar_response": Kept("BarResponse", optional=True),
        },
    ),
    "HarmonicCompliance": Record(
        "fem.raceway.harmonics",
        {
            "harmonics": Array(("K",), "i", largest=1e6),
            "response": Array(("K M K M", "K M M"), "fc"),
            "radius": Number(),
            "length": Number(),
            "elastic": Kept("Elastic"),
            "bars": Count(optional=True),
            "unknowns": Count(),
            "elements": Count(),
            "seconds": Numbers(),
            "support_error": Number(optional=True),
            "bar_response": Kept("BarResponse", optional=True),
            "short_waves": Array(("S M M",), optional=True),
            "rows": Count(),
            "taper": Number(),
            "along": Choice((False, True)),
        },
    ),
    "BarResponse": Record(
        "fem.raceway.bar_response",
        {
            "bars": Count(),
            "response": Array(("K M 6", "K M 12"), largest=FORCE),
            "neighbour": Array(("K M 6", "K M 12"), largest=FORCE, optional=True),
        },
    ),
    "RacewayGrowth": Record(
        "fem.raceway.growth",
        {"coefficients": Array(("K M",), largest=GROWTH), "bars": Count(optional=True)},
    ),
    "RingOnFoundation": Record(
        "fem.section.ring_on_foundation",
        {
            "raceway": Kept("HarmonicCompliance"),
            "face": Array(("N A A",)),
            "through": Array(("N A M",)),
            "x": Array(("A",), largest=1e3),
            "area": Array(("A",), largest=1e6),
            "radial": Number(),
        },
    ),
    "BondedGrowth": Record(
        "fem.raceway.growth",
        {"by_heat": Array(("2 M",), largest=GROWTH), "by_rotation": Array(("2 M",), largest=GROWTH)},
    ),
    "GrooveCompliance": Record(
        "fem.raceway.stations",
        {
            "groove": Kept("Groove"),
            "outward": Choice((1, -1)),
            "angles": Array(("K",), largest=HALF_TURN),
            "width": Number(),
            "response": Array(("N S S",)),
            "elastic": Kept("Elastic"),
            "unknowns": Count(),
            "elements": Count(),
            "seconds": Numbers(),
            "coupled": Array(("H S H S",), "c", optional=True),
        },
    ),
    "FreeRing": Record(
        "fem.section.free_ring",
        {
            "raceway": Kept("GrooveCompliance"),
            "lines": Kept("HarmonicCompliance"),
            "radial": Array(("N K 2",)),
            "tangential": Array(("N K",)),
            "axial": Array(("N K",), optional=True),
            "reading": Array(("L 2",), largest=10.0),
        },
    ),
    "Groove": Record(
        "fem.parts.groove", {name: Number() for name in ("radius", "centre_radius", "aside", "place")}
    ),
    "Elastic": Record("fem.parts.material", {"youngs_modulus": Number(), "poisson_ratio": Number()}),
}


def require_form(name: str, value: Any) -> None:
    """Raise unless an object is of a class of the table, and each of its fields of its form.

    Raises `WrongForm` naming class and field.
    """
    if problem := Kept(name).problem(value, {}):
        raise WrongForm(problem)


def require_fields(name: str, values: Mapping[str, Any]) -> None:
    """Raise unless the fields of a class are there and of their forms.

    Raises `WrongForm` naming class and field.
    """
    if problem := _of_fields(name, values):
        raise WrongForm(problem)


def _of_fields(name: str, values: Mapping[str, Any]) -> str:
    """The first field of a class that is not of its form; empty where all are."""
    fields, sizes = RECORDS[name].fields, {}
    if values.keys() != fields.keys():
        return f"{name} has the fields {', '.join(fields)}, not {', '.join(values)}"
    for field, form in fields.items():
        value = values[field]
        if not (value is None and form.optional) and (problem := form.problem(value, sizes)):
            return f"{name}.{field}: {problem}"
    return ""


def plain(value: Any) -> Any:
    """Python's own number for one of NumPy."""
    return value.item() if isinstance(value, np.generic) else value


def _fits(form: list[str], shape: tuple[int, ...], sizes: dict[str, int]) -> bool:
    """Whether a shape is one of a form, with the sizes known so far; empty arrays fit none."""
    if len(form) != len(shape) or not prod(shape):
        return False
    new: dict[str, int] = {}
    for axis, size in zip(form, shape, strict=True):
        wanted = int(axis) if axis.isdigit() else sizes.get(axis, new.get(axis, size))
        if size != wanted:
            return False
        new[axis] = size
    return True
