"""Starts of cases from solved ones around them, which may differ in anything."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

PRINCIPAL = 0.01  # of the largest variation: smaller ones are no coordinate
SEED = 15  # of an order that shall be without order, and the same at every call
NUGGET = 1e-3  # squared, of the distance of the furthest neighbour: closer ones count alike
ALIKE = 1e-9  # distance of cases that are nearly the same
STIFFENING = 1e-12  # of the moments of the neighbours, where they do not span all coordinates
AT_ONCE = 100_000  # coordinates of differences, which fit into the processor's cache
SPARE = 1.5  # neighbours over terms of a fit


class Weights(NamedTuple):
    """Values at n places as weighted sums of those at k solved places around each."""

    neighbours: NDArray  # (n, k) which of the solved, the nearest first
    weights: NDArray  # (n, k) [-]

    def take(self, places: NDArray) -> "Weights":
        """Weights at some of the places."""
        return Weights(self.neighbours[places], self.weights[places])

    def of(self, values: NDArray) -> NDArray:
        """Values (n, N) from those of all solved places (S, N)."""
        return (self.weights[:, None] @ values[self.neighbours])[:, 0]


def coordinates(numbers: NDArray, arrays: NDArray | None = None) -> NDArray:
    """Coordinates (C, P) of cases between 0 and 1; one that is zero if nothing differs.

    They are the largest principal components of what differs: numbers that follow from one another, such as
    the properties of an oil from its temperature, share one.
    """
    scales = [np.log(column) if column.min() > 0 else column for column in numbers.T]
    if arrays is not None:
        scales += list(_principal(arrays.reshape(len(arrays), -1)).T)
    scales = [column for column in scales if np.ptp(column) > 0]  # a last digit may be lost by the logarithm
    if not scales:
        return np.zeros((len(numbers), 1))
    return _scaled(_principal(_scaled(np.transpose(scales))))


def _principal(values: NDArray) -> NDArray:
    """Largest principal components (C, P) of values (C, n)."""
    components, sizes, _ = np.linalg.svd(values - values.mean(0), full_matrices=False)
    some = (sizes > PRINCIPAL * sizes[0]) & (sizes > 0)
    return components[:, some] * sizes[some]


def _scaled(columns: NDArray) -> NDArray:
    return (columns - columns.min(0)) / np.ptp(columns, axis=0)


def spread_out(places: NDArray, count: int) -> NDArray:
    """Order (C) of places (C, P): first `count` of them, each as far as possible from those before it."""
    first = [int(((places - places.mean(0)) ** 2).sum(1).argmax())]
    nearest = ((places - places[first[0]]) ** 2).sum(1)
    while len(first) < count:
        nearest[first] = -1.0  # also among cases that are alike
        first.append(int(nearest.argmax()))
        nearest = np.minimum(nearest, ((places - places[first[-1]]) ** 2).sum(1))
    rest = np.setdiff1d(np.arange(len(places)), first)
    return np.concatenate([first, np.random.default_rng(SEED).permutation(rest)])


def local_fit(solved: NDArray, places: NDArray) -> Weights:
    r"""Weights by which solved places give values elsewhere: those of a polynomial through the values around.

    .. math:: \min_{a, b} \sum_j w_j (y_j - a - b \cdot p(x_j - x))^2, \quad y(x) = a

    with the coordinates p = x, and their products of two where enough places are solved.

    Places are coordinates (S, P) of solved cases and (n, P) of others. Weights are exact for values that are
    linear, or quadratic, in the coordinates, where the solved cases span them.

    Source
    ------
    Moving least squares, Lancaster and Salkauskas (1981), with weights of inverse squared distances.
    """
    axes = places.shape[1]
    terms = (axes + 1) * (axes + 2) // 2
    quadratic = len(solved) >= SPARE * terms
    count = min(len(solved), int(SPARE * terms) if quadratic else 2 * axes + 2)
    parts = np.array_split(places, 1 + places.size * len(solved) // AT_ONCE)
    squares = (((solved - part[:, None]) ** 2).sum(-1) for part in parts)
    neighbours = np.concatenate([each.argsort(axis=1)[:, :count] for each in squares])
    apart = solved[neighbours] - places[:, None]
    distances = np.linalg.norm(apart, axis=-1)
    furthest = distances.max(axis=1, keepdims=True) + ALIKE
    nearness = 1 / ((distances / furthest) ** 2 + NUGGET)
    powers = _powers(apart / furthest[..., None], quadratic=quadratic)
    weighted = nearness[..., None] * powers
    moments = weighted.swapaxes(1, 2) @ powers
    moments += STIFFENING * np.trace(moments, axis1=1, axis2=2)[:, None, None] * np.eye(powers.shape[-1])
    at_place = np.linalg.inv(moments)[:, :1]
    return Weights(neighbours, (at_place @ weighted.swapaxes(1, 2))[:, 0])


def _powers(steps: NDArray, *, quadratic: bool) -> NDArray:
    """One, the coordinates of steps (..., P), and their products of two where these are wanted."""
    parts = [np.ones((*steps.shape[:-1], 1)), steps]
    if quadratic:
        first, second = np.triu_indices(steps.shape[-1])
        parts.append(steps[..., first] * steps[..., second])
    return np.concatenate(parts, axis=-1)
