"""Values drawn from distributions, at points of a Latin hypercube or of a Sobol sequence."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import log
from typing import TYPE_CHECKING, Any

from flexbearing.case.declarations import Declaration, toml
from flexbearing.case.excerpt import excerpt
from flexbearing.case.quantity import Kind
from flexbearing.studies.file.axes import TOGETHER, Axis
from flexbearing.studies.file.schema import Sample
from flexbearing.studies.file.values import BadValues, in_si_units
from flexbearing.units import BadUnit, UnknownUnit, unit

if TYPE_CHECKING:
    import numpy as np

_TEXT = re.compile(r"\s*(?P<name>[a-z]+(?: [a-z]+)?)\s+(?P<numbers>[^a-z\s].*)")
_UNIT = re.compile(r"[+-]?[0-9.]+(?:[eE][+-]?[0-9]+)?\s*(.*)")


@dataclass(frozen=True)
class Distribution:
    """A distribution by the numbers that it is written with."""

    words: str  # how it is written, for messages
    differences: tuple[int, ...]  # places of numbers that are no values of the key but differences
    factors: tuple[int, ...]  # places of plain numbers
    problem: Callable[..., str]  # what is wrong with its numbers; empty where nothing is
    quantile: Callable[..., "np.ndarray"]  # of probabilities and its numbers


def _uniform(probability, low, high):
    return low + (high - low) * probability


def _normal(probability, mean, deviation):
    from scipy.special import ndtri

    return mean + deviation * ndtri(probability)


def _truncated(probability, mean, deviation, low, high):
    from scipy.stats import truncnorm

    return truncnorm.ppf(probability, (low - mean) / deviation, (high - mean) / deviation, mean, deviation)


def _lognormal(probability, median, factor):
    from numpy import exp
    from scipy.special import ndtri

    return median * exp(log(factor) * ndtri(probability))


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


_TRUNCATED = Distribution('"truncated normal MEAN, DEVIATION, LOW, HIGH"', (1,), (), _inside, _truncated)
DISTRIBUTIONS = {
    "uniform": Distribution('"uniform LOW, HIGH"', (), (), _rising, _uniform),
    "normal": Distribution('"normal MEAN, DEVIATION"', (1,), (), _spread, _normal),
    "truncated normal": _TRUNCATED,
    "truncated": _TRUNCATED,
    "lognormal": Distribution('"lognormal MEDIAN, FACTOR"', (), (1,), _multiplied, _lognormal),
}


def sampled(sample: Sample, find: Callable[[str], Declaration]) -> Axis:
    """The axis of the table [sample].

    Parameters
    ----------
    sample : Sample
        with its keys
    find : callable (key)
        declaration of a key; raises BadValues where the case has none

    Returns
    -------
    Axis
        of all keys; values of quantities are in SI units

    Raises
    ------
    BadValues
        naming the key
    """
    distributions: Mapping[str, Any] = sample.model_extra or {}
    if not distributions:
        raise BadValues('names no key; give one or more, such as "bearing.clearance" = "normal 75 um, 5 um"')
    columns = []
    points = _points(sample, len(distributions))
    for key, text, column in zip(distributions, distributions.values(), points.T, strict=True):
        declaration = find(key)
        try:
            columns.append(_drawn(text, column, declaration))
        except BadValues as problem:
            raise BadValues(f"{key} = {excerpt(toml(text))} {problem}") from None
    return Axis(TOGETHER, tuple(distributions), tuple(zip(*columns, strict=True)))


def _points(sample: Sample, dimensions: int) -> "np.ndarray":
    """Points (count, keys) of the unit cube."""
    from scipy.stats import qmc  # since SciPy 1.15 seed is called rng, too

    count = sample.count
    if sample.method == "latin_hypercube":
        return qmc.LatinHypercube(dimensions, seed=sample.seed).random(count)  # pyright: ignore[reportCallIssue]
    if count & (count - 1):
        below = 1 << (count.bit_length() - 1)
        raise BadValues(
            f"count = {count} is not a power of 2, for which Sobol points are even: {below} or {2 * below}"
        )
    return qmc.Sobol(dimensions, seed=sample.seed).random(count)  # pyright: ignore[reportCallIssue]


def _drawn(text: Any, probabilities: "np.ndarray", declaration: Declaration) -> list[Any]:
    """Values of one key, in the words of a case file."""
    distribution, numbers = _read(text, declaration)
    if problem := distribution.problem(*numbers):
        raise BadValues(f"cannot be: {problem}")
    drawn = distribution.quantile(probabilities, *numbers).tolist()
    unit_text = declaration.kind.unit if declaration.kind else ""
    return [f"{value!r} {unit_text}" for value in drawn] if unit_text else drawn


def _read(text: Any, declaration: Declaration) -> tuple[Distribution, list[float]]:
    parts = _TEXT.fullmatch(text) if isinstance(text, str) and len(text) <= 400 else None
    name = " ".join(parts["name"].split()) if parts else ""
    if parts is None or name not in DISTRIBUTIONS:
        known = " or ".join(dict.fromkeys(each.words for each in DISTRIBUTIONS.values()))
        raise BadValues(f"is no distribution; it must be {known}")
    if declaration.listed or declaration.whole or not (declaration.kind or declaration.number):
        raise BadValues(f"cannot be drawn: the key takes {declaration.allowed}")
    distribution = DISTRIBUTIONS[name]
    texts = [number.strip() for number in parts["numbers"].split(",")]
    if len(texts) != distribution.words.count(",") + 1:
        raise BadValues(f"has {len(texts)} numbers; it must be {distribution.words}")
    kinds = [None if place in distribution.factors else declaration.kind for place in range(len(texts))]
    for place in distribution.differences:
        _require_difference(texts[place], declaration.kind)
    return distribution, [_number(each, kind) for each, kind in zip(texts, kinds, strict=True)]


def _number(text: str, kind: Kind | None) -> float:
    if kind is not None:
        return in_si_units(text, kind)
    try:
        return float(text)
    except ValueError:
        raise BadValues(f"has {toml(excerpt(text))}, which is no number") from None


def _require_difference(text: str, kind: Kind | None) -> None:
    """Refuse a deviation on a scale whose zero is not that of the unit, as of degC."""
    parts = _UNIT.fullmatch(text)
    if kind is None or parts is None:
        return
    try:
        on_a_scale = bool(unit(parts[1]).offset)
    except (BadUnit, UnknownUnit):
        return  # told with the number
    if on_a_scale:
        raise BadValues(f"has the deviation {toml(excerpt(text))}: a difference of temperatures is in K")
