"""What [bearing.fits] asks of the other sections."""

from typing import TYPE_CHECKING

from flexbearing.case.quantity import impossible, needed

if TYPE_CHECKING:
    from flexbearing.case.schema import Case


def require_mounting(case: "Case") -> None:
    """Raise unless every dimension, material and temperature of a mounting is given exactly once."""
    temperatures, fits = case.operation.temperatures, case.bearing.fits
    housing = fits.housing if fits else None
    if temperatures and temperatures.housing is not None and housing is None:
        raise impossible("operation.temperatures.housing", "left out: there is no [bearing.fits.housing]")
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
    fits, inner, outer = case.bearing.fits, case.inner, case.outer
    assert fits is not None
    if inner.kind == "rigid":
        if fits.bore is None:
            raise needed(["bearing.fits.bore"], 'inner.kind = "rigid" with [bearing.fits]')
    else:
        for name, owner in (("bore", "inner.bore"), ("shaft_bore", "inner.shaft_thickness")):
            if getattr(fits, name) is not None:
                raise impossible(f"bearing.fits.{name}", f"left out: {owner} gives it")
    if outer.kind == "rigid":
        if fits.outer_diameter is None:
            raise needed(["bearing.fits.outer_diameter"], 'outer.kind = "rigid" with [bearing.fits]')
    else:
        if fits.outer_diameter is not None:
            raise impossible("bearing.fits.outer_diameter", "left out: outer.thickness gives it")
        if fits.housing is not None:
            raise impossible("bearing.fits.housing", f'left out: outer.kind = "{outer.kind}" sits in no housing')
