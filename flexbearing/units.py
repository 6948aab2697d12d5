"""The units of case files and outputs, with their exact factors, and a grammar for products and powers."""

import re
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from math import pi

DIMENSIONS = ("m", "kg", "s", "K", "rad")  # an angle is one: turns and radians a second are not the same
LONGEST, HIGHEST = 40, 4  # characters of a unit; largest power in it
LARGEST_FACTOR, HIGHEST_PI = (
    2**500,
    16,
)  # of a product, which brackets with powers can raise beyond all floats

_BETWEEN = ("*", "·", ".", "-", "/")  # factors
_INTEGER = re.compile("[+-]?[0-9]+")
_TOKEN = re.compile(r"\s*(\*\*|[*/^()·]|[.-](?=[A-Za-z])|[+-]?[0-9]+|[A-Za-zµμ°%_]+|''?|\"|⁻?[¹²³⁴])")
_SUPERSCRIPTS = {f"{sign}{digit}": int(f"{number}{power}")
                 for sign, number in (("", ""), ("⁻", "-"))
                 for power, digit in enumerate("¹²³⁴", 1)}  # fmt: skip
_PREFIXES = {
    "n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "d": -1, "da": 1, "h": 2, "k": 3, "M": 6, "G": 9
}  # fmt: skip


class UnknownUnit(ValueError):
    """A name that is no unit of the table."""


class BadUnit(ValueError):
    """A text that is no product of units."""


@dataclass(frozen=True)
class Unit:
    """A unit: SI value = offset + factor times number."""

    factor: Fraction  # exact, without pi
    powers: tuple[int, ...]  # of `DIMENSIONS`
    pi_power: int = 0  # of pi in the factor
    offset: Fraction = Fraction(0)  # in SI, of a scale of temperature

    def times(self, other: "Unit", sign: int) -> "Unit":
        """Product with a unit, or quotient for sign = -1."""
        powers = tuple(a + sign * b for a, b in zip(self.powers, other.powers, strict=True))
        return _bounded(Unit(self.factor * other.factor**sign, powers, self.pi_power + sign * other.pi_power))

    def to_the(self, power: int) -> "Unit":
        """Integer power of a unit."""
        powers = tuple(power * own for own in self.powers)
        return _bounded(Unit(self.factor**power, powers, power * self.pi_power))

    def to_si(self, number: float) -> float:
        """Value in SI units."""
        return number * self.scale + float(self.offset)

    def of_si(self, value: float) -> float:
        """Number of a value in SI units, the inverse of `to_si`."""
        return (value - float(self.offset)) / self.scale

    @cached_property
    def scale(self) -> float:
        """Its factor as a number."""
        return float(self.factor * Fraction(pi) ** self.pi_power)


def _bounded(found: Unit) -> Unit:
    """The unit, unless it is beyond what numbers can hold."""
    factor = found.factor
    if max(factor.numerator, factor.denominator) > LARGEST_FACTOR or abs(found.pi_power) > HIGHEST_PI:
        raise BadUnit(f"{found.powers}")
    return found


def _unit(
    factor: str | int | Fraction, *powers: int, pi_power: int = 0, offset: str | Fraction = "0"
) -> Unit:
    padded = (*powers, *(0,) * (len(DIMENSIONS) - len(powers)))
    return Unit(Fraction(factor), padded, pi_power, Fraction(offset))


ONE = _unit(1)
_FORCE, _PRESSURE = (1, 1, -2), (-1, 1, -2)
_POUND_FORCE = Fraction("0.45359237") * Fraction("9.80665")
_INCH = Fraction("0.0254")
_ANGLE = (0, 0, 0, 0, 1)
_DEGREE = Fraction(1, 180)
_ANY, _MOMENT = tuple(_PREFIXES), (2, 1, -2)
_FAHRENHEIT = _unit(Fraction(5, 9), 0, 0, 0, 1, offset=Fraction("273.15") - 32 * Fraction(5, 9))
_PREFIXED = {  # names with the prefixes they take
    "m": (_unit(1, 1), _ANY), "g": (_unit("0.001", 0, 1), "nuµμmk"), "s": (_unit(1, 0, 0, 1), "nuµμm"),
    "N": (_unit(1, *_FORCE), _ANY), "Pa": (_unit(1, *_PRESSURE), _ANY),
    "bar": (_unit(100000, *_PRESSURE), "mk"),
    "J": (_unit(1, 2, 1, -2), _ANY), "W": (_unit(1, 2, 1, -3), _ANY),
    "Hz": (_unit(1, 0, 0, -1), "kM"), "K": (_unit(1, 0, 0, 0, 1), "m"), "rad": (_unit(1, *_ANGLE), "nuµμmk"),
    "rpm": (_unit(Fraction(1, 30), 0, 0, -1, 0, 1, pi_power=1), "k"),
    "rev": (_unit(2, *_ANGLE, pi_power=1), "kM"), "P": (_unit("0.1", -1, 1, -1), "cm"),
    "St": (_unit("0.0001", 2, 0, -1), "cm"), "in": (_unit(_INCH, 1), "uµμ"),
    "Nm": (_unit(1, *_MOMENT), ("m", "da", "k", "M")), "Nmm": (_unit("0.001", *_MOMENT), "k"),
    "Ncm": (_unit("0.01", *_MOMENT), ""), "Pas": (_unit(1, -1, 1, -1), "m"),
}  # fmt: skip
_PLAIN = {
    "meter": _unit(1, 1), "metre": _unit(1, 1), "inch": _unit(_INCH, 1),
    "mil": _unit(_INCH / 1000, 1), "thou": _unit(_INCH / 1000, 1),
    "ft": _unit(12 * _INCH, 1), "micron": _unit("1e-6", 1), "t": _unit(1000, 0, 1),
    "lb": _unit("0.45359237", 0, 1), "min": _unit(60, 0, 0, 1), "minute": _unit(60, 0, 0, 1),
    "h": _unit(3600, 0, 0, 1), "hour": _unit(3600, 0, 0, 1),
    "lbf": _unit(_POUND_FORCE, *_FORCE), "kgf": _unit("9.80665", *_FORCE),
    "hp": _unit(550 * 12 * _INCH * _POUND_FORCE, 2, 1, -3),
    "psi": _unit(_POUND_FORCE / _INCH**2, *_PRESSURE),
    "ksi": _unit(1000 * _POUND_FORCE / _INCH**2, *_PRESSURE), "atm": _unit(101325, *_PRESSURE),
    "deg": _unit(_DEGREE, *_ANGLE, pi_power=1), "°": _unit(_DEGREE, *_ANGLE, pi_power=1),
    "degree": _unit(_DEGREE, *_ANGLE, pi_power=1), "degrees": _unit(_DEGREE, *_ANGLE, pi_power=1),
    "arcmin": _unit(_DEGREE / 60, *_ANGLE, pi_power=1), "arcsec": _unit(_DEGREE / 3600, *_ANGLE, pi_power=1),
    "'": _unit(_DEGREE / 60, *_ANGLE, pi_power=1), "''": _unit(_DEGREE / 3600, *_ANGLE, pi_power=1),
    '"': _unit(_DEGREE / 3600, *_ANGLE, pi_power=1),
    "r": _unit(2, *_ANGLE, pi_power=1), "U": _unit(2, *_ANGLE, pi_power=1),
    "RPM": _unit(Fraction(1, 30), 0, 0, -1, 0, 1, pi_power=1),
    "revolution": _unit(2, *_ANGLE, pi_power=1), "turn": _unit(2, *_ANGLE, pi_power=1),
    "degC": _unit(1, 0, 0, 0, 1, offset="273.15"), "°C": _unit(1, 0, 0, 0, 1, offset="273.15"),
    "degF": _FAHRENHEIT, "°F": _FAHRENHEIT,
    "%": _unit("0.01"), "percent": _unit("0.01"), "ppm": _unit("1e-6"),
}  # fmt: skip


def _named(name: str) -> Unit:
    """Unit of a name, with a prefix where it takes one; raises `UnknownUnit`."""
    if name in _PLAIN:
        return _PLAIN[name]
    if name in _PREFIXED:
        return _PREFIXED[name][0]
    for length in (1, 2):  # of the prefix
        base, prefixes = _PREFIXED.get(name[length:], (ONE, ""))
        if name[:length] in prefixes:
            return Unit(base.factor * Fraction(10) ** _PREFIXES[name[:length]], base.powers, base.pi_power)
    raise UnknownUnit(name)


@lru_cache(maxsize=256)
def unit(text: str) -> Unit:
    """Read a unit such as "mm", "N/mm^3", "W/(m K)" or "1/GPa".

    Products are read from left to right: "W/m K" is (W/m) K. In a product, degC and degF are differences.

    Raises `UnknownUnit` for a name that is not in the table, `BadUnit` for a text that is no product of
    powers of units.
    """
    tokens = _tokens(text)
    if len(tokens) == 1 and tokens[0] in _PLAIN:
        return _PLAIN[tokens[0]]  # alone, a scale of temperature keeps its offset
    found, rest = _product(tokens)
    if rest:
        raise BadUnit(text)
    return found


def alike(kind: Unit) -> tuple[str, ...]:
    """Names of the table that are units of the same kind, without prefixes and scales of temperature."""
    bases = {name: base for name, (base, _) in _PREFIXED.items()} | _PLAIN
    return tuple(name for name, base in bases.items() if base.powers == kind.powers and not base.offset)


def spelt_otherwise(name: str) -> tuple[str, ...]:
    """Names, with their prefixes, that differ from an unknown one in capitals alone."""
    prefixed = {prefix + name for name, (_, prefixes) in _PREFIXED.items() for prefix in ("", *prefixes)}
    alike = (each for each in {*_PLAIN, *prefixed} if each.lower() == name.lower())
    return tuple(sorted(alike, key=lambda each: (each != name.lower(), each)))


def _tokens(text: str) -> list[str]:
    if len(text) > LONGEST:
        raise BadUnit(text)
    tokens, place, text = [], 0, text.strip()
    while place < len(text):
        token = _TOKEN.match(text, place)
        if token is None:
            raise BadUnit(text)
        tokens.append(token[1])
        place = token.end()
    return tokens


def _product(tokens: list[str]) -> tuple[Unit, list[str]]:
    """Product at the beginning of the tokens, and what is left of them."""
    product, tokens = _power(tokens)
    while tokens and tokens[0] != ")":
        sign = -1 if tokens[0] == "/" else 1
        factor, tokens = _power(tokens[1:] if tokens[0] in _BETWEEN else tokens)
        product = product.times(factor, sign)
    return product, tokens


def _power(tokens: list[str]) -> tuple[Unit, list[str]]:
    """Unit or bracket with its power at the beginning of the tokens, and what is left of them."""
    base, tokens = _base(tokens)
    if tokens and tokens[0] in _SUPERSCRIPTS:
        return _raised(base, _SUPERSCRIPTS[tokens[0]]), tokens[1:]
    if tokens and tokens[0] in ("^", "**"):
        if len(tokens) == 1 or not _INTEGER.fullmatch(tokens[1]):
            raise BadUnit("^")
        return _raised(base, int(tokens[1])), tokens[2:]
    if tokens and base is not ONE and _INTEGER.fullmatch(tokens[0]):  # N/mm2, min-1
        return _raised(base, int(tokens[0])), tokens[1:]
    return base, tokens


def _base(tokens: list[str]) -> tuple[Unit, list[str]]:
    """Unit, bracket or 1 at the beginning of the tokens, and what is left of them."""
    first, tokens = (tokens[0], tokens[1:]) if tokens else ("", [])
    if first == "(":
        inside, tokens = _product(tokens)
        if not tokens:
            raise BadUnit("(")
        return inside, tokens[1:]
    if first == "1":
        return ONE, tokens
    if first[:1].isalpha() or first[:1] in ("°", "%", "'", '"'):
        return _named(first), tokens
    raise BadUnit(first)


def _raised(base: Unit, power: int) -> Unit:
    if abs(power) > HIGHEST:
        raise BadUnit(f"^{power}")
    return base.to_the(power)
