"""Keys of a plain outer ring and of what holds it, the same in every family of bearings."""

from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

from flexbearing.case.quantity import Section, at_least, at_most, impossible, in_mm, key, require

RING = {"kind": ("ring",)}
CAGE = {"kind": ("squirrel_cage",)}
MATRIX = {"kind": ("matrix",)}
STEP = {"kind": ("step",)}
ON_SHAFT = {"kind": ("ring_on_shaft",)}
MOST = 360  # lines or teeth around a ring, clamped faces of a drawing
Direction = Literal["x", "y", "z", "-x", "-y", "-z"]
BARS = ("bars", "bar_width", "bar_thickness", "bar_length", "flange_length")


class OnShaft(Section):
    """What an inner ring is on."""

    if TYPE_CHECKING:  # keys in the order of each family
        bore: float | None
        shaft_thickness: float | None

    @property
    def shaft_bore(self) -> float:
        """Bore of the shaft under the ring [m]; zero is a solid shaft."""
        bore, thickness = self.bore or 0.0, self.shaft_thickness
        return 0.0 if thickness is None else max(bore - 2 * thickness, 0.0)


def _held(support: str) -> dict[str, tuple[str, ...]]:
    return {**RING, "support": (support,)}


def foundation_radial() -> Any:
    """Radial springs."""
    return key("springs per area on the outer surface, radial", "0 N/mm^3", ge=0, only=_held("foundation"))


def foundation(direction: str) -> Any:
    """Springs in another direction."""
    return key(f"the same, {direction}", "0 N/mm^3", ge=0, only=_held("foundation"))


def housing_thickness() -> Any:
    """Radial thickness."""
    return key("radial thickness of the housing", None, gt=0, only=_held("housing"))


def housing_width() -> Any:
    """Axial width."""
    return key("axial width of the housing", None, gt=0, only=_held("housing"))


def housing_support() -> Any:
    """Seat or side."""
    return key(
        "what holds the housing: a rigid seat on its outer surface, or its side face",
        "seat",
        only=_held("housing"),
    )


def housing_clearance(negative: str = "", **limits: float) -> Any:
    """Clearance in the housing."""
    return key(
        f"diametral clearance of ring and housing, cold and at rest{negative}, the same as a negative "
        "bearing.fits.housing.interference: they touch where the ring is pressed on the bore, without "
        "friction; without either they are bonded",
        None,
        example="20 um",
        only=_held("housing"),
        **limits,
    )


def line_azimuths() -> Any:
    """Lines that hold a ring."""
    return key(
        "azimuths of supporting lines, from z towards y",
        (),
        example=["0 deg", "120 deg", "240 deg"],
        strict=False,
        max_length=MOST,
        only=_held("lines"),
    )


def tooth_azimuths() -> Any:
    """Teeth of the rim of a planet gear."""
    return key(
        "azimuths of the tooth forces of a planet gear",
        (),
        example=["90 deg", "270 deg"],
        strict=False,
        max_length=MOST,
        only=_held("planet"),
    )


def tooth_forces(parts: str, example: list[str]) -> Any:
    """Forces of these teeth."""
    return key(f"their {parts}", (), example=example, strict=False, max_length=MOST, only=_held("planet"))


def tooth_radius() -> Any:
    """Where teeth press."""
    return key(
        "radius of the pitch circle at which they act; without it they act on the outer surface of the rim, "
        "and the couple of tangential forces about it is left out",
        None,
        example="60 mm",
        gt=0,
        only=_held("planet"),
    )


def file() -> Any:
    """Drawing of a ring."""
    return key("STEP file, next to the case file", None, example="ring.step", only=STEP)


def clamps() -> Any:
    """What holds a drawn ring."""
    return key(
        'faces of the drawing that do not move: names, or colours such as "#e75959"',
        (),
        example=["foot"],
        strict=False,
        max_length=MOST,
        only=STEP,
    )


def drawing(case: Any) -> Path | None:
    """STEP file of the outer ring, next to the case file; None for a ring that is not drawn."""
    outer = case.outer
    return Path(case.source.path).parent / outer.file if outer.kind == "step" and outer.file else None


def require_drawn(ring: Any) -> None:
    """Raise unless a drawing, what holds it and how it lies are given."""
    require(ring, ("file",), 'outer.kind = "step"')
    if not ring.clamps:
        raise impossible("clamps", "one face or more: a drawing without any can move freely")
    require_directions(ring)


def matrix() -> Any:
    """File of a stiffness matrix."""
    return key(
        "stiffness matrix, next to the case file: .sti of CalculiX, .mtx of Abaqus, .bdf, .dat, .pch or "
        ".dmig of Nastran",
        None,
        example="housing.sti",
        only=MATRIX,
    )


def nodes() -> Any:
    """File of its mesh."""
    return key(
        "its mesh, next to the case file, with *NODE or GRID: nodes on the outer surface of the ring hold it",
        None,
        example="housing.inp",
        only=MATRIX,
    )


def length_unit() -> Any:
    """Unit of both files."""
    return key("unit of length of both files", "1 mm", gt=0, only=MATRIX)


def force_unit() -> Any:
    """Unit of the matrix."""
    return key("unit of force of the matrix", "1 N", gt=0, only=MATRIX)


def axis(only: Any) -> Any:
    """Direction of the axis in a drawing or mesh."""
    return key("direction of the bearing's axis in the drawing or mesh", "x", only=only)


def zenith(only: Any) -> Any:
    """Direction of azimuth 0 in a drawing or mesh."""
    return key(
        "direction of azimuth 0 in the drawing or mesh, in which the load pulls where "
        "operation.load_direction is 0: under a load downwards the direction down",
        "z",
        only=only,
    )


def centre(words: str, only: Any) -> Any:
    """Place of the bearing in a drawing or mesh."""
    return key(words, "0 mm", only=only)


def shaft_thickness() -> Any:
    """Radial thickness."""
    return key("radial thickness of a hollow shaft; without it the shaft is solid", None, gt=0, only=ON_SHAFT)


def shaft_length() -> Any:
    """Length between the clamps."""
    return key("length of the shaft between its clamped ends", None, example="40 mm", gt=0, only=ON_SHAFT)


def bars() -> Any:
    """How many there are."""
    return key("number of bars", None, example=24, ge=1, le=200, only=CAGE)


def bar_thickness(place: str) -> Any:
    """Radial thickness of bars, centred on a place."""
    return of_cage(f"radial thickness of a bar, centred {place}")


def of_cage(words: str) -> Any:
    """A length of bars or flange."""
    return key(words, None, gt=0, only=CAGE)


def bar_ends() -> Any:
    """One or both."""
    return key(
        "ends of the ring at which there are bars, with their flange: that at +x, or both alike",
        "one",
        only=CAGE,
    )


def require_bars(ring: Any) -> list[Any]:
    """Return the values of `BARS`; raises when some are not given."""
    return require(ring, BARS, 'outer.kind = "squirrel_cage"')


def require_room_for_bars(ring: Any, inner_diameter: float, thickness: float, keys: str) -> None:
    """Raise unless bars fit into a ring of an inner diameter and a thickness [m], which `keys` give."""
    from fem.parts.room import SLENDEREST_SLOT
    from fem.parts.squirrel_cage import most_bars, thickest_bar, widest_bar

    bars, bar_width, bar_thickness, *_ = require_bars(ring)
    thickest = thickest_bar(thickness)
    if thickest <= 0:
        raise impossible("thickness", f"above {in_mm(thickness - thickest)}, or the bars end the ring")
    if bar_thickness > thickest:
        allowed = f"{at_most(thickest)}: bars are inside the {in_mm(thickness)} of {keys}"
        raise impossible("bar_thickness", allowed)
    inside = (inner_diameter + thickness - bar_thickness) / 2
    if bars > (most := most_bars(inside)):
        raise impossible("bars", f"at most {most}, with slots of {in_mm(SLENDEREST_SLOT)} between them")
    if bar_width > (widest := widest_bar(bars, inside)):
        slots = f"which leaves {bars} slots of {in_mm(SLENDEREST_SLOT)}"
        raise impossible("bar_width", f"{at_most(widest)}, {slots}")


def require_support(ring: Any) -> None:
    """Raise unless springs, a housing, lines or teeth are described where they hold a ring."""
    if ring.support == "foundation" and not (ring.foundation_radial or ring.foundation_tangential):
        raise impossible("foundation_radial", "above zero, or nothing holds the ring")
    if ring.support == "housing":
        require(ring, ("housing_thickness", "housing_width"), 'outer.support = "housing"')
    if ring.support == "lines" and not ring.line_azimuths:
        raise impossible("line_azimuths", "three or more azimuths, or the ring can move freely")
    if ring.support == "planet" and not ring.tooth_azimuths:
        raise impossible("tooth_azimuths", "one or more azimuths: teeth carry the load away")
    if ring.support == "planet" and not (
        len(ring.tooth_azimuths) == len(ring.tooth_radial) == len(ring.tooth_tangential)
    ):
        raise impossible("tooth_radial", "as many numbers as tooth_azimuths and tooth_tangential")


def require_teeth_outside(ring: Any, outside: float) -> None:
    """Raise unless teeth press outside of the outer surface of a rim [m]."""
    if ring.tooth_radius is not None and ring.tooth_radius < outside:
        raise impossible("tooth_radius", f"at least {outside * 1e3:.4g} mm, the outer surface of the rim")


def require_directions(ring: Any) -> None:
    """Raise unless two directions of a drawing or mesh are different."""
    if ring.axis[-1] == ring.zenith[-1]:
        raise impossible("zenith", "at right angles to outer.axis")


def require_shaft(ring: Any) -> None:
    """Raise unless a shaft below a ring has a wall, and reaches beyond the ring."""
    from fem.parts.room import ROUNDING, SLENDEREST_SLOT

    bore, width, length = require(ring, ("bore", "width", "shaft_length"), 'inner.kind = "ring_on_shaft"')
    wall = ring.shaft_thickness
    if bore < 2 * SLENDEREST_SLOT:
        raise impossible("bore", at_least(2 * SLENDEREST_SLOT))
    if wall is not None and not SLENDEREST_SLOT <= wall <= bore / 2:
        allowed = f"{at_least(SLENDEREST_SLOT)} and {at_most(bore / 2)}, half of inner.bore: a solid shaft"
        raise impossible("shaft_thickness", allowed)
    shortest = width + 2 * SLENDEREST_SLOT - ROUNDING
    if length < shortest:
        beside = f"inner.width and {in_mm(SLENDEREST_SLOT)} at each end"
        raise impossible("shaft_length", f"{at_least(shortest)}, {beside}")
