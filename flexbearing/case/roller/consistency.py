"""What one section of a roller case asks of the others: fits, classes of tolerances, structures."""

from collections.abc import Callable, Iterator

from flexbearing.case.quantity import impossible, in_mm, needed
from flexbearing.case.roller.bearing import Bearing
from flexbearing.case.roller.fits import Fits
from flexbearing.case.roller.numerics import Accuracy
from flexbearing.case.roller.rings import Inner, Outer
from flexbearing.case.roller.surroundings import Materials, Temperatures
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
CHOICE = 'for coupling.structure = "full"'
SUPPORTS = {"beam": ("side", "foundation"), "solid": ("side", "seat", "housing")}  # others know all
WITHOUT_MATRIX = ("beam", "solid")


ROWS = "beside bearing.second_row"
ENDS = 1e-9  # of the width of a part, by which it may reach beyond places of its temperature: rounding


def require_rows(
    structures: tuple[str, str], temperatures: Temperatures | None, inner: Inner, outer: Outer
) -> None:
    """Raise unless elastic rings are of a kind that is known under two rows of rollers."""
    if outer.kind not in ("rigid", "ring"):
        raise impossible("outer.kind", f'"rigid" or "ring" {ROWS}')
    if outer.kind == "ring" and outer.support not in ("side", "seat", "planet"):
        raise impossible("outer.support", f'"side", "seat" or "planet" {ROWS}')
    if inner.kind != "rigid" and inner.fit != "bonded":
        raise impossible("inner.fit", f'"bonded" {ROWS}')
    if structures[0] != "harmonics":
        raise impossible("accuracy.structure", f'"harmonics" {ROWS}')
    if structures[1] != "condensed":
        raise impossible("coupling.structure", f'"condensed" {ROWS}')
    if temperatures is not None:
        raise impossible("operation.temperatures", f"left out {ROWS} and an elastic ring")


def require_mounting(
    bearing: Bearing,
    clearance: float,
    materials: Materials,
    temperatures: Temperatures | None,
    inner: Inner,
    outer: Outer,
) -> None:
    """Raise unless every dimension, material and temperature of a mounting is given exactly once."""
    housing = bearing.fits.housing if bearing.fits else None
    if housing and outer.housing_clearance is not None:
        allowed = "left out: bearing.fits.housing.interference says the same with the opposite sign"
        raise impossible("outer.housing_clearance", allowed)
    for given, name in (
        (housing, "[bearing.fits.housing]"),
        (outer.housing_clearance, "outer.housing_clearance"),
    ):
        if given is not None and temperatures and temperatures.housing is None:
            raise needed(["operation.temperatures.housing"], name)
    housed = outer.kind == "ring" and outer.support == "housing"
    if housing and housed and housing.diameter is not None:
        raise impossible("bearing.fits.housing.diameter", "left out: outer.housing_thickness gives it")
    fits = bearing.mounting
    if fits is None:
        return
    _require_bore(bearing, clearance, fits, inner)
    _require_outside(bearing, fits, outer)
    if materials.shaft is None:
        raise needed(["materials.shaft"], "[bearing.fits]")
    if housing and outer.kind == "rigid" and materials.housing is None:
        raise needed(["materials.housing"], "[bearing.fits.housing]")


def require_covered(temperatures: Temperatures | None, inner: Inner, outer: Outer) -> None:
    """Raise unless a temperature that varies along the axis is known from end to end of its part."""
    widths = {
        "shaft": (inner.shaft_length, 0.0),
        "inner_ring": (inner.width, 0.0),
        "outer_ring": (outer.width, outer.raceway_offset),
        "housing": (outer.housing_width, outer.raceway_offset),
    }
    for part, (width, offset) in widths.items():
        along = getattr(temperatures, f"{part}_along", None)
        if along is None or width is None:
            continue
        first, last = (side * width / 2 - offset for side in (-1, 1))
        if along.at[0] > first + ENDS * width or along.at[-1] < last - ENDS * width:
            allowed = f"places from {in_mm(first)} or below to {in_mm(last)} or above, the ends of the part"
            raise impossible(f"operation.temperatures.{part}_along.at", allowed)


def _require_bore(bearing: Bearing, clearance: float, fits: Fits, inner: Inner) -> None:
    """Bore and shaft come from [bearing.fits] inside a rigid ring, else from [inner]."""
    if inner.kind != "rigid":
        for name, owner in (("bore", "inner.bore"), ("shaft_bore", "inner.shaft_thickness")):
            if getattr(fits, name) is not None:
                raise impossible(f"bearing.fits.{name}", f"left out: {owner} gives it")
        return
    if fits.bore is None:
        raise needed(["bearing.fits.bore"], 'inner.kind = "rigid" with [bearing.fits]')
    raceway = bearing.outer_raceway_diameter - 2 * bearing.roller.diameter - clearance
    if fits.bore >= raceway:
        raise impossible("bearing.fits.bore", f"below the inner raceway diameter {raceway * 1e3:.4g} mm")
    if fits.shaft_bore is not None and fits.shaft_bore >= fits.bore:
        raise impossible("bearing.fits.shaft_bore", f"below {in_mm(fits.bore)}, bearing.fits.bore")


def _require_outside(bearing: Bearing, fits: Fits, outer: Outer) -> None:
    """Outside diameter and housing come from [bearing.fits] around a rigid ring, else from [outer]."""
    if outer.kind != "rigid":
        if fits.outer_diameter is not None:
            raise impossible("bearing.fits.outer_diameter", "left out: outer.thickness gives it")
        if fits.housing is not None and outer.support != "housing":
            reason = f'left out: outer.kind = "{outer.kind}" sits in no housing'
            raise impossible("bearing.fits.housing", reason)
        return
    if fits.outer_diameter is None:
        raise needed(["bearing.fits.outer_diameter"], 'outer.kind = "rigid" with [bearing.fits]')
    if fits.outer_diameter <= bearing.outer_raceway_diameter:
        least = in_mm(bearing.outer_raceway_diameter)
        raise impossible("bearing.fits.outer_diameter", f"above {least}, bearing.outer_raceway_diameter")
    if fits.housing and fits.housing.diameter is None:
        raise needed(["bearing.fits.housing.diameter"], 'outer.kind = "rigid" with [bearing.fits.housing]')
    if fits.housing and (fits.housing.diameter or 0.0) <= fits.outer_diameter:
        allowed = f"above {in_mm(fits.outer_diameter)}, bearing.fits.outer_diameter"
        raise impossible("bearing.fits.housing.diameter", allowed)


def require_sizes_once(bearing: Bearing, inner: Inner, outer: Outer) -> None:
    """Raise where [bearing.ribs] repeats a diameter that rings or fits give, or one is no ring's."""
    ribs, raceway = bearing.ribs, bearing.outer_raceway_diameter
    if ribs is None:
        return
    for name, given, elsewhere in (
        ("bore", ribs.bore, inner.kind != "rigid" or bool(bearing.fits and bearing.fits.bore)),
        (
            "outside_diameter",
            ribs.outside_diameter,
            outer.kind != "rigid" or bool(bearing.fits and bearing.fits.outer_diameter),
        ),
    ):
        if given is not None and elsewhere:
            raise impossible(f"bearing.ribs.{name}", "left out: rings or [bearing.fits] give it")
    if ribs.outside_diameter is not None and ribs.outside_diameter <= raceway:
        allowed = f"above {in_mm(raceway)}, bearing.outer_raceway_diameter"
        raise impossible("bearing.ribs.outside_diameter", allowed)
    if ribs.bore is not None and ribs.bore >= raceway - 2 * bearing.roller.diameter:
        allowed = f"below {in_mm(raceway - 2 * bearing.roller.diameter)}, the inner raceway"
        raise impossible("bearing.ribs.bore", allowed)


def bore_diameter(bearing: Bearing, inner: Inner) -> float | None:
    """Nominal bore of the inner ring [m]; None where the case does not give it."""
    if inner.kind != "rigid":
        return inner.bore
    of_ribs = bearing.ribs.bore if bearing.ribs else None
    return bearing.fits.bore if bearing.fits and bearing.fits.bore else of_ribs


def outside_diameter(bearing: Bearing, outer: Outer) -> float | None:
    """Nominal outside diameter of the outer ring [m]; None where the case does not give it."""
    if outer.kind == "rigid":
        of_ribs = bearing.ribs.outside_diameter if bearing.ribs else None
        return bearing.fits.outer_diameter if bearing.fits and bearing.fits.outer_diameter else of_ribs
    return bearing.outer_raceway_diameter + 2 * (outer.thickness or 0.0)


def bands(bearing: Bearing, inner: Inner, outer: Outer) -> dict[str, Band]:
    """Bands of a case's clearance before mounting and of its interferences."""
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


def require_known(accuracy: Accuracy, inner: Inner, outer: Outer, *, lifts_off: bool) -> None:
    """Raise where a flexible part is none that the structure of the case knows."""
    structure = accuracy.structure
    choice = f'for accuracy.structure = "{structure}"'
    known = SUPPORTS.get(structure)
    if known and outer.kind == "ring" and not lifts_off and outer.support not in known:
        raise impossible("outer.support", f"{_or(known)} {choice}")
    if outer.kind == "matrix" and structure in WITHOUT_MATRIX:
        raise impossible("accuracy.structure", '"harmonics" or "smeared" for outer.kind = "matrix"')
    if structure != "beam":
        return
    if outer.kind == "squirrel_cage" and outer.collar_length:
        raise impossible(
            "outer.collar_length", f"left out {choice}: a collar makes it no beam of one section"
        )
    if inner.kind == "ring_on_shaft" and inner.fit == "bonded" and not inner.shaft_bore:
        raise impossible("inner.shaft_thickness", f"that of a hollow shaft {choice}: a solid one is no beam")


def require_solids(accuracy: Accuracy, inner: Inner, outer: Outer, *, lifts_off: bool) -> None:
    """Raise unless every flexible part is a linear solid, resolved as the case says."""
    if accuracy.structure != "solid" and "structure" in accuracy.model_fields_set:
        raise impossible("accuracy.structure", f'"solid" or left out {CHOICE}, which uses the whole solids')
    if accuracy.target is not None:
        raise impossible("accuracy.target", f"left out {CHOICE}: levels are chosen among condensed rings")
    if inner.kind != "rigid" and inner.fit != "bonded":
        raise impossible("inner.fit", f'"bonded" {CHOICE}: only a bonded ring has a solid')
    if outer.kind == "ring" and outer.support not in SUPPORTS["solid"]:
        raise impossible("outer.support", f"{_or(SUPPORTS['solid'])} {CHOICE}: others have no solid")
    if outer.kind == "matrix":
        raise impossible("outer.kind", f"another one {CHOICE}: a matrix has no solid")
    if lifts_off:
        raise impossible("bearing.fits.housing", f"left out {CHOICE}: only a bonded ring has a solid")


def _or(names: tuple[str, ...]) -> str:
    return " or ".join(f'"{name}"' for name in names)
