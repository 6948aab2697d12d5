"""What fits and clearances of the rings ask of the other sections."""

from flexbearing.case.quantity import impossible, in_mm, needed
from flexbearing.case.roller.bearing import Bearing
from flexbearing.case.roller.fits import Fits
from flexbearing.case.roller.rings import Inner, Outer
from flexbearing.case.roller.surroundings import Materials, Temperatures


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
