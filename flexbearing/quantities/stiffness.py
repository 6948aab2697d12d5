"""Entries of the stiffness matrices that rotor dynamics requires."""

from functools import partial

from flexbearing.quantities.quantity import SummaryValue, Unit
from flexbearing.quantities.reductions import entry

RADIAL_STIFFNESSES, TOTAL_STIFFNESSES = (
    tuple(
        SummaryValue(
            f"{prefix}_{row}{column}_N_per_m",  # force by displacement
            partial(entry, row=places[row], column=places[column]),
            unit=Unit("N/m"),
        )
        for row, column in ("yy", "yz", "zy", "zz")
    )
    for prefix, places in (
        ("stiffness", {"y": 1, "z": 2}),  # of five directions: tilts are held
        ("total_stiffness", {"y": 0, "z": 1}),  # of y and z: tilts follow where they are free
    )
)
