"""Keys of a case with their values, and colours of parts, as drawings have them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property
from math import degrees, pi
from typing import Any

from numpy.typing import NDArray

from flexbearing.case.declarations import Declaration, by_path

OUTER, INNER, ELEMENT, SHAFT, HOUSING, CAGE = "#c9d9ea", "#d5e6cf", "#f4f1e6", "#eadfcb", "#e3e3e3", "#f3d9b1"
AXES, LOAD, TURNING = "#0b5394", "#a61c00", "#38761d"  # lines: axes, loads, sense of rotation
SCHEMATIC: dict[str, Any] = {"ls": (0, (4, 2)), "lw": 0.6, "ec": "0.35"}
RIGID_WIDTH, RIGID_WALL = 1.6, 0.5  # of a ring that the case does not describe, over roller length, diameter

ASSUMED, CALIBRATED = "*", "†"
MARKS = {ASSUMED: "assumed", CALIBRATED: "fitted"}
SMALL = 1e-4  # [m] lengths below are written in micrometres
MOST_VALUES = 4  # of a list that are written
UNITS = {"N": (1e-3, "kN"), "rad/s": (30 / pi, "rpm"), "N/m^3": (1e-9, "N/mm³"), "1": (1.0, "")}


@dataclass(frozen=True)
class Words:
    """What a drawing says of the keys of a case."""

    case: Any  # a `flexbearing.case.head.Head`
    values: bool = True  # whether values are beside the keys
    profiles: Callable[[Any], Mapping[str, tuple[NDArray, NDArray]]] | None = None  # of a `Family`
    names: Callable[[str], str] | None = None  # of keys on a page, which shows drawings in any size

    @cached_property
    def _declared(self) -> dict[str, Declaration]:
        return by_path(type(self.case))

    def value(self, path: str) -> Any:
        """Value of a key in SI units; None where it, or a table above it, is not given."""
        value: Any = self.case
        for name in path.split("."):
            value = getattr(value, name, None)
        return value

    def __call__(self, path: str, sign: str = "") -> str:
        """Write "key = value", or "name value", with a sign before the value, and a mark of its origin.

        Without values it is the sign and the key.
        """
        if not self.values:
            return f"{sign}{path}"
        declaration, value = self._declared.get(path), self.value(path)
        unit = declaration.kind.unit if declaration and declaration.kind else ""
        name = self.names(path) if self.names else f"{path} ="
        return f"{name} {sign}{_printed(value, unit)}{self._mark(path)}"

    def _mark(self, path: str) -> str:
        parts = path.split(".")
        above = {".".join(parts[:count]) for count in range(1, len(parts) + 1)}
        if above & set(self.case.calibrated):
            return f" {CALIBRATED}"
        return f" {ASSUMED}" if above & set(self.case.assumed) else ""


def _printed(value: Any, unit: str) -> str:
    """A value as a drawing writes it, lengths in mm or um, angles in degrees."""
    if isinstance(value, str) or value is None:
        return f'"{value}"'
    if isinstance(value, tuple):
        few = len(value) <= MOST_VALUES
        return "; ".join(_printed(each, unit) for each in value) if few else f"{len(value)} values"
    if unit == "m":
        return f"{value * 1e6:.6g} µm" if 0 < abs(value) < SMALL else f"{value * 1e3:.7g} mm"
    if unit == "rad":
        return f"{degrees(value):.6g}°"
    factor, printed = UNITS.get(unit, (1.0, unit))
    return f"{value * factor:.6g} {printed}".rstrip()
