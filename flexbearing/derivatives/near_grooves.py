"""Elastic grooves of cases that differ a little from one that is solved."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.derivatives.ring_slopes import RingSlopes
from flexbearing.progress import Silent
from flexbearing.rings.grooves import RACES, groove_of_shape, shape_of
from quasidynamic.balance.balls.elastic_grooves import ElasticGroove, ElasticGrooves

# Of the dimension that changes most: grooves are meshed anew, as moved nodes would not follow their arcs.
# Compliances of neighbouring meshes scatter by about 1e-6, slopes then by about 1e-4.
STEP = 5e-3


@dataclass(frozen=True)
class NearGrooves:
    """Grooves of a case, and what other cases change of them; turned by their azimuths they are the same."""

    case: FastCase
    grooves: ElasticGrooves
    azimuths: NDArray  # (Z) of the balls [rad]

    def of(self, case: FastCase) -> ElasticGrooves:
        """Grooves of another case, to first order.

        Raises `RingChanged` where an elastic ring has other faces; `ImpossiblePart`, `BadCase`, `NotSolved`
        where the dimensions of a ring have no room to change.
        """
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


def combined(grooves: Sequence[ElasticGroove], weights: Sequence[float]) -> ElasticGroove:
    """Weighted sum of grooves with the same number of stations; weights add up to one."""
    return ElasticGroove(
        *(
            np.tensordot(weights, [getattr(groove, name) for groove in grooves], 1)
            for name in ("angles", "compliance", "initial")
        )
    )
