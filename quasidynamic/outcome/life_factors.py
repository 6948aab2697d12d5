"""Factors between the basic life and the life under real lubrication, steel and reliability."""

from dataclasses import dataclass, replace
from difflib import get_close_matches
from math import prod
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.capacity import MATERIAL_FACTOR, MILLIMETRE
from quasidynamic.outcome.raceway_damage import LINE, ContactFatigue

RPM = 2 * np.pi / 60  # [rad/s]
LEAST_VISCOSITY_RATIO, FULL_VISCOSITY_RATIO = 0.1, 4.0  # kappa of ISO 281
LARGEST_MODIFICATION = 50.0  # a_ISO
LEAST_RELIABILITY, LARGEST_RELIABILITY = 0.90, 0.9995  # of the a_1 table of ISO 281
LARGE = 500.0  # [mm] pitch diameter from which one class of grease has another c2
RELIABILITY_OFFSET = 0.05  # c, the part of the life without failures

FILM_RATIOS = (0.6, 0.8, 1.0, 1.1, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0)  # [-] STLE
FILM_FACTORS = (0.19, 0.28, 0.47, 1.00, 1.75, 2.13, 2.46, 2.62, 2.83, 2.88, 3.03)  # [-] STLE
CHEMISTRY = {"52100": 3.0, "M50": 2.0, "M50NiL": 4.0}  # [-] STLE
MELTING = {"air": 1.0, "CVD": 1.5, "VAR": 3.0, "VAR-VAR": 4.5, "VIM-VAR": 6.0}  # [-] STLE


@dataclass(frozen=True)
class Cleanliness:
    """How clean a lubricant is kept: the two constants of e_C."""

    rise: float  # [-] c1, for D_pw in mm
    loss: float  # [-] c2, for D_pw in mm
    loss_of_large: float | None = None  # [-] c2 from D_pw = 500 mm on, where that is another one


@dataclass(frozen=True)
class ModifiedBy:
    """Constants of a_ISO for one kind of rolling elements, see `modification_factor`."""

    largest: float  # [-] b
    thin: float  # [-] c below kappa = 0.4
    thick: float  # [-] c from there on
    film_power: float  # [-] m
    load_power: float  # [-] n
    power: float  # [-] q


ROLLERS = ModifiedBy(1.5859, 1.3993, 1.2348, 1.0, 0.4, 9.185)  # ISO 281 (2007), Eqs. 34-36
BALLS = ModifiedBy(2.5671, 2.2649, 1.9987, 0.83, 1 / 3, 9.3)  # ISO 281 (2007), Eqs. 31-33

# ISO 281 (2007), annex A.4 to A.6; oils by their code of ISO 4406
CLEANLINESS = {
    "oil, in-line filter, -/13/10": Cleanliness(0.0864, 0.5663),
    "oil, in-line filter, -/15/12": Cleanliness(0.0432, 0.9987),
    "oil, in-line filter, -/17/14": Cleanliness(0.0288, 1.6329),
    "oil, in-line filter, -/19/16": Cleanliness(0.0216, 2.3362),
    "oil, no or off-line filter, -/13/10": Cleanliness(0.0864, 0.6796),
    "oil, no or off-line filter, -/15/12": Cleanliness(0.0288, 1.141),
    "oil, no or off-line filter, -/17/14": Cleanliness(0.0133, 1.67),
    "oil, no or off-line filter, -/19/16": Cleanliness(0.00864, 2.5164),
    "oil, no or off-line filter, -/21/18": Cleanliness(0.00411, 3.8974),
    "grease, high cleanliness": Cleanliness(0.0864, 0.6796),
    "grease, normal cleanliness": Cleanliness(0.0432, 1.141),
    "grease, slight to typical contamination": Cleanliness(0.0177, 1.887, 1.677),
    "grease, severe contamination": Cleanliness(0.0115, 2.662),
    "grease, very severe contamination": Cleanliness(0.00617, 4.06),
}


@dataclass(frozen=True)
class LifeFactor:
    """A number the basic life is multiplied by, with what must be said about it."""

    name: str
    value: Any  # [-] float or array (...), > 0
    effect: Literal["lubrication", "material", "reliability"]  # what it accounts for
    note: str = ""  # where a limit was met, or what went in
    life_exponent: float | None = 0.0  # d ln factor / d ln life it multiplies; None where it is not known

    def __post_init__(self):
        if not np.all(np.isfinite(self.value) & (np.asarray(self.value) > 0)):
            raise OutOfRange(f"life factor {self.name} = {self.value} must be a finite number above zero")


@dataclass(frozen=True)
class ModifiedLife:
    """The basic life with every factor that was applied to it."""

    basic: Any  # [10^6 revolutions] float or array (...)
    factors: tuple[LifeFactor, ...] = ()

    def __post_init__(self):
        effects = [factor.effect for factor in self.factors]
        for effect in set(effects):
            if effects.count(effect) > 1:
                names = ", ".join(factor.name for factor in self.factors if factor.effect == effect)
                raise OutOfRange(f"{names} account for the same {effect}; choose one of them")

    @property
    def factor(self) -> Any:
        """Product of all factors [-]."""
        return prod((factor.value for factor in self.factors), start=1.0)

    @property
    def life(self) -> Any:
        """Modified life [10^6 revolutions]."""
        return self.basic * self.factor


def reference_viscosity(speed: ArrayLike, pitch_diameter: float) -> Any:
    r"""Kinematic viscosity that just separates the surfaces of an ordinary bearing.

    .. math:: \nu_1 = 45000\, n^{-0.83} D_{pw}^{-0.5} \;(n < 1000),\quad
              \nu_1 = 4500\, n^{-0.5} D_{pw}^{-0.5} \;(n \ge 1000) \quad \text{(mm2/s, 1/min, mm)}

    Parameters
    ----------
    speed : float or array (...)
        n, of one ring against the other [rad/s], either sign, not zero
    pitch_diameter : float
        D_pw [m], > 0

    Returns
    -------
    float or array (...)
        nu_1 [m2/s]

    Raises
    ------
    OutOfRange
        at rest, where no viscosity separates the surfaces

    Source
    ------
    ISO 281 (2007), section 9.3.3.

    Valid
    -----
    Ordinary surface finish, mineral oil. Falls by 2.3 % where the branches meet at 1000 1/min.
    """
    n = np.abs(speed) / RPM
    if not np.all(n > 0):
        raise OutOfRange("a bearing at rest has no reference viscosity; speed must not be zero")
    numerator = np.where(n < 1000, 45000 * n**-0.83, 4500 * n**-0.5)
    return (numerator * (pitch_diameter / MILLIMETRE) ** -0.5 * MILLIMETRE**2)[()]


def viscosity_ratio(viscosity: ArrayLike, speed: ArrayLike, pitch_diameter: float) -> Any:
    r"""Viscosity at work over the one that is needed.

    .. math:: \kappa = \nu / \nu_1

    Parameters
    ----------
    viscosity : float or array (...)
        nu, kinematic, at the temperature of the contact inlet [m2/s], > 0
    speed : float or array (...)
        of one ring against the other [rad/s], either sign, not zero
    pitch_diameter : float
        D_pw [m], > 0

    Returns
    -------
    float or array (...)
        kappa [-]

    Source
    ------
    ISO 281 (2007), section 9.3.3.

    Valid
    -----
    As `reference_viscosity`; the factors that use it hold from 0.1 on.
    """
    return np.asarray(viscosity)[()] / reference_viscosity(speed, pitch_diameter)


def contamination_factor(kappa: ArrayLike, pitch_diameter: float, cleanliness: Cleanliness) -> Any:
    r"""Share of the fatigue limit that hard particles leave.

    .. math:: e_C = \min(c_1 \kappa^{0.68} D_{pw}^{0.55}, 1)\, (1 - c_2 D_{pw}^{-1/3}) \quad \text{(mm)}

    Not a factor of the life itself: it enters `modification_factor`.

    Parameters
    ----------
    kappa : float or array (...)
        viscosity ratio [-], >= 0.1; above 4 as 4
    pitch_diameter : float
        D_pw [m], > 0
    cleanliness : Cleanliness
        c1, c2, such as `CLEANLINESS["oil, in-line filter, -/15/12"]`

    Returns
    -------
    float or array (...)
        e_C [-], 0 to 1

    Raises
    ------
    OutOfRange
        for kappa below 0.1, and for a pitch circle so small that e_C would be negative

    Source
    ------
    ISO 281 (2007), annex A.

    Valid
    -----
    kappa from 0.1. Kinks where the minimum is reached and at kappa = 4; one class of grease jumps by 3 % of
    e_C at 500 mm, as printed.
    """
    size, loss = pitch_diameter / MILLIMETRE, cleanliness.loss
    if cleanliness.loss_of_large is not None and size >= LARGE:
        loss = cleanliness.loss_of_large
    largest = 1 - loss * size ** (-1 / 3)
    if not largest > 0:
        least = loss**3
        raise OutOfRange(f"pitch diameter {size:.4g} mm: this cleanliness needs more than {least:.3g} mm")
    return np.minimum(cleanliness.rise * _rated(kappa) ** 0.68 * size**0.55, 1.0) * largest


def modification_factor(
    kappa: ArrayLike, load_ratio: ArrayLike, elements: ModifiedBy = ROLLERS
) -> LifeFactor:
    r"""Life modification factor a_ISO of radial bearings.

    .. math:: a_{ISO} = 0.1 \big[1 - (b - c/\kappa^p)^m (e_C C_u / P)^n\big]^{-q} \le 50

    ==========  ==============  ============  ========
    kappa       c of rollers    c of balls    p
    ==========  ==============  ============  ========
    0.1 to 0.4  1.3993          2.2649        0.054381
    0.4 to 1    1.2348          1.9987        0.19087
    1 to 4      1.2348          1.9987        0.071739
    ==========  ==============  ============  ========

    b = 1.5859, m = 1, n = 0.4, q = 9.185 of rollers; 2.5671, 0.83, 1/3, 9.3 of balls.

    Parameters
    ----------
    kappa : float or array (...)
        viscosity ratio [-], >= 0.1; above 4 as 4, with a note
    load_ratio : float or array (...)
        e_C C_u/P, fatigue limit left by the particles over the equivalent load [-], >= 0
    elements : ModifiedBy
        constants of `ROLLERS` or of `BALLS`

    Returns
    -------
    LifeFactor
        a_ISO [-], 0.1 to 50; a note says where a limit was met

    Raises
    ------
    OutOfRange
        for kappa below 0.1, where the standard stops, and for a negative load ratio

    Source
    ------
    ISO 281 (2007), Eqs. 31-36.

    Valid
    -----
    kappa from 0.1. Kinks at kappa = 0.4, 1 and 4, and
    at the limit of 50, which also stands for loads below the fatigue limit.
    """
    kappa = np.asarray(kappa)
    bracket = _fatigue_bracket(kappa, load_ratio, elements)
    least = _least_bracket(elements)
    notes = [
        "viscosity ratio above 4, rated as 4" * bool(np.any(kappa > FULL_VISCOSITY_RATIO)),
        "held at its limit of 50" * bool(np.any(bracket <= least)),
    ]
    value = 0.1 * np.maximum(bracket, least) ** -elements.power
    return LifeFactor("a_ISO", value[()], "lubrication", "; ".join(filter(None, notes)))


def modification_of_parts(
    kappa: float,
    fatigue_share: float,
    loads: NDArray,
    damages: NDArray,
    fatigue: ContactFatigue = LINE,
    elements: ModifiedBy = ROLLERS,
) -> LifeFactor:
    r"""a_ISO of every part of a bearing, slices of rollers or rows of balls, as one factor of the life.

    .. math:: a = \Big[\frac{\sum_k a_k^{-e}\, d_k}{\sum_k d_k}\Big]^{-1/e},\quad
              a_k = a_{ISO}\Big(\kappa, \frac{e_C C_u}{P_k}\Big)

    Parameters
    ----------
    kappa : float
        viscosity ratio [-], as of `modification_factor`
    fatigue_share : float
        e_C C_u of the bearing [N], > 0
    loads : array (...)
        P_k, equivalent load of each part [N], above zero where it has damage
    damages : array (...)
        d_k [10^6 revolutions to the power -e], one of them > 0
    fatigue : ContactFatigue
        e, by which damages add up, and p of L ~ P^(-p)
    elements : ModifiedBy
        constants of `ROLLERS` or of `BALLS`

    Returns
    -------
    LifeFactor
        a [-], between the least and the largest a_k; how it grows with the life where all loads do

    Source
    ------
    Formulas 14 (rows of balls) and 33 (slices of rollers) of ISO 16281 (2025) as a public program states
    them (CHOICHOI-KIMM/AI_Seminar); the text of the standard was not available. A row of balls has one
    a_ISO there, not each ball.

    Valid
    -----
    As `modification_factor`.

    >>> alike = modification_of_parts(1.0, 100.0, np.full(4, 1e3), np.ones(4)).value
    >>> bool(np.isclose(alike, modification_factor(1.0, 0.1).value, rtol=1e-12))
    True
    """
    loaded = damages > 0
    shares = damages[loaded] / damages[loaded].sum()
    ratios = fatigue_share / loads[loaded]
    each = modification_factor(kappa, ratios, elements).value
    worst = modification_factor(kappa, ratios.min(), elements)  # at its limit where all are
    failing = shares * each**-fatigue.weibull
    slope = np.average(modification_slope(kappa, ratios, elements), weights=failing) / fatigue.load_exponent
    return replace(worst, value=float(failing.sum() ** (-1 / fatigue.weibull)), life_exponent=float(slope))


def modification_slope(kappa: ArrayLike, load_ratio: ArrayLike, elements: ModifiedBy = ROLLERS) -> Any:
    r"""How a_ISO grows with the ratio of the loads.

    .. math:: \frac{d \ln a_{ISO}}{d \ln (e_C C_u / P)} = q\, n\, \frac{1 - B}{B}

    with the bracket B of `modification_factor`.

    It is zero where a_ISO is held at its limit of 50 [-].
    Raises `OutOfRange` as `modification_factor`, whose arguments it has.

    Source
    ------
    Derived here from ISO 281 (2007), Eqs. 31-36.

    Valid
    -----
    As `modification_factor`; one-sided at its kinks.

    >>> round(float(modification_slope(1.0, 0.1)), 4)
    0.597
    """
    bracket = _fatigue_bracket(np.asarray(kappa), load_ratio, elements)
    held = bracket <= _least_bracket(elements)
    free = np.where(held, 1.0, bracket)
    return (elements.power * elements.load_power * (1 - free) / free)[()]


def _fatigue_bracket(kappa: NDArray, load_ratio: ArrayLike, elements: ModifiedBy) -> NDArray:
    """1 - (b - c/kappa^p)^m (e_C C_u / P)^n."""
    load_ratio = np.asarray(load_ratio)
    if not np.all(load_ratio >= 0):
        raise OutOfRange(f"e_C C_u/P = {load_ratio} must not be negative")
    k = _rated(kappa)
    c = np.where(k < 0.4, elements.thin, elements.thick)
    p = np.where(k < 0.4, 0.054381, np.where(k < 1.0, 0.19087, 0.071739))
    film = (elements.largest - c / k**p) ** elements.film_power
    return 1 - film * load_ratio**elements.load_power


def _least_bracket(elements: ModifiedBy) -> float:
    """Below it a_ISO has reached its limit."""
    return (LARGEST_MODIFICATION / 0.1) ** (-1 / elements.power)


def film_factor(film_ratio: ArrayLike) -> LifeFactor:
    r"""Life factor of the film thickness over the roughness.

    Linear between the points of a table:

    ======  ====  ====  ====  ====  ====  ====  ====  ====  ====  ====  ====
    Lambda  0.6   0.8   1.0   1.1   1.5   2     3     4     6     8     10
    factor  0.19  0.28  0.47  1.00  1.75  2.13  2.46  2.62  2.83  2.88  3.03
    ======  ====  ====  ====  ====  ====  ====  ====  ====  ====  ====  ====

    Parameters
    ----------
    film_ratio : float or array (...)
        Lambda, least film over the root-mean-square roughness of both surfaces together [-], >= 0

    Returns
    -------
    LifeFactor
        factor [-], 0.19 to 3.03; a note says where an end of the table was held

    Raises
    ------
    OutOfRange
        for a negative film ratio

    Source
    ------
    STLE Life Factors for Rolling Bearings (Zaretsky, 1992) and Harris; the table as in a published program.

    Valid
    -----
    Lambda 0.6 to 10; outside, the end value is held and the note says so: below 0.6 the true life is
    shorter. Kinks at the points of the table.
    """
    ratio = np.asarray(film_ratio)
    if not np.all(ratio >= 0):
        raise OutOfRange(f"film ratio = {film_ratio} must not be negative")
    low, high = FILM_RATIOS[0], FILM_RATIOS[-1]
    notes = [
        f"film ratio below {low}, held at its factor; the life is shorter" * bool(np.any(ratio < low)),
        f"film ratio above {high}, held at its factor" * bool(np.any(ratio > high)),
    ]
    value = np.interp(ratio, FILM_RATIOS, FILM_FACTORS)
    return LifeFactor("film", value, "lubrication", "; ".join(filter(None, notes)), None)


def material_factor(
    steel: str, melting: str, *, process: float = 1.0, rating_factor: float = MATERIAL_FACTOR
) -> LifeFactor:
    r"""Life factor of the steel, its melting and its working.

    .. math:: a = a_{chemistry}\, a_{melting}\, a_{process} / b_m^4

    The capacities hold b_m for a modern steel already; the life goes with their fourth power.

    Parameters
    ----------
    steel : str
        one of `CHEMISTRY`
    melting : str
        one of `MELTING`
    process : float
        working of the metal [-], 1 for cylindrical rollers
    rating_factor : float
        b_m in the capacities that gave the basic life [-]

    Returns
    -------
    LifeFactor
        a [-], with a note of its parts

    Raises
    ------
    OutOfRange
        for a steel or a melting that is not in the tables

    Source
    ------
    STLE Life Factors for Rolling Bearings (Zaretsky, 1992); division by b_m^4 as in a published program.

    Valid
    -----
    For Lundberg-Palmgren capacities; ISO 281 has no such factor besides a_ISO.
    """
    chemistry, melt = _chosen("steel", steel, CHEMISTRY), _chosen("melting", melting, MELTING)
    parts = f"{steel} {chemistry:g}, {melting} {melt:g}, process {process:g}, b_m {rating_factor:g}"
    return LifeFactor("material", chemistry * melt * process / rating_factor**4, "material", parts)


def reliability_factor(reliability: ArrayLike) -> LifeFactor:
    r"""Life factor of a reliability above 90 %.

    .. math:: a_1 = (1 - c) \Big[\frac{\ln (1/S)}{\ln (1/0.9)}\Big]^{2/3} + c,\quad c = 0.05

    Parameters
    ----------
    reliability : float or array (...)
        S, probability of survival [-], 0.90 to 0.9995

    Returns
    -------
    LifeFactor
        a_1 [-], 1 at 90 %

    Raises
    ------
    OutOfRange
        outside 0.90 to 0.9995

    Source
    ------
    ISO 281 (2007), table 12, as its Weibull curve of three parameters.

    Valid
    -----
    S from 0.90 to 0.9995, the table's range.
    """
    s = np.asarray(reliability)
    if not np.all((s >= LEAST_RELIABILITY) & (s <= LARGEST_RELIABILITY)):
        raise OutOfRange(
            f"reliability = {reliability} is outside {LEAST_RELIABILITY} to {LARGEST_RELIABILITY}; "
            "give a probability, such as 0.99"
        )
    share = (np.log(s) / np.log(LEAST_RELIABILITY)) ** (2 / 3)
    return LifeFactor("a_1", ((1 - RELIABILITY_OFFSET) * share + RELIABILITY_OFFSET)[()], "reliability")


def _rated(kappa: ArrayLike) -> Any:
    """The viscosity ratio that ISO 281 uses: not below 0.1, above 4 as 4."""
    if not np.all(np.asarray(kappa) >= LEAST_VISCOSITY_RATIO):
        raise OutOfRange(
            f"viscosity ratio = {kappa} is below {LEAST_VISCOSITY_RATIO}, where ISO 281 stops; "
            "take a thicker oil, or the film factor"
        )
    return np.minimum(kappa, FULL_VISCOSITY_RATIO)


def _chosen(what: str, name: str, table: dict[str, float]) -> float:
    """Entry of a table, or an error that names the nearest."""
    if name not in table:
        near = get_close_matches(name, table, n=1, cutoff=0.4)
        hint = f" Did you mean {near[0]}?" if near else ""
        raise OutOfRange(f"{what} = {name!r} has no life factor; known: {', '.join(table)}.{hint}")
    return table[name]
