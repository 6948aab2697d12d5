"""Tolerance bands of a case: what its classes of clearance and fits come to at its diameters."""

from collections.abc import Callable, Iterator

from flexbearing.case.roller.bearing import Bearing
from flexbearing.case.roller.rings import Inner, Outer
from flexbearing.case.tolerances import (
    CLEARANCE,
    HOUSING,
    SHAFT,
    Band,
    housing_interference,
    initial_clearance,
    shaft_interference,
    tabulated,
)

_Read = tuple[str, str, Callable[[float], Band], float | None, str]  # key, class, table, diameter, its key


def bore_diameter(bearing: Bearing, inner: Inner) -> float | None:
    """Nominal bore of the inner ring [m]; None where the case does not give it."""
    if inner.kind != "rigid":
        return inner.bore
    return bearing.fits.bore if bearing.fits else None


def outside_diameter(bearing: Bearing, outer: Outer) -> float | None:
    """Nominal outside diameter of the outer ring [m]; None where the case does not give it."""
    if outer.kind == "rigid":
        return bearing.fits.outer_diameter if bearing.fits else None
    return bearing.outer_raceway_diameter + 2 * (outer.thickness or 0.0)


def bands(bearing: Bearing, inner: Inner, outer: Outer) -> dict[str, Band]:
    """Bands of a case's clearance before mounting and of its interferences.

    Raises
    ------
    PydanticCustomError
        where a diameter is missing, or none of the printed tables has it
    """
    return {row[0]: tabulated(*row) for row in _read(bearing, inner, outer)}


def _read(bearing: Bearing, inner: Inner, outer: Outer) -> Iterator[_Read]:
    """The classes that are given."""
    fits, bore = bearing.fits, bore_diameter(bearing, inner)
    of_bore = "bearing.fits.bore" if inner.kind == "rigid" else "inner.bore"
    if (clearance := bearing.clearance_class) is not None:
        yield CLEARANCE, clearance, lambda size: initial_clearance(clearance, size), bore, of_bore
    if fits and (shaft := fits.shaft) is not None:
        yield SHAFT, shaft, lambda size: shaft_interference(shaft, size), bore, of_bore
    if fits and fits.housing and (housing := fits.housing.tolerance_class) is not None:
        outside = outside_diameter(bearing, outer)
        owner = "bearing.fits.outer_diameter"
        yield HOUSING, housing, lambda size: housing_interference(housing, size), outside, owner
