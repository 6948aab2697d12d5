"""From the cold clearance of a bearing to its clearance in operation."""

from dataclasses import dataclass, replace
from itertools import pairwise
from math import isfinite

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
    """A roller bearing with what it is mounted on."""

    cold_clearance: float  # [m] diametral, before mounting, at the reference temperature
    shaft_fit: PressFit  # shaft inside, inner ring outside
    outer: PressFit | Annulus  # outer ring inside a housing, or a ring free in a squirrel cage
    roller: Annulus

    def __post_init__(self):
        room = 2 * (self.outer_ring.inner_radius - self.inner_ring.outer_radius)
        need = 4 * self.roller.outer_radius + self.cold_clearance
        if not abs(room - need) < 0.2 * self.roller.outer_radius:
            raise ImpossiblePart(
                f"mounting: the raceways leave {room} m on the diameter, two rollers with the cold clearance "
                f"take {need} m; they must agree within a tenth of the roller diameter"
            )

    @property
    def inner_ring(self) -> Annulus:
        """The ring on the shaft, its raceway outside."""
        return self.shaft_fit.outside

    @property
    def outer_ring(self) -> Annulus:
        """The ring around the rollers, its raceway inside."""
        return self.outer.inside if isinstance(self.outer, PressFit) else self.outer


@dataclass(frozen=True, kw_only=True)
class OperatingConditions:
    """Temperatures [K], of which only differences matter, with the speeds of the rings."""

    reference: float  # [K] at which the cold clearance and the interferences were measured
    shaft: float  # [K]
    inner_ring: float  # [K]
    rollers: float  # [K]
    outer_ring: float  # [K]
    housing: float | None = None  # [K] only where there is one
    inner_speed: float = 0.0  # [rad/s] shaft with inner ring
    outer_speed: float = 0.0  # [rad/s] outer ring with housing

    def __post_init__(self):
        for name in ("reference", "shaft", "inner_ring", "rollers", "outer_ring"):
            require_positive(f"running.{name}", getattr(self, name))
        if self.housing is not None:
            require_positive("running.housing", self.housing)
        for name in ("inner_speed", "outer_speed"):
            if not isfinite(getattr(self, name)):
                raise ImpossiblePart(f"running.{name} = {getattr(self, name)} must be a finite number")


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

    @property
    def clearance(self) -> float:
        """G [m], diametral, in operation; negative is a preload of the still undeformed rings."""
        return self.steps[-1].clearance

    @property
    def preloaded(self) -> bool:
        """Whether the rollers are wider than the room left for them."""
        return self.clearance < 0.0

    @property
    def verdict(self) -> str:
        """The result in words."""
        size = f"{abs(self.clearance) * 1e6:.3f} um diametral"
        if self.preloaded:
            return f"the bearing is preloaded: the rollers interfere by {size}"
        return f"the bearing runs with a clearance of {size}"


@dataclass(frozen=True)
class _Raceway:
    """What has happened to one raceway so far."""

    growth: float = 0.0  # [m] of its radius
    seat: Seat | None = None

    @property
    def words(self) -> str:
        return self.seat.words if self.seat else "free ring, no housing"


@dataclass(frozen=True)
class _Stage:
    """The bearing with the effects switched on so far."""

    name: str
    explanation: str
    inner: _Raceway
    outer: _Raceway
    roller_growth: float  # [m] of the diameter


def operating_clearance(mounting: Mounting, running: OperatingConditions) -> OperatingClearance:
    r"""Operating clearance as a chain of effects, each switched on after the one before.

    .. math:: G = G_0 + 2 u_o - 2 u_i - 2 \Delta D

    A fit may open on the way, so a step is the difference of two complete evaluations: its size
    depends on the order, the sum does not.

    Parameters
    ----------
    mounting : Mounting
        bearing, fits, G_0 the cold clearance [m]
    running : OperatingConditions
        temperatures [K], speeds [rad/s]

    Returns
    -------
    OperatingClearance
        steps whose changes add up to G - G_0 [m]; u_o, u_i growth of the raceway radii,
        Delta D of the roller diameter

    Source
    ------
    Harris and Kotzalas, Essential Concepts of Bearing Technology (2006), ch. 3, with the thick rings
    of Timoshenko and Goodier, Theory of Elasticity (1970), art. 28, 32, in plane stress.

    Valid
    -----
    One temperature per body; no load of the rollers on the rings; rollers do not grow by their speed.
    """
    _require_housing_temperature(mounting, running)
    stages = _stages(mounting, running)
    values = [_clearance(mounting, stage) for stage in stages]
    steps = tuple(
        ClearanceStep(stage.name, after - before, after, stage.explanation)
        for stage, (before, after) in zip(stages[1:], pairwise(values), strict=True)
    )
    return OperatingClearance(
        cold=mounting.cold_clearance,
        steps=steps,
        shaft_seat=seat(mounting.shaft_fit, _shaft_states(running)[-1]),
        housing_seat=stages[-1].outer.seat,
    )


def _clearance(mounting: Mounting, stage: _Stage) -> float:
    raceways = stage.outer.growth - stage.inner.growth
    return mounting.cold_clearance + 2 * raceways - 2 * stage.roller_growth


def _stages(mounting: Mounting, running: OperatingConditions) -> list[_Stage]:
    """One more effect at a time; the first stage has none."""
    inner, inner_hot, inner_spun = _inner_raceways(mounting, running)
    outer, outer_hot, outer_spun = _outer_raceways(mounting, running)
    roller, rise = mounting.roller, running.rollers - running.reference
    growth = 2 * float(heat_displacement(roller, roller.outer_radius, rise))
    changes = (
        ("inner fit", f"mounted; {inner.words}", {"inner": inner}),
        ("outer fit", f"mounted; {outer.words}", {"outer": outer}),
        ("inner heat", f"{_inner_heat(running)}; {inner_hot.words}", {"inner": inner_hot}),
        ("outer heat", f"{_outer_heat(running)}; {outer_hot.words}", {"outer": outer_hot}),
        ("roller heat", f"rollers {rise:+.1f} K", {"roller_growth": growth}),
        ("inner rotation", f"{running.inner_speed:.1f} rad/s; {inner_spun.words}", {"inner": inner_spun}),
        ("outer rotation", f"{running.outer_speed:.1f} rad/s; {outer_spun.words}", {"outer": outer_spun}),
    )
    stages = [_Stage("cold", "before mounting", _Raceway(), _Raceway(), roller_growth=0.0)]
    for name, explanation, change in changes:
        stages.append(replace(stages[-1], name=name, explanation=explanation, **change))
    return stages


def _inner_raceways(mounting: Mounting, running: OperatingConditions) -> list[_Raceway]:
    """The inner raceway mounted, then hot, then turning."""
    fit, radius = mounting.shaft_fit, mounting.inner_ring.outer_radius
    states = _shaft_states(running)
    return [_Raceway(outside_displacement(fit, state, radius), seat(fit, state)) for state in states]


def _outer_raceways(mounting: Mounting, running: OperatingConditions) -> list[_Raceway]:
    """The outer raceway mounted, then hot, then turning."""
    fit, ring, states = mounting.outer, mounting.outer_ring, _outer_states(running)
    radius = ring.inner_radius
    if isinstance(fit, Annulus):
        return [_Raceway(free_displacement(ring, radius, state.inside_rise, state.speed)) for state in states]
    return [_Raceway(inside_displacement(fit, state, radius), seat(fit, state)) for state in states]


def _shaft_states(running: OperatingConditions) -> tuple[FitConditions, ...]:
    shaft, ring = running.shaft - running.reference, running.inner_ring - running.reference
    return _history(shaft, ring, running.inner_speed)


def _outer_states(running: OperatingConditions) -> tuple[FitConditions, ...]:
    housing = running.outer_ring if running.housing is None else running.housing
    return _history(running.outer_ring - running.reference, housing - running.reference, running.outer_speed)


def _history(inside_rise: float, outside_rise: float, speed: float) -> tuple[FitConditions, ...]:
    """Cold, standing; then hot; then turning."""
    hot = FitConditions(inside_rise=inside_rise, outside_rise=outside_rise)
    return FitConditions(), hot, replace(hot, speed=speed)


def _inner_heat(running: OperatingConditions) -> str:
    shaft, ring = running.shaft - running.reference, running.inner_ring - running.reference
    return f"shaft {shaft:+.1f} K, inner ring {ring:+.1f} K"


def _outer_heat(running: OperatingConditions) -> str:
    ring = f"outer ring {running.outer_ring - running.reference:+.1f} K"
    if running.housing is None:
        return ring
    return f"{ring}, housing {running.housing - running.reference:+.1f} K"


def _require_housing_temperature(mounting: Mounting, running: OperatingConditions) -> None:
    has_housing = isinstance(mounting.outer, PressFit)
    if has_housing and running.housing is None:
        raise ImpossiblePart(
            "running.housing is missing: the outer ring sits in a housing, give its temperature"
        )
    if not has_housing and running.housing is not None:
        raise ImpossiblePart(
            f"running.housing = {running.housing} K, but the outer ring is free; leave the temperature out"
        )
