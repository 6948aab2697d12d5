"""Differences of second order, about a value or to one side of it."""

from typing import NamedTuple


class Stencil(NamedTuple):
    """Where a function is taken for its first derivative, in steps, and the weight of each place."""

    places: tuple[float, ...]
    weights: tuple[float, ...]


CENTRAL = Stencil((-1.0, 1.0), (-0.5, 0.5))
FORWARD = Stencil((0.0, 1.0, 2.0), (-1.5, 2.0, -0.5))
BACKWARD = Stencil((0.0, -1.0, -2.0), (1.5, -2.0, 0.5))
STENCILS = (CENTRAL, FORWARD, BACKWARD)  # the first that stays within the limits of a key is taken
