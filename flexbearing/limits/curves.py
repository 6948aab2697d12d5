"""Limiting static loads of a four-point bearing: axial load against moment, a curve for each radial load."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
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
        return limit_shares(self.bearing, self._balls(load), self.limits)

    def _balls(self, load: NDArray) -> BallLoads:
        if self.rings is None:
            return ball_loads(self.bearing, load)
        return elastic_ball_loads(self.bearing, load, self.rings)

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

    def curve(self, radial: float, points: int) -> Iterator[LimitPoint]:
        """Points from thrust alone to a moment alone, evenly spaced by their angle seen from the origin."""
        thrust = self.bearing.balls * np.sin(self.bearing.contact_angle) * self._pressed_load
        _, first = self.point(radial, (thrust, 0.0))
        _, last = self.point(radial, (0.0, thrust * self.bearing.pitch_diameter / 8))
        yield first
        scale = 1.0
        for angle in np.linspace(0.0, np.pi / 2, points)[1:-1]:
            direction = first.axial * float(np.cos(angle)), last.moment * float(np.sin(angle))
            scale, point = self.point(radial, direction, scale)
            yield point
        yield last

    @property
    def _pressed_load(self) -> float:
        """Load of a contact at the largest pressure, at the contact angle without load [N]."""
        one = BallLoads(
            np.zeros((1, 1)), np.ones((1, 1)), np.full((1, 1), self.bearing.contact_angle), np.zeros(5),
            np.zeros((5, 5)), 0.0, 0,
        )  # fmt: skip
        return float(limit_shares(self.bearing, one, StaticLimits(safety=self.limits.safety))[0]) ** -3


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
            for point in limited.curve(radial, points):
                points_done.append(point)
                done = (number + len(points_done) / points) / len(radial_loads)
                report.stage("limiting loads", done)
        except OutOfRange as problem:
            raise BadCase(f"{case.source.path}: radial load {radial / 1e3:.4g} kN: {problem}") from None
        found.append(tuple(points_done))
    return LimitCurves(case.title, limits, tuple(found))
