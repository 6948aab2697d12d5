"""Quantities with units: text in the case file, a float in SI inside."""

import re
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, floor, isfinite, log10
from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, ConfigDict, Field, GetCoreSchemaHandler
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from flexbearing.printable import excerpt
from flexbearing.units import BadUnit, Unit, UnknownUnit, spelt_otherwise, unit

MOST_WORDS = 6  # of a unit for which another spelling is sought
LONGEST = 100  # characters of a quantity: a number with all its digits, a unit, and room between them
_NUMBER_UNIT = re.compile(r"\s*([+-]?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?)\s*(\S.*?)?\s*")
_THOUSANDS = re.compile(r"[+-]?[1-9][0-9]{0,2},[0-9]{3}")  # or a decimal comma
_POUND, _KILOGRAM, _WORD = re.compile(r"\blb\b"), re.compile(r"\bkg\b"), re.compile(r"[A-Za-zµμ°%]+")
SPEED, PER_MINUTE = "rad/s", unit("1/min")


@dataclass(frozen=True)
class Kind:
    """A physical quantity."""

    name: str  # with its article, "a length"
    unit: str  # SI
    example: str
    smallest: float  # [SI] size of a value that is not zero: what is beyond is a slip of the pen,
    largest: float  # and squares and products of it leave the range of numbers

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Let pydantic convert before it checks the limits of a key."""
        return core_schema.no_info_before_validator_function(self.to_si, handler(source))

    def to_si(self, value: object) -> float:
        """Convert "5 mm" to 0.005; a value that is not such a text is refused with a reason."""
        if isinstance(value, bool) or not isinstance(value, int | float | str):
            raise self._refused("is not text with a unit")
        if not isinstance(value, str):
            raise self._refused("has no unit")
        if len(value) > LONGEST:  # before any pattern is tried on it
            raise self._refused(f"is longer than {LONGEST} characters")
        return _read(self, value)

    def of_text(self, text: str) -> float:
        """Value of a text of bounded length in SI units; refused as by `to_si`."""
        number, unit = self.split(text)
        if unit is None:
            raise self._refused("has no unit")
        return self._of_size(self._unit(unit).to_si(number))

    def split(self, text: str) -> tuple[float, str | None]:
        """Number and unit of a text, with a point or a decimal comma."""
        parts = _NUMBER_UNIT.fullmatch(text)
        if parts is None:
            raise self._refused("does not begin with a number")
        number, unit = parts.groups()
        if _THOUSANDS.fullmatch(number):
            decimal, whole = number.replace(",", "."), number.replace(",", "")
            raise self._refused(f"has a comma; did you mean {decimal} or {whole}?")
        return float(number.replace(",", ".")), unit

    def _unit(self, text: str) -> Unit:
        """The unit of a quantity of this kind."""
        text = f"1 {text}" if text.startswith("/") else text
        try:
            given = unit(text)
        except UnknownUnit as problem:
            raise self._refused(f"has an unknown unit, {problem}{self._proposal(text)}") from None
        except BadUnit:
            raise self._refused(f"has a unit that cannot be read, {excerpt(text)}") from None
        if self.unit == SPEED and given.powers == PER_MINUTE.powers:
            given = self._turning(given)
        if given.powers == unit(self.unit).powers:
            return given
        if (pound := _POUND.sub("lbf", text)) != text:  # a force, where a mass has no meaning
            return self._unit(pound)
        raise self._refused(f"is not {self.name}{self._proposal(text)}")

    def _proposal(self, text: str) -> str:
        """A unit of this kind that differs in capitals, or in a force for a mass, as a question."""
        own, found = unit(self.unit).powers, _WORD.findall(text)
        if len(found) > MOST_WORDS:
            return ""
        words = (text.replace(word, other) for word in found for other in spelt_otherwise(word))
        for proposed in (*words, _KILOGRAM.sub("kgf", text)):
            with suppress(UnknownUnit, BadUnit):
                if unit(proposed).powers == own:
                    return f"; did you mean {proposed}?"
        return ""

    def _of_size(self, value: float) -> float:
        if not isfinite(value):
            raise self._refused("is beyond what numbers can hold")
        if value and not self.smallest <= abs(value) <= self.largest:
            raise self._refused(f"is not of a size from {self.sizes}")
        return value

    def written(self, value: float, like: str) -> str:
        """A value in SI units as a user writes it, rounded: in the unit of a text of this kind."""
        return f"{self.number(value, like):.6g} {self.unit_of(like)[0]}"

    def number(self, value: float, like: str) -> float:
        """A value in SI units in the unit of a text of this kind."""
        return self._unit_like(like)[1].of_si(value)

    def unit_of(self, like: str) -> tuple[str, float]:
        """Unit of a text of this kind, and its size in SI: that of a difference, for temperatures."""
        name, given = self._unit_like(like)
        return name, given.scale

    def _unit_like(self, like: str) -> tuple[str, Unit]:
        _, name = self.split(like)
        assert name
        return name, self._unit(name)

    @property
    def sizes(self) -> str:
        """What a value that is not zero may be, of either sign."""
        return f"{self.smallest:g} to {self.largest:g} {self.unit}"

    def _turning(self, given: Unit) -> Unit:
        """1/min is written of turns alone; 1/s and Hz also where radians are meant."""
        if given != PER_MINUTE:
            raise self._refused(f"is not {self.name}: turns or radians? Write rpm or rad/s")
        return unit("rpm")

    def _refused(self, why: str) -> PydanticCustomError:
        return PydanticCustomError("quantity", "{why}", {"why": why})


@lru_cache(maxsize=4096)  # variants of a case have most of their texts in common
def _read(kind: Kind, text: str) -> float:
    return kind.of_text(text)


Length = Annotated[float, Kind("a length", "m", "5 mm", 1e-12, 1000.0)]
Stiffness = Annotated[float, Kind("a stiffness", "N/m", "100 N/um", 1.0, 1e15)]
Foundation = Annotated[float, Kind("a stiffness per area", "N/m^3", "100 N/mm^3", 1.0, 1e18)]
Fraction = Annotated[float, Kind("a fraction", "1", "1 %", 1e-12, 1000.0)]
Angle = Annotated[float, Kind("an angle", "rad", "12 deg", 1e-15, 1e4)]
Time = Annotated[float, Kind("a time", "s", "20000 h", 1e-3, 1e12)]
Mass = Annotated[float, Kind("a mass", "kg", "25 g", 1e-12, 1e6)]
Force = Annotated[float, Kind("a force", "N", "20 kN", 1e-9, 1e10)]
Moment = Annotated[float, Kind("a moment", "N m", "20 N m", 1e-12, 1e12)]
Acceleration = Annotated[float, Kind("an acceleration", "m/s^2", "9.81 m/s^2", 1e-6, 1e6)]
Speed = Annotated[float, Kind("a rotational speed", SPEED, "38000 rpm", 1e-9, 1e6)]
Velocity = Annotated[float, Kind("a velocity", "m/s", "10 mm/s", 1e-12, 1e4)]
Temperature = Annotated[float, Kind("a temperature", "K", "220 degC", 1.0, 3000.0)]
Pressure = Annotated[float, Kind("a pressure", "Pa", "203 GPa", 1.0, 1e20)]
PerPressure = Annotated[float, Kind("an inverse pressure", "1/Pa", "11 1/GPa", 1e-14, 1e-4)]
PerTemperature = Annotated[float, Kind("an inverse temperature difference", "1/K", "11.2e-6 1/K", 1e-12, 1.0)]
Density = Annotated[float, Kind("a density", "kg/m^3", "7850 kg/m^3", 1e-3, 1e5)]
Viscosity = Annotated[float, Kind("a dynamic viscosity", "Pa s", "1.2 mPa s", 1e-7, 1e4)]
KinematicViscosity = Annotated[float, Kind("a kinematic viscosity", "m^2/s", "32 mm^2/s", 1e-9, 100.0)]
Conductivity = Annotated[float, Kind("a thermal conductivity", "W/(m K)", "0.12 W/(m K)", 1e-6, 1e4)]


class Section(BaseModel):
    """A table of the case file: frozen, with no key that is not declared."""

    model_config = ConfigDict(
        defer_build=True, frozen=True, extra="forbid", strict=True, allow_inf_nan=False, validate_default=True
    )

    former: ClassVar[Mapping[str, str]] = {}  # keys of older versions to what has taken their place
    hints: ClassVar[Mapping[str, str]] = {}  # keys that people look for to a sentence
    by_name: ClassVar[tuple[str, ...]] = ()  # texts that may be in place of the table


GIVEN = ("given",)  # stands for any value of a key that another one needs


def key(
    meaning: str,
    default: Any = ...,
    *,
    example: Any = None,
    only: Mapping[str, tuple] | Sequence[Mapping[str, tuple]] = (),
    **limits: Any,
) -> Any:
    """Declare a key."""
    choices: list[Any] = [only] if isinstance(only, Mapping) else list(only)
    return Field(
        default,
        description=meaning,
        examples=None if example is None else [example],
        json_schema_extra={"only": choices} if choices else None,
        **limits,
    )


def in_mm(length: float) -> str:
    """A length [m] as messages tell it, rounded."""
    return f"{length * 1e3:.4g} mm"


def at_least(length: float) -> str:
    """A lower limit [m] as messages tell it, rounded so that what they print is allowed."""
    return f"at least {in_mm(_rounded(length, ceil))}"


def at_most(length: float) -> str:
    """An upper limit [m], rounded likewise."""
    return f"at most {in_mm(_rounded(length, floor))}"


def _rounded(length: float, towards: Callable[[float], int]) -> float:
    """Length [m] to the digits of `in_mm`."""
    step = 10.0 ** (floor(log10(abs(length))) - 3) if length else 1.0
    return towards(round(length / step, 6)) * step  # 45 mm, not 44.99 mm, of 0.09 m / 2


def located(section: str, check: Callable[[], None]) -> None:
    """Run a check of one section that needs numbers of another; a problem is located in the section."""
    try:
        check()
    except PydanticCustomError as problem:
        context = problem.context or {}
        raise impossible(f"{section}.{context['names'][0]}", context["allowed"]) from None


def impossible(name: str, allowed: str) -> PydanticCustomError:
    """Return the error for a key whose value contradicts another one of the same table."""
    return PydanticCustomError("impossible", "{allowed}", {"names": [name], "allowed": allowed})


def needed(names: list[str], choice: str) -> PydanticCustomError:
    """Return the error for keys that a choice requires and that are not given."""
    return PydanticCustomError("needed", "{choice}", {"names": names, "choice": choice})


def require_one(section: Section, first: str, second: str, choice: str) -> None:
    """Raise unless just one of two keys is given; without a choice that needs one, both may be left out."""
    given = [name for name in (first, second) if getattr(section, name) is not None]
    if choice and not given:
        raise needed([first], choice)
    if len(given) > 1:
        raise impossible(second, f"left out beside {first}; give one of the two")


def require(section: Section, names: tuple[str, ...], choice: str) -> list[Any]:
    """Return the values of keys that a choice requires; raises when some are not given."""
    if missing := [name for name in names if getattr(section, name) is None]:
        raise needed(missing, choice)
    return [getattr(section, name) for name in names]
