"""Stiffness: the bearing alone, with its supports, and the matrix over five directions."""

from collections.abc import Iterator, Mapping
from importlib.resources import files
from typing import Any

import numpy as np

from flexbearing.report.html.document import Block, Cell, Drawing, Number, Table, Words
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.sentences import load_axis
from flexbearing.report.html.units import NOTHING, printed

_ZERO = 1e-10  # of the diagonal: what rounding leaves of nothing
AXES = ("x", "y", "z", "about y", "about z")
_FORCES = ("force along x", "force along y", "force along z", "moment about y", "moment about z")
_UNITS = (("N/m", "kN/mm"), ("N/rad", "kN/rad"), ("N m/m", "kN m/m"), ("N m/rad", "kN m/rad"))
_WHICH = (
    "Which stiffness to give to a rotor or shaft model depends on what that model has of its own. If it has "
    "shaft, housing and squirrel cage: the bearing alone. If it has the shaft only: the bearing with the "
    "support of the outer ring; if it has the housing or squirrel cage only: with the support of the inner "
    "ring, both in rows below. If it has neither: the stiffness with supports, "
    "which includes the bending of the shaft between the ends of the case. A part in both models would count "
    "twice."
)
NOT_IN_SERIES = (
    "Bearing and supports are no springs in series here, as the supports bend the rings by the loads of the "
    "bearing: only the stiffness with supports is given. A rotor model takes it, without supports of its own."
)
_NO_SUPPORTS = (
    "Rings, shaft and housing are rigid in this case: there is one stiffness, that of the bearing alone, and "
    "the matrix below is its matrix. A rotor or shaft model needs its own shaft and housing beside it."
)
_MATRIX = (
    "The matrix includes rings and supports, from the base that holds the outer ring to the ends of the "
    "shaft. Of the bearing alone only the radial part is given, in the table above: the rotation of a "
    "raceway that deforms cannot be separated from the deformation of its contacts."
)
_UNSYMMETRIC = (
    "Entries across the diagonal differ: rollers that turn and rub are no elastic spring alone. No damping is"
    " computed; a rotor model needs it from elsewhere."
)
_TILT = (
    "The entries of the matrix hold the tilt of the inner ring. In the stiffnesses of the table above the "
    'tilt follows where operation.tilt = "free", which can make them smaller. Along the load means that '
    "the ring may also move across it."
)
_FREE_ACROSS = (
    "shaft and supports are in the rotor model; free to move across the load, which the rows over y and z "
    "hold"
)
_NEAR = (
    "All of them are tangents: slopes at this load, speed, clearance and roller position. Contacts of "
    "rollers stiffen with load and more rollers come to bear, so another load or clearance needs a run of "
    "its own (`flexbearing study` makes a table over load or speed)."
)
_BALLS = (
    "Loads on the inner ring by its displacement, balls in balance. No damping is computed; a rotor model "
    "needs it from elsewhere."
)
_AXES = (
    "Forces and moments are loads on the inner ring that displace it by one unit along an axis. Axes: x "
    "along the shaft, z at azimuth 0°, y at 90°; the radial load of this case acts {}. A "
    "positive rotation about y turns z towards x, one about z turns x towards y: right-handed. Azimuth and "
    "positive speeds turn z towards y, left-handed about +x: a rotor model with right-handed spin about the "
    "same +x takes these speeds with the other sign."
)


IN_MODEL = {"outer": "Shaft", "inner": "Housing or squirrel cage"}  # beside the support of a ring


def blocks(reader: Reader) -> Iterator[Block]:
    """Which stiffness to use, radial stiffnesses, axes, matrix of the last end state."""
    block = reader.blocks.get(reader.last, {})
    if "stiffness_matrix" not in block:
        return
    if "total_stiffness" in block:
        yield Words((_which(reader),))
        yield _radial(reader)
    else:
        yield Words((_BALLS,))
    yield Drawing(
        _AXES.format(load_axis(reader)),
        (files("flexbearing.report.html") / "page" / "axes.svg").read_text("utf-8"),
    )
    yield _matrix(reader)
    if "total_stiffness" in block:
        yield Words(
            (*([_MATRIX] if supported(reader) and in_series(reader) else []), _TILT, _NEAR, _UNSYMMETRIC)
        )


def _which(reader: Reader) -> str:
    """Which stiffness a rotor model needs."""
    if not in_series(reader):
        return NOT_IN_SERIES
    return _WHICH if supported(reader) else _NO_SUPPORTS


def in_series(reader: Reader) -> bool:
    """Whether bearing and supports are springs in series, each with a stiffness of its own."""
    return "stiffness" in reader.blocks[reader.last]


def supported(reader: Reader) -> bool:
    """Whether a ring is on a support that gives way."""
    if not in_series(reader) and "total_stiffness" in reader.blocks[reader.last]:
        return True
    structure = reader.attributes.get("structure") or {}
    return len(reader.blocks) > 1 and any(_support(figures) is not None for figures in structure.values())


def _support(figures: dict[str, Any]) -> float | None:
    """Radial stiffness [N/m] of what holds a ring; None where that is rigid, or not known."""
    return figures.get("support_stiffness_N_per_m")


def _radial(reader: Reader) -> Table:
    """Every radial stiffness with what it is for, along the load and beside it."""
    names = [("stiffness", "bearing alone, along the load", _FREE_ACROSS)] * in_series(reader)
    if supported(reader):
        names.append(("total_stiffness", "with supports, along the load", "neither is in the rotor model"))
    rows: list[tuple[Cell, ...]] = []
    for name, label, use in names:
        numbers: list[Cell] = [
            NOTHING if name == "total_stiffness" and block == "rigid" else
            reader.element(block, name, digits=",.4g") for block in reader.blocks
        ]  # fmt: skip
        rows.append((label, *numbers, printed(reader.units.of("kN/mm")), use))
    for which, name in (("bearing alone", "radial_stiffness"), ("with supports", "total_radial_stiffness")):
        if name in reader.blocks[reader.last] and (name == "radial_stiffness" or supported(reader)):
            rows += _over_yz(reader, which, name)
    rows += _supports(reader)
    return Table(
        f"Radial tangent stiffness{_free(reader)}", ("stiffness", *reader.blocks, "unit", "for"), tuple(rows)
    )


def _over_yz(reader: Reader, which: str, name: str) -> Iterator[tuple[Cell, ...]]:
    """Radial stiffness along y and z and what one axis does to the other, in every end state."""
    for row, force in enumerate("yz"):
        for column, displacement in enumerate("yz"):
            numbers: list[Cell] = [
                NOTHING if name == "total_radial_stiffness" and block == "rigid" else
                reader.element(block, name, row, column, digits=",.4g") for block in reader.blocks
            ]  # fmt: skip
            cross = f"force along {force} by displacement along {displacement}"
            label, use = f"along {force}", "a model over y and z"
            if row != column:
                label, use = cross, "the same, cross term: rolling friction and drag"
            yield f"{which}, {label}", *numbers, printed(reader.units.of("kN/mm")), use


def _supports(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    """What holds each ring, alone: in series with the bearing it makes the stiffness with supports."""
    for part, figures in (reader.attributes.get("structure") or {}).items():
        if _support(figures) is not None:
            path = f"structure/{part}/support_stiffness_N_per_m"
            number = reader.of_attribute(path, "N/m", "kN/mm", ",.4g")
            empty = [NOTHING] * (len(reader.blocks) - 1)
            use = "in series with the bearing alone, where it is not in the rotor model"
            yield f"support of the {part} ring alone", *empty, number, printed(number.unit), use
            yield from _in_series(reader, part, empty)


def _in_series(reader: Reader, part: str, empty: list[str]) -> Iterator[tuple[Cell, ...]]:
    """Rows of the bearing with one of its supports, for rotor models that have the other."""
    for axis, number in with_one_support(reader, part):
        label = f"with the support of the {part} ring only, along {axis}"
        yield (
            label,
            *empty,
            number,
            printed(number.unit),
            f"{IN_MODEL[part]} only is in the rotor model".lower(),
        )


def with_one_support(reader: Reader, part: str) -> Iterator[tuple[str, Number]]:
    """Stiffness of the bearing in series with what holds a ring, along z and y; none where that is rigid."""
    support = _support((reader.attributes.get("structure") or {}).get(part) or {})
    if support is None or len(reader.blocks) < 2 or "radial_stiffness" not in reader.blocks[reader.last]:
        return
    for row, axis in reversed(tuple(enumerate("yz"))):
        alone = float(reader.blocks[reader.last]["radial_stiffness"][row, row])
        path = f"series/{reader.last}/{row}/{part}"
        value = alone * support / (alone + support)
        yield axis, reader.units.number(value, "N/m", "kN/mm", ",.4g", path)


def ends_in_series(
    reader: Reader, part: str, spans: Mapping[str, tuple[float, float]]
) -> tuple[float, float] | None:
    r"""Factors of the least and greatest stiffness along z of the bearing in series with one support.

    .. math:: k = (1/k_{total} - 1/k_{other})^{-1}

    The softer support decides the range of the stiffness with both: its series has that range, less the other
    support. The stiffer one has the range of the bearing alone.

    Parameters
    ----------
    reader : Reader
    part : str
        whose support it is
    spans : mapping
        factors of "stiffness", of the bearing alone, and of "total_stiffness"
    """
    supports = {
        name: value
        for name, figures in (reader.attributes.get("structure") or {}).items()
        if (value := _support(figures)) is not None
    }
    if len(supports) < 2 or len(spans) < 2:
        return None
    block = reader.blocks[reader.last]
    alone, total = (float(block[name][1, 1]) for name in ("radial_stiffness", "total_radial_stiffness"))
    now = 1 / alone + 1 / supports[part]
    if part == min(supports, key=supports.__getitem__):
        left_out = sum(1 / value for name, value in supports.items() if name != part)
        low, high = (now / (1 / (factor * total) - left_out) for factor in spans["total_stiffness"])
    else:
        low, high = (now / (1 / (factor * alone) + 1 / supports[part]) for factor in spans["stiffness"])
    return low, high


def _free(reader: Reader) -> str:
    """Whether the inner ring tilts freely, where a result says so."""
    held = (reader.attributes.get("tilt") or {}).get("inner_ring")
    return f", tilt {'free' if held == 'free' else 'held'}" if held else ""


def tilt_follows(reader: Reader) -> str:
    """How the tilt is held in radial stiffnesses; empty where a result does not say."""
    held = (reader.attributes.get("tilt") or {}).get("inner_ring")
    of = "as in the case" if "operation.tilt" in reader.written else "the default"
    return f'All numbers above are with operation.tilt = "{held}", {of}. ' if held else ""


def of_matrix(reader: Reader) -> str:
    """Which stiffness the matrix is, and that its entries hold the tilt."""
    which = "with supports" if supported(reader) else "of the bearing alone"
    return (
        f"The matrix over five directions, with tilts and signs, is that {which}; its entries hold the tilt."
    )


def entry(reader: Reader, row: int, column: int) -> Number:
    """An entry of the matrix of the last end state; what rounding leaves of nothing is printed as zero."""
    matrix = reader.blocks[reader.last]["stiffness_matrix"]
    stored, people = _UNITS[2 * (row > 2) + (column > 2)]
    value, scale = float(matrix[row, column]), np.sqrt(abs(matrix[row, row] * matrix[column, column]))
    digits = ".0f" if abs(value) <= _ZERO * scale else ".4g"
    return reader.units.number(
        value, stored, people, digits, f"{reader.last}/stiffness_matrix/{row}/{column}"
    )


def _matrix(reader: Reader) -> Table:
    """The matrix with a unit for each of its four parts."""
    rows: list[tuple[Cell, ...]] = []
    for row, axis in enumerate(_FORCES):
        cells: list[Cell] = [axis]
        for column in range(5):
            cells.append(entry(reader, row, column))
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
