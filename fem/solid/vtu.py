"""A loaded solid as a file for ParaView: the tensor as it is, and what follows from it point by point."""

from collections.abc import Mapping

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.mesh.solid import MILLIMETRES
from fem.parts.material import Elastic
from fem.solid.extremes import principal, von_mises
from fem.solid.lattice import hooke, lattice, strain_of

MEGA = 1e6  # Pa per MPa
TETRAHEDRON = 10  # its number among the cells of VTK
INTERVALS = 2  # along an edge of an element
TYPES = {"f4": "Float32", "i4": "Int32", "u1": "UInt8"}


def vtu(displacement: ngs.GridFunction, materials: Mapping[str, Elastic]) -> bytes:
    """Displacement [m] on tetrahedra in millimetres, and its stress, as an unstructured grid.

    Every element has its own points, in two intervals: places [mm], "displacement_mm", "stress_MPa" as xx,
    yy, zz, xy, yz, xz, of every element by itself, "von_mises_MPa" and "principal_MPa" (largest first) of the
    stress as it is written, and the number of the "body" in the order of `materials`; all cells are
    tetrahedra.
    """
    pieces = [_of_body(displacement, *item, k) for k, item in enumerate(materials.items())]
    point_data = {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}
    points = point_data.pop("Points")
    corners = _corners()
    per_element = int(corners.max()) + 1
    first = per_element * np.arange(len(points) // per_element)
    connectivity = (first[:, None, None] + corners).reshape(-1, 4).astype("i4")
    cells = {
        "connectivity": connectivity.ravel(),
        "offsets": 4 * np.arange(1, len(connectivity) + 1, dtype="i4"),
        "types": np.full(len(connectivity), TETRAHEDRON, dtype="u1"),
    }
    return _file(
        len(points),
        len(connectivity),
        {"Points": {"Points": points}, "Cells": cells, "PointData": point_data},
    )


def _of_body(displacement: ngs.GridFunction, body: str, elastic: Elastic, number: int) -> dict[str, NDArray]:
    """Values at the points of a body, each in single precision."""
    mesh = displacement.space.mesh
    rule, _ = lattice(ngs.TET, INTERVALS)
    points = mesh.MapToAllElements({ngs.TET: rule}, mesh.Materials(body))
    gradient = ngs.Grad(displacement)(points)
    stress = (hooke(strain_of(gradient), elastic) / MEGA).astype("f4")
    written = stress.astype(float)
    return {
        "Points": ngs.CF((ngs.x, ngs.y, ngs.z))(points).astype("f4"),
        "displacement_mm": (displacement(points) * MILLIMETRES).astype("f4"),
        "stress_MPa": stress,
        "von_mises_MPa": von_mises(written).astype("f4"),
        "principal_MPa": principal(written).astype("f4"),
        "body": np.full(len(points), number, dtype="f4"),
    }


def _corners() -> NDArray:
    """Small tetrahedra (8, 4) between the points of the lattice of one, all the same way round."""
    size = INTERVALS + 1
    number = {}
    for i, j, k in np.ndindex(size, size, size):
        if i + j + k < size:
            number[i, j, k] = len(number)
    middles = {
        "a": (1, 0, 0),
        "b": (0, 1, 0),
        "c": (0, 0, 1),
        "ab": (1, 1, 0),
        "bc": (0, 1, 1),
        "ca": (1, 0, 1),
    }
    corner = {"O": (0, 0, 0), "A": (2, 0, 0), "B": (0, 2, 0), "C": (0, 0, 2)}
    place = middles | corner
    cells = [
        ("O", "a", "b", "c"), ("a", "A", "ab", "ca"), ("b", "ab", "B", "bc"), ("c", "ca", "bc", "C"),
        ("a", "bc", "ab", "b"), ("a", "bc", "b", "c"), ("a", "bc", "c", "ca"), ("a", "bc", "ca", "ab"),
    ]  # fmt: skip
    numbers = []
    for cell in cells:
        o, a, b, c = (np.array(place[name]) for name in cell)
        right = np.dot(np.cross(a - o, b - o), c - o) > 0
        names = cell if right else (cell[0], cell[2], cell[1], cell[3])
        numbers.append([number[place[name]] for name in names])
    return np.array(numbers)


def _file(points: int, cells: int, groups: Mapping[str, Mapping[str, NDArray]]) -> bytes:
    """VTU with raw data behind the XML, every array after its length in bytes."""
    head, data = [], []
    offset = 0
    for group, arrays in groups.items():
        head.append(f"<{group}>")
        for name, array in arrays.items():
            kind = TYPES[array.dtype.str[1:]]
            components = 1 if array.ndim == 1 else array.shape[1]
            head.append(
                f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" '
                f'format="appended" offset="{offset}"/>'
            )
            raw = array.astype(array.dtype.newbyteorder("<")).tobytes()
            data += [np.array(len(raw), dtype="<u4").tobytes(), raw]
            offset += 4 + len(raw)
        head.append(f"</{group}>")
    opening = (
        '<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" '
        'header_type="UInt32">\n<UnstructuredGrid>\n'
        f'<Piece NumberOfPoints="{points}" NumberOfCells="{cells}">\n'
    )
    closing = '\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding="raw">\n_'
    return b"".join(
        [
            opening.encode(),
            "\n".join(head).encode(),
            closing.encode(),
            *data,
            b"\n</AppendedData>\n</VTKFile>\n",
        ]
    )
