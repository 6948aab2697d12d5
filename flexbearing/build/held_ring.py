"""What holds a plain outer ring, the same in every family of bearings."""

import math
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import fem
from fem.parts.boundary_conditions import Support
from flexbearing import inputs
from flexbearing.case.read import LONGEST_NAME
from flexbearing.inputs.file import DRAWING
from flexbearing.printable import excerpt

if TYPE_CHECKING:
    from fem.parts.step_solid import Coloured, Named, StepSolid

PARALLEL = 1e-9  # [rad] between directions that are taken as one


def support(outer: Any, housing: fem.Elastic | None, *, hot: float = 1.0, pushing: bool = False) -> Support:
    """Support of a section with the keys of `flexbearing.case.held_ring`.

    Lengths of a housing and of teeth grow by `hot` with the ring; springs may only be `pushing`.
    """
    match outer.support:
        case "seat":
            return fem.RigidSeat()
        case "foundation":
            return fem.Foundation(
                axial=outer.foundation_axial,
                radial=outer.foundation_radial,
                tangential=outer.foundation_tangential,
                pushing=pushing,
            )
        case "housing":
            assert housing  # checked on reading
            return fem.Housing(
                thickness=outer.housing_thickness * hot,
                width=outer.housing_width * hot,
                elastic=housing,
                support=fem.RigidSeat() if outer.housing_support == "seat" else fem.ClampedFace(),
            )
        case "lines":
            return fem.LineSupports(azimuths=outer.line_azimuths, pushing=not outer.bilateral)
        case "planet":
            axial = getattr(outer, "tooth_axial", ()) or (0.0,) * len(outer.tooth_azimuths)
            parts = outer.tooth_azimuths, outer.tooth_radial, outer.tooth_tangential, axial
            return fem.PlanetGear(
                forces=tuple(
                    fem.LineForce(azimuth=a, radial=r, tangential=t, axial=x)
                    for a, r, t, x in zip(*parts, strict=True)
                ),
                radius=outer.tooth_radius and outer.tooth_radius * hot,
            )
        case _:
            return fem.ClampedFace()


def require_held_on_lines(outer: Any, load: complex) -> None:
    """Refuse lines that would have to pull to hold a load [N] along z + i y.

    Raises `ImpossiblePart` when no pushes of the lines add up to the load.
    """
    on_lines = outer.kind == "ring" and outer.support == "lines" and not outer.bilateral
    if not on_lines or load == 0:
        return
    direction = math.atan2(load.imag, load.real) % (2 * math.pi)
    ahead = [(azimuth - direction) % (2 * math.pi) for azimuth in outer.line_azimuths]
    behind = [-angle % (2 * math.pi) for angle in ahead]
    if min(ahead) + min(behind) < math.pi - PARALLEL or min(min(ahead), min(behind)) < PARALLEL:
        return
    lines = ", ".join(f"{math.degrees(azimuth):.4g}" for azimuth in outer.line_azimuths)
    raise fem.ImpossiblePart(
        f"outer.line_azimuths = {lines} deg: lines that only push do not hold a load towards "
        f"{math.degrees(direction):.4g} deg; allowed are lines on both sides of it, less than "
        "180 deg apart, or outer.bilateral = true where they can pull"
    )


def drawn(case: Any, **ring: Any) -> "StepSolid":
    """Solid from the STEP file that lies next to a case; keywords are fields that its family knows.

    Raises `ImpossiblePart` where the file cannot be read.
    """
    from fem.parts.step_solid import StepSolid

    outer, raceway = case.outer, getattr(case.outer, "raceway", None)  # of rollers
    assert case.drawing  # or the ring would not be drawn
    return StepSolid(
        drawing=_content(case.drawing),
        clamps=tuple(_pick(face) for face in outer.clamps),
        raceway=None if raceway is None else _pick(raceway),
        centre=(outer.centre_x, outer.centre_y, outer.centre_z),
        axis=_direction(outer.axis),
        zenith=_direction(outer.zenith),
        source=excerpt(outer.file),
        **ring,
    )


def _content(drawing: Path) -> bytes:
    try:
        return inputs.content(drawing, DRAWING)
    except inputs.Unreadable as problem:
        raise fem.ImpossiblePart(f"{excerpt(str(drawing), LONGEST_NAME)}: {problem}") from problem


def _pick(face: str) -> "Named | Coloured":
    """Choice of faces by a colour such as #e75959, or by a name."""
    from fem.parts.step_solid import Coloured, Named

    if re.fullmatch(r"#[0-9a-fA-F]{6}", face):
        return Coloured(*bytes.fromhex(face[1:]))
    return Named(face)


def _direction(name: str) -> tuple[float, float, float]:
    """Unit vector along an axis of the drawing."""
    vector = [0.0, 0.0, 0.0]
    vector["xyz".index(name[-1])] = -1.0 if name.startswith("-") else 1.0
    return vector[0], vector[1], vector[2]
