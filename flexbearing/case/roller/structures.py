"""Which parts `accuracy.structure` and `coupling.structure` know."""

from flexbearing.case.quantity import impossible
from flexbearing.case.roller.numerics import Accuracy
from flexbearing.case.roller.rings import Inner, Outer

CHOICE = 'for coupling.structure = "full"'
SUPPORTS = {"beam": ("side", "foundation"), "solid": ("side", "seat", "housing")}  # others know all
WITHOUT_MATRIX = ("beam", "solid")


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
    if inner.kind == "ring_on_shaft" and inner.fit == "bonded" and inner.shaft_thickness is None:
        raise impossible("inner.shaft_thickness", f"given {choice}: a solid shaft is no curved beam")


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
