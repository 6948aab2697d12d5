"""From the files of another finite element program to the body that carries an outer ring."""

from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import fem
from fem.matrix.stiffness import Stiffness, extremes
from flexbearing import inputs
from flexbearing.build import matrix_files
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.head import next_to
from flexbearing.case.roller import Case
from flexbearing.printable import excerpt
from quasidynamic.note import Note, information, outside

ON_SEAT = 2e-3  # of the outer radius: how far nodes of the seat may stand from it, on straight elements
OVER = 1 + 1e-3  # of half the width: how far they may be beside the ring
HARDLY = 1e-6  # of its entries: what holds a body less may be their rounding


WithMatrix = Case | FastCase  # of outer.kind = "matrix"


def reduced_body(case: WithMatrix) -> fem.ReducedBody:
    """Body of `outer.kind = "matrix"`, condensed to the nodes on the outer surface of the ring."""
    frame = _frame(case)
    nodes, places = _seat(case, frame)
    return _body(_stamp(_files(case)[0]), nodes, _unit(case), places.tobytes(), frame.tobytes())


@lru_cache(maxsize=2)  # one object for cases with the same body: their rings are condensed once
def _body(
    stamp: inputs.Stamp, nodes: tuple[int, ...], unit: float, places: bytes, frame: bytes
) -> fem.ReducedBody:
    stiffness, _ = _condensed(stamp, nodes)
    turned = np.kron(np.eye(len(nodes)), np.frombuffer(frame).reshape(3, 3))
    return fem.ReducedBody(np.frombuffer(places).reshape(-1, 3), unit * turned @ stiffness @ turned.T)


def notes(case: WithMatrix) -> tuple[Note, ...]:
    """What was found of a matrix on reading, and a warning where hardly anything holds its body."""
    stamp, unit = _stamp(_files(case)[0]), _unit(case)
    whole, body = _matrix(stamp), reduced_body(case)
    nodes, _ = _seat(case, _frame(case))
    smallest, largest = (unit * each for each in _condensed(stamp, nodes)[1])
    along = ", ".join(f"{1e-9 * each:.4g}" for each in np.diag(body.rigid_stiffness)[:3])
    name, count = excerpt(stamp.path.name), len(np.unique(whole.nodes))
    words = (
        f"{name}: {len(nodes)} of {count} nodes are the seat; its stiffness is symmetric, with eigenvalues "
        f"from {smallest:.4g} to {largest:.4g} N/m, and resists a translation along x, y, z with {along} "
        f"kN/um; a translation of everything loads {whole.held_nodes()} of {count} nodes: of a whole mesh "
        "only those next to where it is held"
    )
    loose = (
        f"{name}: against one rigid motion the body is held by {body.hold:.1g} of what its entries add up "
        "to, which may be their rounding: does the mesh have its boundary conditions?"
    )
    hardly = (outside("loose-matrix", loose),) if body.hold < HARDLY else ()
    return (information("matrix", words), *hardly)


def _files(case: WithMatrix) -> tuple[Path, ...]:
    """Matrix and mesh, next to the case file."""
    outer: Any = case.outer
    return next_to(Path(case.source.path), (outer.matrix, outer.nodes))


def _frame(case: WithMatrix) -> NDArray:
    """The bearing's x, y, z (3, 3) in the mesh."""
    outer: Any = case.outer  # checked on reading
    axis, zenith = _direction(outer.axis), _direction(outer.zenith)
    return np.array([axis, np.cross(zenith, axis), zenith])


def _unit(case: WithMatrix) -> float:
    outer: Any = case.outer
    return outer.force_unit / outer.length_unit


def _seat(case: WithMatrix, frame: NDArray) -> tuple[tuple[int, ...], NDArray]:
    """Numbers and places (K, 3) [m] of the nodes on the outer surface of the ring."""
    outer: Any = case.outer
    nodes_file = _files(case)[1]
    numbers, places = _places(_stamp(nodes_file))
    centre = np.array([outer.centre_x, outer.centre_y, outer.centre_z])
    moved = (outer.length_unit * places - centre) @ frame.T
    radius, offset = case.seat
    away = np.abs(np.hypot(moved[:, 1], moved[:, 2]) - radius)
    beside = np.abs(moved[:, 0] + offset)
    on_seat = np.flatnonzero((away <= ON_SEAT * radius) & (beside <= OVER * outer.width / 2))
    if not on_seat.size:
        raise fem.ImpossiblePart(
            f"{excerpt(nodes_file.name)}: no node is on the outer surface of the ring, radius "
            f"{1e3 * radius:.6g} mm and width {1e3 * outer.width:.6g} mm; outer.axis, outer.zenith, "
            "outer.centre_x, _y, _z and outer.length_unit say where the mesh is"
        )
    return tuple(numbers[on_seat].tolist()), moved[on_seat]


def _stamp(path: Path) -> inputs.Stamp:
    try:
        return inputs.stamp(path)
    except inputs.Unreadable as problem:
        raise fem.ImpossiblePart(f"{excerpt(path.name)}: {problem}") from problem


@lru_cache(maxsize=2)
def _places(stamp: inputs.Stamp) -> tuple[NDArray, NDArray]:
    return matrix_files.places(stamp.path)


@lru_cache(maxsize=2)
def _matrix(stamp: inputs.Stamp) -> Stiffness:
    return matrix_files.stiffness(stamp.path)


@lru_cache(maxsize=2)
def _condensed(stamp: inputs.Stamp, nodes: tuple[int, ...]) -> tuple[NDArray, tuple[float, float]]:
    """Stiffness of the seat, and its smallest and largest eigenvalue, in the units of the file."""
    whole = _matrix(stamp)  # whose own problems begin with its name
    try:
        stiffness = whole.at(nodes)
        return stiffness, extremes(stiffness)
    except fem.ImpossiblePart as problem:
        raise fem.ImpossiblePart(f"{excerpt(stamp.path.name)}: {problem}") from problem


def _direction(name: str) -> NDArray:
    """Unit vector along an axis of the mesh."""
    vector = np.zeros(3)
    vector["xyz".index(name[-1])] = -1.0 if name.startswith("-") else 1.0
    return vector
