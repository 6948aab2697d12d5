"""From the files of another finite element program to the body that carries an outer ring."""

from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import fem
from flexbearing.case.roller import Case

if TYPE_CHECKING:
    from fem.matrix.stiffness import Stiffness

ON_SEAT = 2e-3  # of the outer radius: how far nodes of the seat may stand from it, on straight elements
OVER = 1 + 1e-3  # of half the width: how far they may stand beside the ring


def reduced_body(case: Case) -> "fem.ReducedBody":
    """Body of `outer.kind = "matrix"`, condensed to the nodes on the outer surface of the ring.

    Parameters
    ----------
    case : Case
        with `outer.matrix` and `outer.nodes`

    Returns
    -------
    fem.ReducedBody

    Raises
    ------
    ImpossiblePart
        where a file cannot be read, or no nodes stand on that surface, or the matrix does not hold them
    """
    outer: Any = case.outer  # checked on reading
    matrix_file, nodes_file = case.matrix_files
    numbers, places = _places(_stamp(nodes_file))
    axis = _direction(outer.axis)
    zenith = _direction(outer.zenith)
    frame = np.array([axis, np.cross(zenith, axis), zenith])  # x, y, z of the bearing in the mesh
    centre = np.array([outer.centre_x, outer.centre_y, outer.centre_z])
    moved = (outer.length_unit * places - centre) @ frame.T
    radius = case.bearing.outer_raceway_diameter / 2 + outer.thickness
    away = np.abs(np.hypot(moved[:, 1], moved[:, 2]) - radius)
    beside = np.abs(moved[:, 0] + outer.raceway_offset)
    on_seat = np.flatnonzero((away <= ON_SEAT * radius) & (beside <= OVER * outer.width / 2))
    if not on_seat.size:
        raise fem.ImpossiblePart(
            f"{nodes_file.name}: no node is on the outer surface of the ring, radius "
            f"{1e3 * radius:.6g} mm and width {1e3 * outer.width:.6g} mm; outer.axis, outer.zenith, "
            "outer.centre_x, _y, _z and outer.length_unit say where the mesh is"
        )
    stiffness = _seat(_stamp(matrix_file), tuple(numbers[on_seat].tolist()))
    turned = np.kron(np.eye(on_seat.size), frame)
    unit = outer.force_unit / outer.length_unit
    return fem.ReducedBody(moved[on_seat], unit * turned @ stiffness @ turned.T)


def _stamp(path: Path) -> tuple[Path, int, int]:
    """A file and what tells that it changed."""
    try:
        state = path.stat()
    except OSError as problem:
        raise fem.ImpossiblePart(f"{path.name}: cannot be read: {problem.strerror}") from problem
    return path, state.st_mtime_ns, state.st_size


@lru_cache(maxsize=2)
def _places(stamp: tuple[Path, int, int]) -> tuple[NDArray, NDArray]:
    from fem.matrix import read

    found = read.places(stamp[0])
    return np.array([*found]), np.array([*found.values()])


@lru_cache(maxsize=2)
def _matrix(stamp: tuple[Path, int, int]) -> "Stiffness":
    from fem.matrix import read

    return read.stiffness(stamp[0])


@lru_cache(maxsize=2)
def _seat(stamp: tuple[Path, int, int], nodes: tuple[int, ...]) -> NDArray:
    return _matrix(stamp).at(nodes)


def _direction(name: str) -> NDArray:
    """Unit vector along an axis of the mesh."""
    vector = np.zeros(3)
    vector["xyz".index(name[-1])] = -1.0 if name.startswith("-") else 1.0
    return vector
