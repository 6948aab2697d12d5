"""How a raceway changes with the dimensions and moduli of its part, near given forces."""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from fem.parts.material import ImpossiblePart
from fem.parts.resolution import Shape
from fem.raceway.compliance import RacewayCompliance, combined
from flexbearing.build.expansion import roller_length
from flexbearing.build.ring_parts import NAMES, Race, part_of
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.derivatives.shape_numbers import numbers, with_numbers
from flexbearing.derivatives.stencil import STENCILS
from flexbearing.rings.condensed import named_failures

STEP = 1e-4  # of the dimension that changes most: differences are exact to about 1e-6
SAME = 1e-6  # between directions of change that are taken as one: some digits are lost in small steps


class RingChanged(Exception):
    """A key gives a flexible ring other faces, so that it is another ring."""


def shape_of(case: Case, race: Race) -> Shape | None:
    """Part of a raceway with the band that rollers load; None where it is rigid.

    Raises
    ------
    BadCase
        where there is no such part
    """
    with named_failures(case, NAMES[race]):
        part = part_of(case, race)
    return None if part is None else Shape(part=part, length=roller_length(case))


@dataclass(frozen=True)
class RingSlopes:
    """A raceway and its derivatives along changes of its shape, each computed when it is first wanted."""

    shape: Shape
    raceway: RacewayCompliance
    of_shape: Callable[[Shape], RacewayCompliance]  # the raceway of another shape, on moved nodes
    _known: list[tuple[NDArray, list[float], list[RacewayCompliance]]] = field(default_factory=list)

    def near(self, shape: Shape) -> RacewayCompliance:
        """The raceway of a shape near by, to first order.

        Raises
        ------
        RingChanged
            for one with other faces
        ImpossiblePart, BadCase
            where the dimensions have no room to change
        """
        if shape == self.shape:
            return self.raceway
        change = self._change(shape)
        size = np.abs(change).max()
        weights, raceways = self._slope(change / size)
        return combined([self.raceway, *raceways], [1.0, *(size / STEP * weight for weight in weights)])

    def _change(self, shape: Shape) -> NDArray:
        """Change of every number, over the number."""
        old, new = numbers(self.shape), numbers(shape)
        if old.keys() != new.keys() or with_numbers(self.shape, new) != shape:
            raise RingChanged
        return np.array([(new[name] - value) / self._size(value) for name, value in old.items()])

    def _size(self, value: float) -> float:
        return abs(value) or self.shape.length

    def _slope(self, direction: NDArray) -> tuple[list[float], list[RacewayCompliance]]:
        """Weights of raceways whose sum is the change along a direction by `STEP`; they add up to zero."""
        for known, weights, raceways in self._known:
            for sign in (1.0, -1.0):
                if np.abs(known - sign * direction).max() <= SAME:
                    return [sign * weight for weight in weights], raceways
        weights, raceways = self._differences(direction)
        self._known.append((direction, weights, raceways))
        return weights, raceways

    def _differences(self, direction: NDArray) -> tuple[list[float], list[RacewayCompliance]]:
        why: Exception | None = None
        for stencil in STENCILS:
            try:
                shapes = [self._moved(place * STEP * direction) for place in stencil.places]
                return list(stencil.weights), [self.of_shape(each) for each in shapes]
            except (ImpossiblePart, BadCase) as refusal:
                why = refusal
        assert why  # there is a stencil
        raise why

    def _moved(self, change: NDArray) -> Shape:
        """The shape with every number changed by a share of it."""
        old = numbers(self.shape)
        pairs = zip(old.items(), change, strict=True)
        return with_numbers(
            self.shape, {name: value + share * self._size(value) for (name, value), share in pairs}
        )
