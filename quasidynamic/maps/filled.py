"""One state at each point of a grid: some as a run finds it, the others from those around."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.many_elastic import solve_many_elastic
from quasidynamic.maps.points import GridPoints
from quasidynamic.maps.reached import Mapped, Reached, by_newton, in_batches, of_unknowns
from quasidynamic.outcome.equilibria import Equilibria
from quasidynamic.roller import solve_many
from quasidynamic.solve.rollers.solved_neighbours import coordinates, local_fit, spread_out

SPREAD = 2.0  # points that are solved as a run solves them, over the root of their number
FEWEST = 8
GROWTH = 4  # of the number of solved points, before others are solved from them


def one_state_each(points: GridPoints, mapped: Mapped = map) -> Reached:
    """One state at each point; NaN where even a solve like that of a run does not converge.

    Parameters
    ----------
    points : GridPoints
        C of them
    mapped : callable
        `map`, or one that shares calls among processes

    Returns
    -------
    Reached
        of all C points
    """
    count = len(points.bearings)
    first = min(count, max(FEWEST, int(SPREAD * np.sqrt(count))))
    places = coordinates(points.numbers)
    order = spread_out(places, first)
    states = _nothing(points)
    _put(states, order[:first], as_in_a_run(points, order[:first]))
    end = first
    while end < count:
        begin, end = end, min(count, GROWTH * end)
        known = order[:begin][states.converged[order[:begin]]]
        some = _by_load(points, order[begin:end])
        if len(known):
            starts = local_fit(places[known], places[some]).of(states.scaled[known])
            _put(states, some, in_batches(lambda batch: points.at(some[batch]), starts, by_newton, mapped))  # noqa: B023
        failed = some[~states.converged[some]]
        if len(failed):
            _put(states, failed, as_in_a_run(points, failed))
    return states


def as_in_a_run(points: GridPoints, some: NDArray) -> Reached:
    """States at some points (n) as a run of each of them finds it."""
    bearings = [points.bearings[point] for point in some]
    deviation = None if points.deviation is None else points.deviation[some]
    found = solve_many(bearings)
    if not points.rigid:
        found = solve_many_elastic(bearings, points.compliance, found, deviation)
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
