"""From the cold clearance of a bearing to its clearance in operation."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise
from math import isfinite, pi
from typing import Literal

from quasidynamic.clearance.annulus import Annulus, heat_displacement
from quasidynamic.clearance.press_fit import (
    FitConditions,
    PressFit,
    Seat,
    free_displacement,
    inside_displacement,
    outside_displacement,
    seat,
)
from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class Mounting:
    """A bearing with what it is mounted on."""

    cold_clearance: float  # [m] diametral, before mounting, at the reference temperature
    shaft_fit: PressFit  # shaft inside, inner ring outside
    outer: PressFit | Annulus  # outer ring inside a housing, or a ring free in a squirrel cage
    rolling_element: Annulus  # a roller, or the section of a ball
    element: Literal["roller", "ball"] = "roller"

    def __post_init__(self):
        room = 2 * (self.outer_ring.inner_radius - self.inner_ring.outer_radius)
        need = 4 * self.rolling_element.outer_radius + self.cold_clearance
        if not abs(room - need) < 0.2 * self.rolling_element.outer_radius:
            raise ImpossiblePart(
                f"mounting: the raceways leave {1e3 * room:.6g} mm on the diameter, two {self.element}s with "
                f"the cold clearance take {1e3 * need:.6g} mm; they must agree within a tenth of the "
                f"{self.element} diameter"
            )

    @property
    def inner_ring(self) -> Annulus:
        """The ring on the shaft, its raceway outside."""
        return self.shaft_fit.outside

    @property
    def outer_ring(self) -> Annulus:
        """The ring around the rolling elements, its raceway inside."""
        return self.outer.inside if isinstance(self.outer, PressFit) else self.outer


@dataclass(frozen=True, kw_only=True)
class OperatingConditions:
    """Temperatures [K], of which only differences matter, with the speeds of the rings."""

    reference: float  # [K] at which the cold clearance and the interferences were measured
    shaft: float  # [K]
    inner_ring: float  # [K]
    rolling_elements: float  # [K]
    outer_ring: float  # [K]
    housing: float | None = None  # [K] only where there is one
    inner_speed: float = 0.0  # [rad/s] shaft with inner ring
    outer_speed: float = 0.0  # [rad/s] outer ring with housing

    def __post_init__(self):
        for name in ("reference", "shaft", "inner_ring", "rolling_elements", "outer_ring"):
            require_positive(f"operating.{name}", getattr(self, name))
        if self.housing is not None:
            require_positive("operating.housing", self.housing)
        for name in ("inner_speed", "outer_speed"):
            if not isfinite(getattr(self, name)):
                raise ImpossiblePart(f"operating.{name} = {getattr(self, name)} must be a finite number")

    @property
    def shaft_fit(self) -> FitConditions:
        """Of the shaft inside the inner ring."""
        return FitConditions(
            inside_rise=self.shaft - self.reference,
            outside_rise=self.inner_ring - self.reference,
            speed=self.inner_speed,
        )

    @property
    def outer_fit(self) -> FitConditions:
        """Of the outer ring inside its housing; without one both bodies are as warm as the ring."""
        housing = self.outer_ring if self.housing is None else self.housing
        return FitConditions(
            inside_rise=self.outer_ring - self.reference,
            outside_rise=housing - self.reference,
            speed=self.outer_speed,
        )


@dataclass(frozen=True)
class ClearanceStep:
    """One effect on the clearance."""

    name: str
    change: float  # [m] diametral, positive opens
    clearance: float  # [m] diametral, after this step; negative is a preload
    explanation: str


@dataclass(frozen=True, kw_only=True)
class OperatingClearance:
    """How a clearance came about, step by step."""

    cold: float  # [m] diametral, before mounting
    steps: tuple[ClearanceStep, ...]
    shaft_seat: Seat  # in operation
    housing_seat: Seat | None  # in operation; a free ring has none
    element: str = "roller"

    @property
    def clearance(self) -> float:
        """G [m], diametral, in operation; negative is a preload of the still undeformed rings."""
        return self.steps[-1].clearance

    @property
    def preloaded(self) -> bool:
        """Whether the rolling elements are wider than the room left for them."""
        return self.clearance < 0.0

    @property
    def verdict(self) -> str:
        """The result in words."""
        size = f"{abs(self.clearance) * 1e6:.1f} um diametral"
        if self.preloaded:
            return f"the bearing is preloaded: the {self.element}s interfere by {size}"
        return f"the bearing runs with a clearance of {size}"


@dataclass(frozen=True)
class RacewayExpansion:
    """Expansion of one raceway, and how its ring sits on the shaft or in the housing."""

    expansion: float = 0.0  # [m] of its radius
    seat: Seat | None = None

    @property
    def words(self) -> str:
        """The seat in one phrase."""
        return self.seat.words if self.seat else "free ring, no housing"


Expansion = Callable[[FitConditions], RacewayExpansion]


@dataclass(frozen=True)
class _Stage:
    """The bearing with the effects switched on so far."""

    name: str
    explanation: str
    inner: RacewayExpansion
    outer: RacewayExpansion
    element_expansion: float  # [m] of the diameter


def operating_clearance(
    mounting: Mounting,
    conditions: OperatingConditions,
    inner: Expansion | None = None,
    outer: Expansion | None = None,
) -> OperatingClearance:
    r"""Operating clearance as a chain of effects, each switched on after the one before.

    .. math:: G = G_0 + 2 u_o - 2 u_i - 2 \Delta D

    A fit may open on the way, so a step is the difference of two complete evaluations: its size
    depends on the order, the sum does not.

    Parameters
    ----------
    mounting : Mounting
        bearing, fits, G_0 the cold clearance [m]
    conditions : OperatingConditions
        temperatures [K], speeds [rad/s]
    inner, outer : callable, optional
        expansion [m] of a raceway and its seat under the conditions of its fit, such as finite elements give
        them; without it those of `mounting` in closed form

    Returns
    -------
    OperatingClearance
        steps whose changes add up to G - G_0 [m]; u_o, u_i expansion of the raceway radii,
        Delta D of the diameter of the rolling elements

    Raises
    ------
    ImpossiblePart
        when a housing has no temperature, or a temperature no housing

    Source
    ------
    Harris and Kotzalas, Essential Concepts of Bearing Technology (2006), ch. 3, with the thick rings
    of Timoshenko and Goodier, Theory of Elasticity (1970), art. 28, 32, in plane stress.

    Valid
    -----
    One temperature per body; no load of rolling elements on the rings; they do not expand by their speed.
    """
    _require_housing_temperature(mounting, conditions)
    inner, outer = inner or partial(_inner_raceway, mounting), outer or partial(_outer_raceway, mounting)
    stages = _stages(mounting, conditions, inner, outer)
    clearances = [
        mounting.cold_clearance
        + 2 * (stage.outer.expansion - stage.inner.expansion)
        - 2 * stage.element_expansion
        for stage in stages
    ]
    steps = tuple(
        ClearanceStep(stage.name, after - before, after, stage.explanation)
        for stage, (before, after) in zip(stages[1:], pairwise(clearances), strict=True)
    )
    return OperatingClearance(
        cold=mounting.cold_clearance,
        steps=steps,
        shaft_seat=stages[-1].inner.seat or seat(mounting.shaft_fit, conditions.shaft_fit),
        housing_seat=stages[-1].outer.seat,
        element=mounting.element,
    )


def _stages(
    mounting: Mounting, conditions: OperatingConditions, of_inner: Expansion, of_outer: Expansion
) -> list[_Stage]:
    """One more effect at a time; the first stage has none."""
    shaft, outer_fit = conditions.shaft_fit, conditions.outer_fit
    inner, inner_hot, inner_turning = (of_inner(step) for step in _history(shaft))
    outer, outer_hot, outer_turning = (of_outer(step) for step in _history(outer_fit))
    inner_heat = f"shaft {shaft.inside_rise:+.1f} K, inner ring {shaft.outside_rise:+.1f} K"
    outer_heat = f"outer ring {outer_fit.inside_rise:+.1f} K"
    if conditions.housing is not None:
        outer_heat += f", housing {outer_fit.outside_rise:+.1f} K"
    body, rise = mounting.rolling_element, conditions.rolling_elements - conditions.reference
    thicker = 2 * float(heat_displacement(body, body.outer_radius, rise))
    inner_speed, outer_speed = (f"{fit.speed * 30 / pi:.5g} rpm" for fit in (shaft, outer_fit))
    changes = (
        ("inner fit", f"mounted; {inner.words}", {"inner": inner}),
        ("outer fit", f"mounted; {outer.words}", {"outer": outer}),
        ("inner heat", f"{inner_heat}; {inner_hot.words}", {"inner": inner_hot}),
        ("outer heat", f"{outer_heat}; {outer_hot.words}", {"outer": outer_hot}),
        (f"{mounting.element} heat", f"{mounting.element}s {rise:+.1f} K", {"element_expansion": thicker}),
        ("inner rotation", f"{inner_speed}; {inner_turning.words}", {"inner": inner_turning}),
        ("outer rotation", f"{outer_speed}; {outer_turning.words}", {"outer": outer_turning}),
    )
    stages = [
        _Stage("cold", "before mounting", RacewayExpansion(), RacewayExpansion(), element_expansion=0.0)
    ]
    for name, explanation, change in changes:
        stages.append(replace(stages[-1], name=name, explanation=explanation, **change))
    return stages


def _history(turning: FitConditions) -> tuple[FitConditions, FitConditions, FitConditions]:
    """Mounted cold and standing; then hot; then turning."""
    return FitConditions(), replace(turning, speed=0.0), turning


def _inner_raceway(mounting: Mounting, conditions: FitConditions) -> RacewayExpansion:
    fit = mounting.shaft_fit
    return RacewayExpansion(
        outside_displacement(fit, conditions, mounting.inner_ring.outer_radius), seat(fit, conditions)
    )


def _outer_raceway(mounting: Mounting, conditions: FitConditions) -> RacewayExpansion:
    fit, ring = mounting.outer, mounting.outer_ring
    if isinstance(fit, Annulus):
        rise, speed = conditions.inside_rise, conditions.speed
        return RacewayExpansion(free_displacement(ring, ring.inner_radius, rise, speed))
    return RacewayExpansion(inside_displacement(fit, conditions, ring.inner_radius), seat(fit, conditions))


def _require_housing_temperature(mounting: Mounting, conditions: OperatingConditions) -> None:
    has_housing = isinstance(mounting.outer, PressFit)
    if has_housing and conditions.housing is None:
        raise ImpossiblePart(
            "operating.housing is missing: the outer ring sits in a housing, give its temperature"
        )
    if not has_housing and conditions.housing is not None:
        raise ImpossiblePart(
            f"operating.housing = {conditions.housing} K, but the outer ring is free; "
            "leave the temperature out"
        )
