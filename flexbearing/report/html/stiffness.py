"""Stiffness: the bearing alone, with its supports, and the matrix over five directions."""

from collections.abc import Iterator
from importlib.resources import files

import numpy as np

from flexbearing.report.html.document import Block, Cell, Drawing, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed

_ZERO = 1e-10  # of the diagonal: what rounding leaves of nothing
AXES = ("x", "y", "z", "about y", "about z")
_FORCES = ("force along x", "force along y", "force along z", "moment about y", "moment about z")
_UNITS = (("N/m", "kN/mm"), ("N/rad", "kN/rad"), ("N m/m", "kN m/m"), ("N m/rad", "kN m/rad"))
_ALONE = (
    "The bearing alone: between its raceways, freed of their rigid translation. With supports: from the base "
    "that holds the outer ring to the ends of the shaft, in series with them. The matrix includes the "
    "supports where parts are flexible. In a shaft model that has shaft and housing as elements of its own, "
    "use the bearing alone; in one that ends at this bearing, use that with supports; never both in series."
)
_TILT = (
    "Tilt: K of the matrix along the load is taken with the tilt of the inner ring held; the radial "
    'stiffness with supports of the table lets it follow where operation.tilt = "free": then it is smaller.'
)
_BALLS = "Loads on the inner ring by its displacement, balls in balance."


def blocks(reader: Reader) -> Iterator[Block]:
    """Radial stiffnesses, axes, matrices of the last end state."""
    block = reader.blocks.get(reader.last, {})
    if "stiffness_matrix" not in block:
        return
    yield Words((_ALONE if "total_stiffness" in block else _BALLS,))
    if "total_stiffness" in block:
        yield _radial(reader)
    caption = (
        "Axes: x along the shaft, z the way of the load, y across. A positive rotation about y turns z "
        "towards x, one about z turns x towards y: right-handed. Azimuth and positive speeds turn z "
        "towards y: left-handed about +x."
    )
    yield Drawing(caption, (files("flexbearing.report.html") / "page" / "axes.svg").read_text("utf-8"))
    yield _matrix(reader)
    if "total_stiffness" in block:
        yield Words((_TILT,))


def _radial(reader: Reader) -> Table:
    rows: list[tuple[Cell, ...]] = []
    words = {
        "stiffness": "bearing alone, radial", "total_stiffness": "with supports, radial",
        "support_stiffness": "support of the outer ring alone, radial",
    }  # fmt: skip
    for name, label in words.items():
        numbers = [
            reader.element(block, name, digits=",.1f")
            for block in reader.blocks
            if name in reader.blocks[block]
        ]
        if numbers:
            rows.append(
                (label, *[""] * (len(reader.blocks) - len(numbers)), *numbers, printed(numbers[0].unit))
            )
    return Table(
        f"Radial tangent stiffness{_free(reader)}", ("stiffness", *reader.blocks, "unit"), tuple(rows)
    )


def _free(reader: Reader) -> str:
    """Whether the inner ring tilts freely, where a result says so."""
    held = (reader.attributes.get("tilt") or {}).get("inner_ring")
    return f", tilt {'free' if held == 'free' else 'held'}" if held else ""


def _matrix(reader: Reader) -> Table:
    """The matrix with a unit for each of its four parts."""
    rows: list[tuple[Cell, ...]] = []
    scale = np.sqrt(np.abs(np.diag(reader.blocks[reader.last]["stiffness_matrix"])))
    for row, axis in enumerate(_FORCES):
        cells: list[Cell] = [axis]
        for column in range(5):
            stored, people = _UNITS[2 * (row > 2) + (column > 2)]
            value = float(reader.blocks[reader.last]["stiffness_matrix"][row, column])
            of = f"{reader.last}/stiffness_matrix/{row}/{column}"
            digits = ".0f" if abs(value) <= _ZERO * scale[row] * scale[column] else ".4g"
            cells.append(reader.units.number(value, stored, people, digits, of))
        rows.append(tuple(cells))
    forces, mixed, moments, turns = (printed(reader.units.of(people)) for _, people in _UNITS)
    note = (
        f"Units: forces by displacements {forces}, forces by rotations {mixed}, moments by displacements "
        f"{moments}, moments by rotations {turns}. Zero along x where the bearing carries nothing axially."
    )
    head = (
        "load",
        *(f"per displacement {axis}" for axis in AXES[:3]),
        *(f"per rotation {axis}" for axis in AXES[3:]),
    )
    return Table(f"Tangent stiffness, {reader.state}, tilt held", head, tuple(rows), note)
