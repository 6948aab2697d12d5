"""Ratings that a case gives, the viscosity ratio of its oil, and the lives of a state with them."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import prod
from typing import Any

from numpy.typing import NDArray

from flexbearing.findings.running import NO_MODIFIED_LIFE
from flexbearing.quantities.life_records import BY_LOADS, Factor
from quasidynamic import OutOfRange
from quasidynamic.note import Note, information, outside
from quasidynamic.outcome.life_factors import (
    LEAST_VISCOSITY_RATIO,
    LifeFactor,
    ModifiedBy,
    ModifiedLife,
    modification_factor,
    reference_viscosity,
    reliability_factor,
)

LETTERS = {"dynamic_rating": "C_r", "static_rating": "C_0r", "fatigue_limit_load": "C_u"}
MREV = 1e6  # revolutions
CAPACITY, EDGE_STRESS = "capacity", "edge stress"  # factors between the basic and the reference life


@dataclass(frozen=True)
class Rating:
    """A rating of one bearing."""

    formula: Callable[[Any], float]  # of a bearing [N]
    bearing: Any  # as it is
    given: float | None  # [N]; None: by the formula
    given_for: Any  # the same object where it is that bearing

    @cached_property
    def value(self) -> float:
        """The rating [N]."""
        return self.formula(self.bearing) if self.given is None else self.given * self.scale

    @property
    def scale(self) -> float:
        """The formula's rating over that of the bearing for which the rating was given [-]."""
        if self.given_for is self.bearing:
            return 1.0
        return self.formula(self.bearing) / self.formula(self.given_for)

    def origin(self, standard: str) -> str:
        """Where it comes from, in words."""
        if self.given is None:
            return f"formula of {standard}"
        return "given" if self.scale == 1 else f"given, times {self.scale:.4g} by the formula of {standard}"


def rating_ratios(each: Sequence[Mapping[str, Rating]]) -> dict[str, Any]:
    """Given ratings of cases over those of the formulas."""
    return {"rating_ratio": _by_letters(each, _ratio)}


def rating_changes(each: Sequence[Mapping[str, Rating]]) -> dict[str, Any]:
    """How much given ratings of cases changed with the bearing."""
    return {"rating_change": _by_letters(each, _change)}


def _by_letters(
    each: Sequence[Mapping[str, Rating]], measure: Callable[[Rating], float]
) -> dict[str, list[float]]:
    names = {name for ratings in each for name in ratings}
    return {LETTERS[name]: [_known(measure, ratings.get(name)) for ratings in each] for name in sorted(names)}


def _known(measure: Callable[[Rating], float], rating: Rating | None) -> float:
    """A number of a rating; not a number where it is not given, or its formula does not hold."""
    try:
        return float("nan") if rating is None else measure(rating)
    except OutOfRange:
        return float("nan")


def _ratio(rating: Rating) -> float:
    assert rating.given is not None
    return rating.given / rating.formula(rating.given_for)


def _change(rating: Rating) -> float:
    """How many times larger or smaller a rating became."""
    return max(rating.scale, 1 / rating.scale)


def of_oil(
    viscosity: float, speed: float, pitch_diameter: float, load_ratio: float, elements: ModifiedBy
) -> dict[str, float]:
    r"""Both viscosities of ISO 281, their ratio, and a_ISO with clean oil.

    .. math:: \kappa = \nu / \nu_1,\quad a_{ISO} \le a_{ISO}(\kappa, C_u / P) \;(e_C = 1)

    Source
    ------
    ISO 281 (2007), section 9.3.3 and Eqs. 31-36; e_C is at most 1, annex A.

    Valid
    -----
    As `reference_viscosity` and `modification_factor`.
    """
    needed = float(reference_viscosity(speed, pitch_diameter))
    ratio = viscosity / needed
    found = {"viscosity": viscosity, "reference_viscosity": needed, "viscosity_ratio": ratio}
    if ratio >= LEAST_VISCOSITY_RATIO:
        found["largest_a_ISO"] = float(modification_factor(ratio, load_ratio, elements).value)
    return found


@dataclass(frozen=True)
class LifeOfState:
    """The life at one state of the bearing, from the basic one over every factor."""

    basic: float  # [10^6 revolutions]
    factors: tuple[Factor, ...]
    modified: float | None  # [revolutions]; None where a factor does not hold

    @property
    def reference(self) -> float | None:
        """Reference life by ISO/TS 16281 [rev], without rollers that fail; None by other capacities."""
        loads = {factor.name: factor.value for factor in self.factors if factor.effect == BY_LOADS}
        if CAPACITY not in loads:
            return None
        return self.basic * MREV * float(loads[CAPACITY]) * float(loads.get(EDGE_STRESS, 1.0))

    @classmethod
    def of(cls, basic: float, by_loads: Sequence[Factor], factors: Sequence[LifeFactor]) -> "LifeOfState":
        """The life after what changes its loads or capacities, then after factors of different effects."""
        rated = basic * prod(float(factor.value) for factor in by_loads)
        life = ModifiedLife(basic=rated, factors=tuple(factors))
        further = (Factor(**{**vars(factor), "value": float(factor.value)}) for factor in life.factors)
        return cls(basic, (*by_loads, *further), float(life.life) * MREV)

    def record(self) -> dict[str, Any]:
        """The same as JSON can hold it, lives in 10^6 revolutions."""
        return {
            "basic_Mrev": self.basic,
            "factors": [*map(vars, self.factors)],
        } | ({} if self.modified is None else {"modified_Mrev": self.modified / MREV})


def explained(factor: LifeFactor, words: str) -> LifeFactor:
    """A factor with more to say of it."""
    return replace(factor, note="; ".join(filter(None, (factor.note, words))))


def why_none(law: Callable[[], object]) -> str:
    """Why a law has no value; empty where it has one."""
    try:
        law()
    except OutOfRange as why:
        return str(why)
    return ""


def no_life(unrated: str, unmodified: str, kappa: float | None) -> tuple[Note, ...]:
    """Why a life is left out; a viscosity ratio that is too small is a finding of its own."""
    if not unmodified:
        return (information("no-life", f"no rating life: {unrated}"),) if unrated else ()
    if kappa is not None and kappa < LEAST_VISCOSITY_RATIO:
        return ()
    return (outside(NO_MODIFIED_LIFE, f"no modified life: {unmodified}"),)


@dataclass(frozen=True)
class ReferenceLives:
    """Lives at one state of the bearing [rev]."""

    basic: float  # L10r
    raceways: NDArray  # (2) of the inner and the outer raceway on their own
    of_state: LifeOfState | None  # after every factor; None where there is none, or one does not hold

    @property
    def modified(self) -> float | None:
        """Life after every factor [rev]."""
        return None if self.of_state is None else self.of_state.modified


def of_reliability(reliability: float | None) -> list[LifeFactor]:
    """The factor of the reliability that a case requires; none where it requires none."""
    if reliability is None:
        return []
    return [explained(reliability_factor(reliability), f"reliability {reliability:g}")]
