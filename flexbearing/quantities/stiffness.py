"""Entries of the stiffness matrices that rotor dynamics requires."""

from functools import partial

from flexbearing.quantities.quantity import SummaryValue, Unit
from flexbearing.quantities.reductions import entry

_NAMES = ("yy", "yz", "zy", "zz")  # force by displacement


def _entries(prefix: str, y: int, z: int) -> tuple[SummaryValue, ...]:
    """Outputs of a matrix that has the axes y and z in some places."""
    places = {"y": y, "z": z}
    return tuple(
        SummaryValue(
            f"{prefix}_{row}{column}_N_per_m",
            partial(entry, row=places[row], column=places[column]),
            unit=Unit("N/m"),
        )
        for row, column in _NAMES
    )


RADIAL_STIFFNESSES = _entries("stiffness", 1, 2)  # of five directions: tilts are held
TOTAL_STIFFNESSES = _entries("total_stiffness", 0, 1)  # of y and z: tilts follow where they are free
