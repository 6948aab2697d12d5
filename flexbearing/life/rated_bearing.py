"""Bearings as ISO 281 and ISO 76 rate them, with oil and speed, for rolling elements of any kind."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

from numpy.typing import NDArray

from flexbearing.life.life_of_state import LifeOfState, explained, no_life, of_reliability, why_none
from flexbearing.quantities.life_records import BY_LOADS, Factor, Ratings
from quasidynamic import OutOfRange
from quasidynamic.note import Note
from quasidynamic.outcome.life import reference_load
from quasidynamic.outcome.life_factors import (
    CLEANLINESS,
    LifeFactor,
    ModifiedBy,
    contamination_factor,
    modification_factor,
    modification_of_parts,
    modification_slope,
    viscosity_ratio,
)
from quasidynamic.outcome.raceway_damage import ContactFatigue
from quasidynamic.outcome.rating_life import BALL_EXPONENT, EquivalentLoad, rating_life, static_safety

LETTERS = {"dynamic_rating": "C_r", "static_rating": "C_0r", "fatigue_limit_load": "C_u"}
THRUST_LETTERS = LETTERS | {"dynamic_rating": "C_a", "static_rating": "C_0a"}
POWERS = {BALL_EXPONENT: "3"}  # as a standard writes them, see `RatedBearing.power`


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

    @property
    def formula_or_none(self) -> float | None:
        """The formula's rating [N]; None where it does not hold."""
        try:
            return self.formula(self.bearing)
        except OutOfRange:
            return None

    def origin(self, standard: str) -> str:
        """Where it comes from, in words."""
        if self.given is None:
            return f"formula of {standard}"
        return "given" if self.scale == 1 else f"given, times {self.scale:.4g} by the formula of {standard}"


def rating_ratios(
    each: Sequence[Mapping[str, Rating]], letters: Mapping[str, str] = LETTERS
) -> dict[str, Any]:
    """Given ratings of cases over those of the formulas."""
    return {"rating_ratio": _by_letters(each, _ratio, letters)}


def rating_changes(
    each: Sequence[Mapping[str, Rating]], letters: Mapping[str, str] = LETTERS
) -> dict[str, Any]:
    """How much given ratings of cases changed with the bearing."""
    return {"rating_change": _by_letters(each, _change, letters)}


def _by_letters(
    each: Sequence[Mapping[str, Rating]], measure: Callable[[Rating], float], letters: Mapping[str, str]
) -> dict[str, list[float]]:
    names = {name for ratings in each for name in ratings}
    return {letters[name]: [_known(measure, ratings.get(name)) for ratings in each] for name in sorted(names)}


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


class LoadedParts(NamedTuple):
    """Slices of rollers or rows of balls under their loads."""

    loads: NDArray  # equivalent load of each [N], in terms of that of the bearing
    damages: NDArray  # [10^6 revolutions to the power -e]
    fatigue: ContactFatigue  # by which they add up


@dataclass(frozen=True, kw_only=True)
class RatedBearing:
    """A bearing of a case as the standards rate it, its oil and the settings of its life."""

    life: Any  # section [life] of the case
    rating: Callable[[str], Rating]  # by its key
    limit_of_static: Callable[[float], float]  # C_u of ISO 281 from C_0r, both [N]
    load: Callable[[], EquivalentLoad]  # P; raises `OutOfRange` where forces are not known or have none
    static_load: Callable[[], EquivalentLoad]  # P_0
    forces: tuple[float, float] | None = None  # [N] radial and axial load in P; None: the radial one alone
    elements: ModifiedBy
    exponent: float  # of P in ISO 281
    pitch_diameter: float  # [m]
    speed: float  # [rad/s] of one ring against the other
    viscosity: (
        Callable[[], tuple[float, tuple[Note, ...]]] | None
    )  # kinematic, of the oil at the inlet [m^2/s]
    require_rated: Callable[[], None] = lambda: None  # raises `OutOfRange` of elements without a C_r
    needs_rating: bool = True  # whether lives come from C_r
    rating_factor: float = 1.0  # C_r of a life by ratings over that of the standard
    load_exponent: float | None = None  # of P in a life by ratings; None: that of ISO 281
    material: Sequence[LifeFactor] = ()  # factors of the steel
    rows: int = 1
    rows_rating: float = 1.0  # C_r of all rows over that of one

    @property
    def dynamic(self) -> float:
        """C_r of the case, or of ISO 281, of one row [N].

        Raises `OutOfRange` where ISO 281 has none.
        """
        self.require_rated()
        return self.rating("dynamic_rating").value

    @property
    def static(self) -> float:
        """C_0r of the case, or of ISO 76, of one row [N]."""
        return self.rating("static_rating").value

    @property
    def static_or_none(self) -> float | None:
        """The same; None where ISO 76 has none."""
        return None if why_none(lambda: self.static) else self.static

    @property
    def fatigue_limit(self) -> float:
        """C_u of the case, or of ISO 281 from C_0r, of one row [N]."""
        if self.life.fatigue_limit_load is None:
            return self.limit_of_static(self.static)
        return self.rating("fatigue_limit_load").value

    @property
    def given(self) -> dict[str, Rating]:
        """Ratings that the case gives, by their keys."""
        return {name: self.rating(name) for name in LETTERS if getattr(self.life, name) is not None}

    # -- the oil ---------------------------------------------------------------------------------

    @property
    def kappa(self) -> float:
        """Viscosity ratio of ISO 281 [-]; raises `OutOfRange` beyond the data of the oil."""
        assert self.viscosity is not None  # checked on reading
        return float(viscosity_ratio(self.viscosity()[0], self.speed, self.pitch_diameter))

    @property
    def known_kappa(self) -> float | None:
        """The same; None without an oil, at rest, and beyond its data."""
        if self.viscosity is None or not self.speed or why_none(self.viscosity):
            return None
        return self.kappa

    @property
    def by_oil(self) -> bool:
        """Whether the life has the factor a_ISO."""
        return self.life.lubrication == "a_ISO"

    @property
    def rated_kappa(self) -> float | None:
        """Viscosity ratio of a life with a_ISO [-]; None as `known_kappa` is."""
        return self.known_kappa if self.by_oil else None

    @property
    def fatigue_share(self) -> float:
        """Fatigue load limit of all rows that hard particles leave [N]."""
        left = contamination_factor(self.kappa, self.pitch_diameter, CLEANLINESS[str(self.life.cleanliness)])
        return float(left) * self.rows * self.fatigue_limit

    def oil_factors(self, load: float, parts: LoadedParts | None = None) -> Iterator[LifeFactor]:
        """a_ISO at an equivalent load [N], where the life has it; of each part where the case says so."""
        if not self.by_oil:
            return
        ratio, share = self.kappa, self.fatigue_share / load
        if parts is not None and self.life.modification != "bearing":
            once = float(modification_factor(ratio, share, self.elements).value)
            factor = modification_of_parts(ratio, self.fatigue_share, *parts, self.elements)
            words = f"of {self.life.modification}, {once:.4g} once for the bearing; kappa {ratio:.3g}"
            yield explained(factor, words)
            return
        words = f"kappa {ratio:.3g}, e_C C_u/P {share:.3g}, equivalent load {load:.4g} N"
        factor = explained(modification_factor(ratio, share, self.elements), words)
        slope = float(modification_slope(ratio, share, self.elements)) / self.exponent
        yield replace(factor, life_exponent=0.0 if self.life_by_rating else slope)

    # -- lives -----------------------------------------------------------------------------------

    @property
    def unrated(self) -> str:
        """Why the life has no dynamic rating; empty where it has one, or needs none."""
        return why_none(lambda: self.dynamic) if self.needs_rating else ""

    @property
    def without_factor(self) -> str:
        """Why speed and oil have no a_ISO under any load; empty where they have, or none is required."""
        if not self.by_oil:
            return ""
        return why_none(lambda: modification_factor(self.kappa, self.fatigue_share, self.elements))

    @property
    def unmodified(self) -> str:
        """Why there is no modified life; empty where there is one, or none is required."""
        if self.life.is_basic:
            return ""
        by_load = why_none(self.load) if self.life_by_rating else ""
        return self.unrated or by_load or self.without_factor

    @property
    def life_by_rating(self) -> bool:
        """Whether the life is that of one load P."""
        return self.life.loads == "rating"

    @property
    def power(self) -> float:
        """Exponent of P in a life by ratings [-]."""
        return self.exponent if self.load_exponent is None else self.load_exponent

    def by_rating(self, load: float) -> float:
        """L_10 of a load P [N] by the rating of the case [10^6 revolutions]."""
        return float(rating_life(self.rating_factor * self.dynamic, load, self.power))

    @property
    def lived(self) -> float | None:
        """Life by ratings alone [rev], which needs no equilibrium; None where loads or films count.

        None, too, where ISO 281 has no such life.
        """
        if not self.life_by_rating or self.life.lubrication == "film" or self.unmodified:
            return None
        load = self.load().value
        return LifeOfState.of(self.by_rating(load), (), (*self.oil_factors(load), *self.fixed)).modified

    @property
    def fixed(self) -> list[LifeFactor]:
        """Factors that the loads do not change."""
        return [*self.material, *of_reliability(self.life.reliability)]

    @property
    def notes(self) -> tuple[Note, ...]:
        """What keeps the life away, and what must be known of its oil; none at rest."""
        if not self.speed:
            return ()
        lines, kappa = no_life(self.unrated, self.unmodified, self.rated_kappa), self.rated_kappa
        return lines if kappa is None or self.viscosity is None else lines + self.viscosity()[1]

    def reference_load(self, basic: float) -> float:
        """Load that gives a life [10^6 revolutions] by C_r of all rows [N]."""
        return float(reference_load(basic, self.rows_rating * self.dynamic, self.exponent))

    def modified(self, basic: float, parts: LoadedParts | None) -> LifeOfState | None:
        """The life of a state after every factor; None where nothing modifies it, or a factor does not hold.

        The basic life is that by the loads of all elements [10^6 revolutions], the sum over its parts.
        """
        if self.life.is_basic or self.unmodified:
            return None
        by_loads, load = [], self.reference_load(basic)
        if self.life_by_rating:
            load = self.load().value
            note = f"ISO 281: (C_r/P)^{POWERS.get(self.exponent, '(10/3)')}"
            by_loads.append(Factor("rating", self.by_rating(load) / basic, BY_LOADS, note, 0.0))
            return LifeOfState.of(basic, by_loads, (*self.oil_factors(load), *self.fixed))
        return LifeOfState.of(basic, by_loads, (*self.oil_factors(load, parts), *self.fixed))

    # -- the page of a catalogue -----------------------------------------------------------------

    def page(self, hours: float) -> Ratings:
        """What a catalogue says of the bearing and its load; with the hours of 10^6 revolutions."""
        load, at_rest, given = self.load(), self.static_load(), self.given
        lived = float(rating_life(self.dynamic, load.value, self.exponent))
        each = {letter: self.rating(name) for name, letter in LETTERS.items()}
        return Ratings(
            ratings_N={"C_r": self.dynamic, "C_0r": self.static, "C_u": self.fatigue_limit},
            given=[LETTERS[name] for name in given],
            scales={LETTERS[name]: rating.scale for name, rating in given.items()},
            formulas_N={letter: rating.formula_or_none for letter, rating in each.items()},
            load_N=load.value,
            equivalent_load=self._made_of(load, at_rest),
            static_safety=float(static_safety(self.static, at_rest.value)),
            life_Mrev=lived,
            life_h=lived * hours,
            **self._by_oil(load.value, lived, hours),
        )

    def _made_of(self, load: EquivalentLoad, at_rest: EquivalentLoad) -> dict[str, Any] | None:
        """What P and P_0 are made of; None of bearings that carry one load only."""
        if self.forces is None:
            return None
        radial, axial = self.forces
        return {
            "F_r_N": radial, "F_a_N": axial,
            "e": load.limit, "X": load.radial_factor, "Y": load.axial_factor, "note": load.note,
            "X_0": at_rest.radial_factor, "Y_0": at_rest.axial_factor, "P_0_N": at_rest.value,
        }  # fmt: skip

    def _by_oil(self, load: float, lived: float, hours: float) -> dict[str, Any]:
        """Modified rating life of ISO 281, where the case says how clean the oil is."""
        kappa = self.rated_kappa
        if kappa is None:
            return {}
        if self.unmodified:
            return {"viscosity_ratio": kappa}
        factor = float(modification_factor(kappa, self.fatigue_share / load, self.elements).value)
        return {
            "viscosity_ratio": kappa, "a_ISO": factor, "modified_Mrev": lived * factor,
            "modified_h": lived * factor * hours,
        }  # fmt: skip
