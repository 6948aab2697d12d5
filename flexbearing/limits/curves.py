"""Limiting static loads of a four-point bearing: axial load against moment, a curve for each radial load."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.progress import Report
from flexbearing.runs import four_point
from quasidynamic import OutOfRange
from quasidynamic.balance.balls.elastic_grooves import ElasticGrooves
from quasidynamic.outcome.limiting_load import LIMITS, StaticLimits, limit_shares, limiting_scale
from quasidynamic.parts.ball import FourPointBearing
from quasidynamic.solve.balls.elastic_load_distribution import elastic_ball_loads
from quasidynamic.solve.balls.load_distribution import BallLoads, ball_loads

STRAIGHT, DEEPEST = 2.5e-3, 5  # of the load: lines between points off direct solutions; halvings
SENSES = {1: "with the radial load", -1: "against the radial load"}  # of the moment, at its most loaded ball


class LimitPoint(NamedTuple):
    """A load that a bearing just bears."""

    radial: float  # [N]
    axial: float  # [N]
    moment: float  # [N m]
    sense: int  # of the moment, see `SENSES`
    limited_by: str  # one of `LIMITS`


@dataclass(frozen=True)
class LimitCurves:
    """Points of a bearing, curve by curve, each from thrust alone to a moment alone."""

    title: str
    limits: StaticLimits
    points: tuple[tuple[LimitPoint, ...], ...]

    def rows(self) -> Iterator[tuple[float | str, ...]]:
        """All points for people: loads [kN], moment [kN m], its sense, what limits it."""
        for point in (point for curve in self.points for point in curve):
            loads = (1e-3 * each for each in point[:3])
            yield *loads, SENSES[point.sense], point.limited_by


@dataclass(frozen=True)
class LimitedBearing:
    """A bearing whose balls share any load, and what its contacts bear."""

    bearing: FourPointBearing
    rings: ElasticGrooves | None
    limits: StaticLimits

    @classmethod
    def of(cls, case: FourPointCase, limits: StaticLimits, report: Report) -> "LimitedBearing":
        """The bearing of a case, with its elastic rings.

        Raises `BadCase` where the case has a single ball.
        """
        if case.bearing.balls is None:
            raise BadCase(f"{case.source.path}: bearing.balls is needed: a ring has limiting loads")
        return cls(four_point.bearing(case).bearing, four_point.elastic_rings(case, report), limits)

    def shares(self, radial: float, axial: float, moment: float) -> NDArray:
        """How far it is loaded (3), in the order of `LIMITS` [-]."""
        load = np.array([axial, 0.0, radial, moment, 0.0])
        balls = self._balls(load)
        return limit_shares(self.bearing, balls.loads, balls.angles, self.limits)

    def _balls(self, load: NDArray) -> BallLoads:
        whole = replace(self.bearing, groove_ends=(np.inf, np.inf))  # cut contacts are beyond a limit
        if self.rings is None:
            return ball_loads(whole, load)
        return elastic_ball_loads(whole, load, self.rings)

    def point(
        self, radial: float, direction: tuple[float, float], first: float = 1.0
    ) -> tuple[float, LimitPoint]:
        """The limit along a thrust [N] with a moment [N m], and its scale, for the worse of both senses.

        The search begins at the scale `first`. Raises `OutOfRange` where the radial load alone is beyond a
        limit; `NotSolved`.
        """
        senses = SENSES if radial and direction[1] else (1,)
        return min(self._of_sense(radial, direction, sense, first) for sense in senses)

    def _of_sense(
        self, radial: float, direction: tuple[float, float], sense: int, first: float
    ) -> tuple[float, LimitPoint]:
        axial, moment = direction

        def shares(scale: float) -> NDArray:
            return self.shares(radial, scale * axial, sense * scale * moment)

        scale = limiting_scale(lambda scale: float(shares(scale).max()), first)
        limited_by = LIMITS[shares(scale).argmax()]
        return scale, LimitPoint(radial, scale * axial, scale * moment, sense, limited_by)

    def curve(self, radial: float, points: int, *, refined: bool = False) -> Iterator[LimitPoint]:
        """Points from thrust alone to a moment alone, evenly spaced by their angle seen from the origin.

        A refined curve has further ones between them until straight lines are near, also where another ball
        or the other sense of the moment becomes the worse one.
        """
        thrust = self.bearing.balls * np.sin(self.bearing.contact_angle) * self._pressed_load
        moment = thrust * self.bearing.pitch_diameter / 8  # loads balls about as the thrust does
        ends = self.point(radial, (thrust, 0.0)), self.point(radial, (0.0, moment))
        axes = ends[0][1].axial, ends[1][1].moment

        def seen(angle: float, first: float) -> tuple[float, float, LimitPoint]:
            direction = axes[0] * float(np.cos(angle)), axes[1] * float(np.sin(angle))
            return angle, *self.point(radial, direction, first)

        last = (0.0, 1.0, ends[0][1])
        yield last[2]
        for angle in np.linspace(0.0, np.pi / 2, points)[1:]:
            found = seen(float(angle), last[1]) if angle < np.pi / 2 else (np.pi / 2, 1.0, ends[1][1])
            if refined:
                yield from _between(seen, last, found, DEEPEST)
            yield found[2]
            last = found

    @property
    def _pressed_load(self) -> float:
        """Load of a contact at the largest pressure, at the contact angle without load [N]."""
        angles = np.full(2, self.bearing.contact_angle)
        limits = StaticLimits(safety=self.limits.safety)
        return float(limit_shares(self.bearing, np.ones(2), angles, limits)[0]) ** -3


Seen = tuple[float, float, LimitPoint]  # a point with its angle and the scale, its distance, over the ends


def _between(
    seen: Callable[[float, float], Seen], one: Seen, other: Seen, depth: int
) -> Iterator[LimitPoint]:
    """Points between two, as many as straight lines need to be within `STRAIGHT`."""
    angle = (one[0] + other[0]) / 2
    middle = seen(angle, one[1])
    near, far = (np.array([np.cos(each[0]), np.sin(each[0])]) * each[1] for each in (one, other))
    along = np.array([np.cos(angle), np.sin(angle)])
    line = np.linalg.solve(np.column_stack([along, near - far]), near)[0]
    split = abs(line / middle[1] - 1) > STRAIGHT and depth > 0
    if split:
        yield from _between(seen, one, middle, depth - 1)
    yield middle[2]
    if split:
        yield from _between(seen, middle, other, depth - 1)


def limit_curves(
    case: FourPointCase,
    radial_loads: Sequence[float],
    points: int,
    limits: StaticLimits,
    report: Report,
) -> LimitCurves:
    """Curves of a case for some radial loads [N].

    Raises `BadCase` where a radial load alone is beyond a limit, and for a bearing without a ring of balls;
    `NotSolved` where the balls do not find how they share a load.
    """
    limited = LimitedBearing.of(case, limits, report)
    found = list[tuple[LimitPoint, ...]]()
    for number, radial in enumerate(radial_loads):
        points_done = list[LimitPoint]()
        try:
            for point in limited.curve(radial, points, refined=True):
                points_done.append(point)
                done = number + min(len(points_done) / (2 * points), 1.0)
                report.stage("limiting loads", done / len(radial_loads))
        except OutOfRange as problem:
            raise BadCase(f"{case.source.path}: radial load {radial / 1e3:.4g} kN: {problem}") from None
        found.append(tuple(points_done))
    return LimitCurves(case.title, limits, tuple(found))
