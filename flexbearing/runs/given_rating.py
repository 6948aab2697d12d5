"""A rating of a maker as a factor on the formula's, fixed by the bearing for which it was given."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from quasidynamic import OutOfRange
from quasidynamic.outcome.life_factors import (
    LEAST_VISCOSITY_RATIO,
    ModifiedBy,
    modification_factor,
    reference_viscosity,
)

LETTERS = {"dynamic_rating": "C_r", "static_rating": "C_0r", "fatigue_limit_load": "C_u"}


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


def judged(each: Sequence[Mapping[str, Rating]]) -> dict[str, Any]:
    """Given ratings of cases over those of the formulas, and how much they changed with the bearing."""
    names = {name for ratings in each for name in ratings}
    return {
        quantity: {
            LETTERS[name]: [_known(measure, ratings.get(name)) for ratings in each] for name in sorted(names)
        }
        for quantity, measure in (("rating_ratio", _ratio), ("rating_change", _change))
    }


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
