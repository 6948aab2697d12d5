"""What `coupling.structure = "full"` asks of the other sections."""

from flexbearing.case.quantity import impossible
from flexbearing.case.roller.numerics import Accuracy
from flexbearing.case.roller.rings import Inner, Outer

CHOICE = 'for coupling.structure = "full"'
SOLID_SUPPORTS = ("side", "seat", "housing")


def require_solids(accuracy: Accuracy, inner: Inner, outer: Outer, *, lifts_off: bool) -> None:
    """Raise unless every flexible part is a linear solid, resolved as the case says."""
    if accuracy.structure != "solid" and "structure" in accuracy.model_fields_set:
        raise impossible("accuracy.structure", f'"solid" or left out {CHOICE}, which uses the whole solids')
    if accuracy.target is not None:
        raise impossible("accuracy.target", f"left out {CHOICE}: levels are chosen among condensed rings")
    if inner.kind != "rigid" and inner.fit != "bonded":
        raise impossible("inner.fit", f'"bonded" {CHOICE}: only a bonded ring has a solid')
    if outer.kind == "ring" and outer.support not in SOLID_SUPPORTS:
        allowed = " or ".join(f'"{support}"' for support in SOLID_SUPPORTS)
        raise impossible("outer.support", f"{allowed} {CHOICE}: others have no solid")
    if outer.kind == "matrix":
        raise impossible("outer.kind", f"another one {CHOICE}: a matrix has no solid")
    if lifts_off:
        raise impossible("bearing.fits.housing", f"left out {CHOICE}: only a bonded ring has a solid")
