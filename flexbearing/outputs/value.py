"""A number with its unit, and the way from one unit to another."""

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import pi
from reprlib import Repr

import numpy as np
from numpy.typing import NDArray

from flexbearing.units import BadUnit, Unit, UnknownUnit, alike, unit

TIME, TURN = unit("s").powers, unit("rad").powers
_SHORT = Repr()
_SHORT.maxstring = 100
quoted = _SHORT.repr  # of a text of any length, in messages


class WrongUnit(ValueError):
    """A unit that is none, or of another kind than the number; the message says what is allowed."""


@dataclass(frozen=True)
class Conversion:
    """Number in the new unit = number times factor, where `per_speed` over the speed in rad/s."""

    factor: float
    per_speed: bool = False  # revolutions become a time


@lru_cache(maxsize=1024)
def conversion(given: str, new: str, *, turning: bool = False) -> Conversion:
    """Find the way from one unit to another.

    Raises `WrongUnit` for a unit that cannot be read, or of another kind.

    >>> conversion("Mrev", "h", turning=True)
    Conversion(factor=1745.3292519943295, per_speed=True)
    """
    there = unit(given)
    try:
        here = unit(new)
    except (UnknownUnit, BadUnit):
        raise WrongUnit(f"{quoted(new)} is no unit; {_allowed(there, given, turning)}") from None
    per_speed = turning and there.powers == TURN and here.powers == TIME
    if here.offset or (here.powers != there.powers and not per_speed):
        raise WrongUnit(
            f"{quoted(new)} is a unit of another kind than {given!r}; {_allowed(there, given, turning)}"
        )
    pi_power = there.pi_power - here.pi_power
    return Conversion(float(there.factor / here.factor * Fraction(pi) ** pi_power), per_speed)


def _allowed(there: Unit, given: str, turning: bool) -> str:
    """Units that a number may have, for a message."""
    names = dict.fromkeys([given, *alike(there), *(("h", "min", "s") if turning else ())])
    return f"allowed is {', '.join(names)} or another unit of that kind."


@dataclass(frozen=True, eq=False)
class Value:
    """A number, or an array of numbers, with its unit.

    >>> Value(20e3, "N").to("kN")
    20 kN
    """

    number: float | NDArray
    unit: str  # "1" for plain numbers
    speed: float | NDArray | None = (
        None  # [rad/s] of the rings to each other, by which revolutions become a time
    )

    def to(self, unit: str) -> "Value":
        """The same in another unit; raises `WrongUnit` for a unit that cannot be read, or of another kind."""
        way = conversion(self.unit, unit, turning=self.speed is not None)
        number = self.number * way.factor
        if way.per_speed and self.speed is not None:
            with np.errstate(divide="ignore"):
                number = number / np.abs(np.asarray(self.speed))
        return Value(number, unit, None if way.per_speed else self.speed)

    def __float__(self) -> float:
        return float(self.number)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Value):
            return NotImplemented
        return self.unit == other.unit and np.array_equal(self.number, other.number, equal_nan=True)

    def __hash__(self) -> int:
        return hash((self.unit, np.asarray(self.number).tobytes()))

    def __repr__(self) -> str:
        number = (
            format(self.number, ".6g")
            if np.ndim(self.number) == 0
            else np.array2string(np.asarray(self.number))
        )
        return number if self.unit == "1" else f"{number} {self.unit}"
