"""One state at each point of a grid: some as a run finds it, the others from those around."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.many_elastic import solve_many_elastic
from quasidynamic.maps.newton_states import Mapped, Reached, by_newton, in_batches, of_unknowns
from quasidynamic.maps.points import GridPoints
from quasidynamic.outcome.equilibrium import Equilibria
from quasidynamic.roller import solve_many
from quasidynamic.solve.rollers.newton import bounded

SPREAD = 2.0  # points that are solved as a run solves them at most, over the root of their number
FEWEST = 8  # of them at most where that is more
NODES = 4  # along an axis, of the cubic that starts are taken from


def one_state_each(points: GridPoints, mapped: Mapped = map) -> Reached:
    """One state at each point; NaN where even a solve like that of a run does not converge.

    Points of the coarsest of nested grids are solved as a run solves them, those of each finer one begin at a
    cubic through the solved ones, and where that fails at the nearest of these.
    """
    states, every = _nothing(points), np.arange(len(points.bearings)).reshape(points.shape)
    coarsest, *finer = nested(points.shape)
    known = every[np.ix_(*coarsest)]
    _put(states, known.ravel(), as_in_a_run(points, known.ravel()))
    for nodes, next_nodes in zip([coarsest, *finer], finer, strict=False):
        new = np.setdiff1d(every[np.ix_(*next_nodes)], known)
        solved = known.ravel()[states.converged[known.ravel()]]
        some = _by_load(points, new)
        failed = some
        if len(solved):
            nearest = states.scaled[solved[_nearest(points.shape, solved, every.ravel())]]
            smooth = through(nodes, points.shape, nearest[known.ravel()].reshape(*known.shape, -1))
            for starts in (smooth.reshape(nearest.shape), nearest):
                _put(states, failed, _near(points, failed, nearest[failed], starts[failed], mapped))
                failed = failed[~states.converged[failed]]
        if len(failed):
            _put(states, failed, as_in_a_run(points, failed))
        known = every[np.ix_(*next_nodes)]
    return states


def nested(shape: tuple[int, ...]) -> list[list[NDArray]]:
    """Places along each axis of nested grids, the coarsest first; every one holds the ends of each axis."""
    most, stride = max(FEWEST, SPREAD * np.sqrt(np.prod(shape))), 1
    grids = [_every(stride, shape)]
    while np.prod([len(places) for places in grids[0]]) > most and stride < max(shape):
        stride *= 2
        grids.insert(0, _every(stride, shape))
    return grids


def _every(stride: int, shape: tuple[int, ...]) -> list[NDArray]:
    return [np.unique(np.append(np.arange(0, count, stride), count - 1)) for count in shape]


def through(nodes: list[NDArray], shape: tuple[int, ...], values: NDArray) -> NDArray:
    """Values (*shape, N) from those at the nodes of a grid (n1, n2, .., N), by cubics along each axis."""
    for axis, (places, count) in enumerate(zip(nodes, shape, strict=True)):
        values = np.moveaxis(np.tensordot(_cubic(places, np.arange(count)), values, (1, axis)), 0, axis)
    return values


def _cubic(nodes: NDArray, places: NDArray) -> NDArray:
    """Lagrange's weights (n, k) of values at k nodes for those at places (n), of the `NODES` around each."""
    count = min(NODES, len(nodes))
    first = np.clip(np.searchsorted(nodes, places) - count // 2, 0, len(nodes) - count)
    around = first[:, None] + np.arange(count)
    x, weights = nodes[around].astype(float), np.zeros((len(places), len(nodes)))
    for j in range(count):
        others = np.delete(x, j, axis=1)
        factors = (places[:, None] - others) / (x[:, [j]] - others)
        weights[np.arange(len(places)), around[:, j]] = factors.prod(axis=1)
    return weights


def _nearest(shape: tuple[int, ...], solved: NDArray, some: NDArray) -> NDArray:
    """Which of the solved points is nearest to each of some (n), in steps of the grid."""
    from scipy.spatial import KDTree  # costly to import

    at, to = (np.transpose(np.unravel_index(places, shape)) for places in (solved, some))
    return np.asarray(KDTree(at).query(to)[1])


def _near(points: GridPoints, some: NDArray, near: NDArray, starts: NDArray, mapped: Mapped) -> Reached:
    """States at some points (n) by Newton's method from starts (n, N), kept within reach of states nearby."""
    if not len(some):
        return _nothing(points).take(some)
    within = bounded(points.at(some), near, starts)
    return in_batches(lambda batch: points.at(some[batch]), within, by_newton, mapped)


def as_in_a_run(points: GridPoints, some: NDArray) -> Reached:
    """States at some points (n) as a run of each of them finds it."""
    bearings = [points.bearings[point] for point in some]
    deviation = None if points.deviation is None else points.deviation[some]
    if points.rigid:
        found = solve_many(bearings)
    else:
        found = solve_many_elastic(bearings, points.compliance, deviation=deviation)
    return of_unknowns(points.at(some), _scaled(points, some, found))


def _scaled(points: GridPoints, some: NDArray, found: Equilibria) -> NDArray:
    """Scaled unknowns (n, N) as the points have them; NaN where no state was found."""
    balance = points.at(some)
    rows = found.in_order(lambda batch: balance.layout.joined(batch.states.unknowns))
    rows[list(found.unsolved)] = np.nan
    return rows / balance.scales.unknown


def _nothing(points: GridPoints) -> Reached:
    layout, count = points.at(np.array([0])).layout, len(points.bearings)
    nothing = np.full((count, 3 * layout.rollers), np.nan)
    loads = nothing[:, layout.rollers :].reshape(count, 2, -1)
    return Reached(np.full((count, layout.size), np.nan), loads, nothing[:, : layout.rollers])


def _put(states: Reached, places: NDArray, some: Reached) -> None:
    for whole, part in ((states.scaled, some.scaled), (states.loads, some.loads), (states.spin, some.spin)):
        whole[places] = part


def _by_load(points: GridPoints, some: NDArray) -> NDArray:
    """The same points, those of similar loads and speeds side by side: similar rollers touch there."""
    operating = points.at(some).points
    return some[np.lexsort((operating.relative_speed[:, 0], operating.load[:, 0]))]
