"""What fits and clearances of the rings ask of the other sections."""

from typing import TYPE_CHECKING

from flexbearing.case.quantity import impossible, needed
from flexbearing.case.roller.fits import Fits

if TYPE_CHECKING:
    from flexbearing.case.roller.roller_case import Case


def require_mounting(case: "Case") -> None:
    """Raise unless every dimension, material and temperature of a mounting is given exactly once."""
    temperatures, fits = case.operation.temperatures, case.bearing.fits
    housing = fits.housing if fits else None
    if case.outer.lifts_off and temperatures and temperatures.housing is None:
        raise needed(["operation.temperatures.housing"], "outer.housing_clearance")
    if fits is None:
        return
    _require_dimensions(case)
    if case.materials.shaft is None:
        raise needed(["materials.shaft"], "[bearing.fits]")
    if housing and case.materials.housing is None:
        raise needed(["materials.housing"], "[bearing.fits.housing]")
    if housing and temperatures and temperatures.housing is None:
        raise needed(["operation.temperatures.housing"], "[bearing.fits.housing]")


def _require_dimensions(case: "Case") -> None:
    """Each diameter comes from [bearing.fits] beside a rigid part, else from [inner] or [outer]."""
    fits, inner, outer = case.bearing.fits, case.inner, case.outer
    assert fits is not None
    if inner.kind == "rigid":
        _require_shaft(case, fits)
    else:
        for name, owner in (("bore", "inner.bore"), ("shaft_bore", "inner.shaft_thickness")):
            if getattr(fits, name) is not None:
                raise impossible(f"bearing.fits.{name}", f"left out: {owner} gives it")
    if outer.kind == "rigid":
        _require_outside(case, fits)
        return
    if fits.outer_diameter is not None:
        raise impossible("bearing.fits.outer_diameter", "left out: outer.thickness gives it")
    if fits.housing is not None:
        raise impossible("bearing.fits.housing", f'left out: outer.kind = "{outer.kind}" sits in no housing')


def _require_shaft(case: "Case", fits: Fits) -> None:
    if fits.bore is None:
        raise needed(["bearing.fits.bore"], 'inner.kind = "rigid" with [bearing.fits]')
    bearing = case.bearing
    raceway = bearing.outer_raceway_diameter - 2 * bearing.roller.diameter - fits.cold_clearance
    if fits.bore >= raceway:
        raise impossible("bearing.fits.bore", f"below the inner raceway diameter {raceway * 1e3:.4g} mm")
    if fits.shaft_bore is not None and fits.shaft_bore >= fits.bore:
        raise impossible("bearing.fits.shaft_bore", "below bearing.fits.bore")


def _require_outside(case: "Case", fits: Fits) -> None:
    if fits.outer_diameter is None:
        raise needed(["bearing.fits.outer_diameter"], 'outer.kind = "rigid" with [bearing.fits]')
    if fits.outer_diameter <= case.bearing.outer_raceway_diameter:
        raise impossible("bearing.fits.outer_diameter", "above bearing.outer_raceway_diameter")
    if fits.housing and fits.housing.diameter <= fits.outer_diameter:
        raise impossible("bearing.fits.housing.diameter", "above bearing.fits.outer_diameter")
