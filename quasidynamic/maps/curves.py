"""Fold curves on the planes of a grid, from where sheets end between its points."""

import numpy as np
from numpy.typing import NDArray

from quasidynamic.maps.solve import SolvedGrid
from quasidynamic.maps.states import ENDS


def end_places(solved: SolvedGrid) -> NDArray:
    """Places (n, d) where stable states end, in steps of the grid from its first point.

    Parameters
    ----------
    solved : SolvedGrid
        with n ends

    Returns
    -------
    array (n, d)
        along each axis; between two points along the side on which a state ends
    """
    states, sides = solved.ends
    shape = solved.points.shape
    places = np.array(np.unravel_index(solved.point[states], shape), float).T.reshape(-1, len(shape))
    sense = np.where(sides % 2 == 0, -1.0, 1.0)
    places[np.arange(len(sides)), sides // 2] += sense * solved.share[states, sides]
    return places


def fold_curves(solved: SolvedGrid, axes: tuple[int, int]) -> NDArray:
    """Pieces of fold curves: in each cell of a plane, from one of its sides to another.

    Parameters
    ----------
    solved : SolvedGrid
        of at least two axes
    axes : pair of int
        that span the planes

    Returns
    -------
    array (n, 2, d)
        both ends of each piece, in steps of the grid from its first point
    """
    names = list(zip(*(part.tolist() for part in solved.ends), strict=True))
    places = dict(zip(names, end_places(solved), strict=True))
    pieces: dict[frozenset, list[NDArray]] = {}
    for state, side in names:
        if side // 2 not in axes:
            continue
        across = axes[1] if side // 2 == axes[0] else axes[0]
        for turn in (2 * across, 2 * across + 1):
            other = _in_cell(solved, state, side, turn)
            if other in places:
                pieces[frozenset(((state, side), other))] = [places[state, side], places[other]]
    return np.array(list(pieces.values())).reshape(-1, 2, len(solved.points.shape))


def _in_cell(solved: SolvedGrid, state: int, side: int, turn: int) -> tuple[int, int]:
    """Where the same sheet ends next in a cell: state and side.

    The sheet ends at the side of the state itself, or of its neighbour, or of that one's neighbour.
    """
    if solved.continues[state, turn] == ENDS:
        return state, turn
    beside = int(solved.continues[state, turn])
    if beside < 0:
        return -1, turn
    if solved.continues[beside, side] == ENDS:
        return beside, side
    ahead = int(solved.continues[beside, side])
    return (ahead, turn ^ 1) if ahead >= 0 else (-1, turn)
