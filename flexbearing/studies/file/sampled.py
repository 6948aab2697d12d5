"""The table [sample]: keys that are drawn from distributions, and those that every variant has alike."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import accumulate
from typing import Any

from flexbearing import inputs
from flexbearing.case.declarations import Declaration, toml
from flexbearing.case.quantity import Kind
from flexbearing.printable import excerpt
from flexbearing.sampling.distribution import Distribution, lognormal, normal, truncated_normal, uniform
from flexbearing.sampling.points import POWERS_OF_2, Design, Points
from flexbearing.studies.file.axes import TOGETHER, Axis
from flexbearing.studies.file.columns import MadeRows, Row
from flexbearing.studies.file.schema import Sample
from flexbearing.studies.file.values import MOST, BadValues, in_si_units
from flexbearing.units import BadUnit, UnknownUnit, unit

_TEXT = re.compile(
    r"\s*(?:(?P<count>[0-9]{1,5})\s*x\s+)?(?P<name>[a-z]+(?: [a-z]+)?)\s+(?P<numbers>[^a-z\s].*)"
)
_PLAIN = re.compile(r"\s*[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?(?:\s[^,]*)?")  # one value, with or without a unit
MOST_NUMBERS = 1000  # of one list
MOST_DRAWN, MOST_DIMENSIONS = 20_000_000, 10_000  # of a study, 80 MB; of a variant
AT_ONCE = 1024  # rows
_UNIT = re.compile(r"[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?\s*(.*)")


@dataclass(frozen=True)
class Form:
    """How a distribution is written."""

    words: str  # for messages
    differences: tuple[int, ...]  # places of numbers that are no values of the key but differences
    factors: tuple[int, ...]  # places of plain numbers
    problem: Callable[..., str]  # what is wrong with its numbers; empty where nothing is
    made: Callable[..., Distribution]  # of its numbers


@dataclass(frozen=True, eq=False)
class Factor:
    """A key that is drawn."""

    key: str
    distribution: Distribution  # of the key in SI units, or of each number of its list
    unit: str = ""  # SI, empty of plain numbers
    width: int = 1  # how many numbers are drawn for it, independently
    listed: bool = False
    smallest: float = 0.0  # [SI] size of a value of the key that is not zero; what is drawn below is zero

    def written(self, numbers: Sequence[float]) -> Any:
        """Numbers (width) in SI units in the words of a case file."""
        sized = [number if abs(number) >= self.smallest else 0.0 for number in numbers]
        words = [f"{number!r} {self.unit}" if self.unit else number for number in sized]
        return words if self.listed else words[0]


class DrawnRows(MadeRows):
    """Rows made of points, many at once where one is read; the last ones stay."""

    def __init__(self, points: Points, factors: Sequence[Factor], alike: Row):
        self._points, self._factors, self._alike = points, factors, alike
        self._some = lru_cache(maxsize=1)(self._made)

    def __len__(self) -> int:
        return len(self._points)

    def _row(self, number: int) -> Row:
        some, place = divmod(number, AT_ONCE)
        return self._some(some * AT_ONCE)[place]

    def _made(self, first: int) -> list[Row]:
        points = self._points[first : first + AT_ONCE]
        ends = accumulate(factor.width for factor in self._factors)
        columns = [
            map(factor.written, factor.distribution.quantile(points[:, end - factor.width : end]).tolist())
            for factor, end in zip(self._factors, ends, strict=True)
        ]
        return [(*row, *self._alike) for row in zip(*columns, strict=True)]


@dataclass(frozen=True, eq=False)
class Drawn:
    """What is drawn in a study, and how."""

    factors: tuple[Factor, ...]
    design: Design


def _rising(low, high):
    return "" if low < high else "its second number is not above its first"


def _spread(mean, deviation):
    return "" if deviation > 0 else "its deviation is not above zero"


def _inside(mean, deviation, low, high):
    return _spread(mean, deviation) or ("" if low < high else "its highest value is not above its lowest")


def _multiplied(median, factor):
    if median <= 0:
        return "its median is not above zero"
    return "" if factor > 1 else "its factor is not above 1"


_TRUNCATED = Form('"truncated normal MEAN, DEVIATION, LOW, HIGH"', (1,), (), _inside, truncated_normal)
FORMS = {
    "uniform": Form('"uniform LOW, HIGH"', (), (), _rising, uniform),
    "normal": Form('"normal MEAN, DEVIATION"', (1,), (), _spread, normal),
    "truncated normal": _TRUNCATED,
    "truncated": _TRUNCATED,
    "lognormal": Form('"lognormal MEDIAN, FACTOR"', (), (1,), _multiplied, lognormal),
}


def sampled(sample: Sample, find: Callable[[str], Declaration]) -> tuple[Axis, Drawn]:
    """The axis of the table [sample], and what is drawn along it.

    Raises `BadValues` naming the key.
    """
    given: Mapping[str, Any] = sample.model_extra or {}
    alike = {key: value for key, value in given.items() if _is_one_value(value)}
    factors = [_factor(key, text, find(key)) for key, text in given.items() if key not in alike]
    for key in alike:
        find(key)
    if not factors:
        raise BadValues('names no key; give one or more, such as "bearing.clearance" = "normal 75 um, 5 um"')
    design, widths = _design(sample), [factor.width for factor in factors]
    _require_few(design.rows(len(factors)), sum(widths))
    keys = *(factor.key for factor in factors), *alike
    rows = DrawnRows(design.points(widths), factors, tuple(alike.values()))
    return Axis(TOGETHER, keys, rows), Drawn(tuple(factors), design)


def _is_one_value(given: Any) -> bool:
    return not isinstance(given, str) or bool(_PLAIN.fullmatch(given))


def _require_few(rows: int, numbers: int) -> None:
    """Refuse more than memory holds and SciPy draws."""
    if rows > MOST:
        raise BadValues(f"gives {rows} variants; a study has at most {MOST}")
    if numbers > MOST_DIMENSIONS or rows * numbers > MOST_DRAWN:
        raise BadValues(
            f"draws {numbers} numbers for each of {rows} variants; there may be {MOST_DIMENSIONS}, and "
            f"{MOST_DRAWN} of all variants"
        )


def _design(sample: Sample) -> Design:
    count = sample.count
    if sample.method in POWERS_OF_2 and count & (count - 1):
        below = 1 << (count.bit_length() - 1)
        raise BadValues(
            f"count = {count} is not a power of 2, for which Sobol points are even: {below} or {2 * below}"
        )
    return Design(sample.method, count, sample.seed)


def _factor(key: str, text: Any, declaration: Declaration) -> Factor:
    """What is drawn for one key."""
    try:
        return _read(key, text, declaration)
    except BadValues as problem:
        raise BadValues(f"{key} = {excerpt(toml(text))} {problem}") from None


def _read(key: str, text: Any, declaration: Declaration) -> Factor:
    parts = _TEXT.fullmatch(text) if isinstance(text, str) and len(text) <= 400 else None
    name = " ".join(parts["name"].split()) if parts else ""
    if parts is None or name not in FORMS:
        known = " or ".join(dict.fromkeys(each.words for each in FORMS.values()))
        raise BadValues(f"is no distribution; it must be {known}")
    if declaration.whole or not (declaration.kind or declaration.number):
        raise BadValues(f"cannot be drawn: the key takes {declaration.allowed}")
    if declaration.listed and not parts["count"]:
        raise BadValues(f'has no count; a list of 30 numbers is drawn by "30 x {name} ..."')
    if parts["count"] and not declaration.listed:
        raise BadValues(f"has a count, but the key takes {declaration.allowed}")
    form = FORMS[name]
    numbers = _numbers(parts["numbers"], form, declaration.kind)
    if problem := form.problem(*numbers):
        raise BadValues(f"cannot be: {problem}")
    width = int(parts["count"] or 1)
    if not 1 <= width <= MOST_NUMBERS:
        raise BadValues(f"has a list of {width} numbers; it must be of 1 to {MOST_NUMBERS}")
    unit_text, smallest = (kind.unit, kind.smallest) if (kind := declaration.kind) else ("", 0.0)
    return Factor(key, form.made(*numbers), unit_text, width, declaration.listed, smallest)


def _numbers(text: str, form: Form, kind: Kind | None) -> list[float]:
    """Numbers of a distribution in SI units."""
    texts = [number.strip() for number in text.split(",")]
    if len(texts) != form.words.count(",") + 1:
        raise BadValues(f"has {len(texts)} numbers; it must be {form.words}")
    kinds = [None if place in form.factors else kind for place in range(len(texts))]
    if kind is not None:
        for place in form.differences:
            _require_difference(texts[place])
            kinds[place] = replace(kind, smallest=0.0)  # a value has a least size, a difference has none
    return [_number(each, kind) for each, kind in zip(texts, kinds, strict=True)]


def _number(text: str, kind: Kind | None) -> float:
    if kind is not None:
        return in_si_units(text, kind)
    try:
        return inputs.number(text)
    except inputs.BadNumber as problem:
        raise BadValues(f"has a number that is none: {problem}") from None


def _require_difference(text: str) -> None:
    """Refuse a deviation on a scale whose zero is not that of the unit, as of degC."""
    parts = _UNIT.fullmatch(text)
    if parts is None:
        return
    try:
        on_a_scale = bool(unit(parts[1]).offset)
    except (BadUnit, UnknownUnit):
        return  # refused with the number
    if on_a_scale:
        raise BadValues(f"has the deviation {toml(excerpt(text))}: a difference of temperatures is in K")
