"""Elastic grooves of cases that differ a little from one that is solved."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from fem.parts.probe import Probe
from fem.solid.probes import Readings
from flexbearing.build.probes import probes as probes_of
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.ring_room import Race
from flexbearing.derivatives.ring_slopes import RingChanged, RingSlopes
from flexbearing.progress import Silent
from flexbearing.rings.grooves import RACES, elastic_grooves, groove_of_shape, shape_of
from flexbearing.runs import probes
from flexbearing.runs.groove_fields import readings_of_shape
from quasidynamic import AngularContactState, NotSolved
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves
from quasidynamic.parts.angular_contact_bearing import azimuths_of_row

# Of the dimension that changes most: grooves are meshed anew, as moved nodes would not follow their arcs.
# Compliances of neighbouring meshes scatter by about 1e-6, slopes then by about 1e-4.
STEP = 5e-3


@dataclass(frozen=True)
class NearGrooves:
    """Grooves of a case, and what other cases change of them."""

    case: FastCase
    grooves: ElasticGrooves
    azimuths: NDArray  # (Z) of the balls [rad]

    def of(self, case: FastCase) -> ElasticGrooves:
        """Grooves of another case, to first order; under balls at other azimuths as they are there.

        Raises `RingChanged` where an elastic ring has other faces, or a drawn one another mesh;
        `ImpossiblePart`, `BadCase`, `NotSolved` where the dimensions of a ring have no room to change.
        """
        azimuths = azimuths_of_row(case.bearing.first_ball_azimuth, case.bearing.balls)
        if not np.array_equal(azimuths, self.azimuths):
            if case.outer.kind == "step":
                raise RingChanged("it meshes a drawn ring anew, for balls at other places")
            return elastic_grooves(case, azimuths, Silent()) or self.grooves
        shapes = (shape_of(case, race) for race in RACES)
        return ElasticGrooves(
            *(slopes and slopes.near(shape) for slopes, shape in zip(self._slopes, shapes, strict=True))
        )

    @cached_property
    def _slopes(self) -> list[RingSlopes[ElasticGroove] | None]:
        """Of both grooves; None of a rigid one."""
        of_shape = partial(groove_of_shape, self.case, azimuths=self.azimuths, report=Silent())
        return [
            groove and RingSlopes(shape_of(self.case, race), groove, of_shape, combined, STEP)
            for race, groove in zip(RACES, self.grooves, strict=True)
        ]


@dataclass(frozen=True)
class NearReadings:
    """What probes read of a case in some state, and what other cases and states change of it."""

    case: FastCase
    state: AngularContactState

    def of(self, case: FastCase, state: AngularContactState) -> Readings:
        """Readings of another case, to first order.

        Raises `NotSolved` where a ring is not solved; `RingChanged`, `ImpossiblePart`, `BadCase` as
        `NearGrooves.of`.
        """

        def near(race: Race, there: Sequence[Probe]) -> Readings:
            slopes, shape = self._slopes[race], shape_of(case, race)
            moved = readings_of_shape(case, state, slopes.shape, there)
            return _summed([moved, slopes.near(shape), slopes.raceway], [1.0, 1.0, -1.0])

        read = probes.readings(case, near)
        if isinstance(read, str):
            raise NotSolved(read, "not solved")
        return read

    @cached_property
    def _slopes(self) -> dict[Race, RingSlopes[Readings]]:
        """Of rings with probes, under the balls of this state."""
        return {
            race: self._slopes_of(race, list(there.values()))
            for race in RACES
            if (there := probes_of(self.case, race))
        }

    def _slopes_of(self, race: Race, there: Sequence[Probe]) -> RingSlopes[Readings]:
        shape = shape_of(self.case, race)
        assert shape  # as it has probes
        of_shape = partial(readings_of_shape, self.case, self.state, there=there)
        return RingSlopes(shape, of_shape(shape), of_shape, _summed, STEP)


def _summed(readings: Sequence[Readings], weights: Sequence[float]) -> Readings:
    return Readings(*(np.tensordot(weights, column, 1) for column in zip(*readings, strict=True)))


def combined(grooves: Sequence[ElasticGroove], weights: Sequence[float]) -> ElasticGroove:
    """Weighted sum of grooves with the same number of stations; weights add up to one."""
    return ElasticGroove(
        *(
            np.tensordot(weights, [getattr(groove, name) for groove in grooves], 1)
            for name in ("angles", "compliance", "initial")
        )
    )
