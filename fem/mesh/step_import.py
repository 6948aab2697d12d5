# The geometry kernel fills its module at run time, where the type checker cannot look.
# pyright: reportAttributeAccessIssue=false
"""The solid of a STEP drawing, brought to the bearing's frame, its loaded band cut out [mm].

A CAD program may have drawn a cylinder as halves, with other names, about another axis, in inches.
Faces are recognised by points on their edges, seams included: the bounding boxes of the kernel are loose.
"""

import re
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from netgen import occ
from netgen.meshing import NgException
from numpy.typing import NDArray

from fem.parts.groove import Groove
from fem.parts.material import ImpossiblePart, in_mm
from fem.parts.quoted import enumerated, shortened
from fem.parts.step_solid import Coloured, Named, Near, Pick, StepSolid

MILLIMETRES = 1e3  # per metre
EXACT = 1e-3  # [mm] closer places are one; drawings are exact to about a tenth of it
AGREEMENT = 2e-3  # allowed relative difference between the drawn raceway and the bearing's
ARC = 1e-2  # of the groove's radius: allowed difference between the drawn arc and the bearing's
CLOSE = 1.0  # [mm] a point further away from a face does not pick it
NARROWEST_STRIP = 0.05  # [mm] beside the loaded band: narrower ones cannot be meshed well
WHOLE = 1e-5  # allowed relative difference in area between the band and a full cylinder
WHOLE_GROOVE = 1e-4  # the same of a groove, whose radius is a smaller number
COLOUR = 1.5  # allowed difference of a colour, out of 255

_NOTHING = ""
_TEXT = re.compile(rb"'[^']*'")
_NO_NUMBER = re.compile(  # the kernel would not end
    rb"[(,]\s*[+-]?(?:nan|inf)|[0-9.]E\+?(?:[3-9][0-9]{2}|[0-9]{4})", re.IGNORECASE
)


def solid(part: StepSolid, length: float):
    """The drawn solid in the bearing's frame [mm], x along the axis, faces "raceway" and "clamped" named.

    "raceway" is exactly the loaded band of `length` [m], or the whole groove as it is drawn.
    Raises `ImpossiblePart` if the drawing cannot be read or is not one solid, if the kernel cannot work with
    it, if a pick finds no face or no clear one, if the raceway is no cylinder about the axis with the
    diameter of the bearing, or no groove with its arc, or if the band does not fit.
    """
    try:
        return _solid(part, length)
    except (NgException, RuntimeError) as refusal:  # of the geometry kernel
        raise ImpossiblePart(
            f"{part.source} cannot be worked with: {shortened(str(refusal))}; repair it and export it again"
        ) from refusal


def _solid(part: StepSolid, length: float):
    body = _read(part)
    _mark(body, part)
    body = _placed(body, part)
    if part.groove is not None:
        body = body.solids[0]
        _name_groove(body, part.groove, part.arc(part.groove))
        body.mat("ring")
        return body
    radius, left, right = _raceway(body, part)
    ends = _ends(left, right, length * MILLIMETRES / 2)
    circles = [occ.Circle(occ.Pnt(x, 0, 0), occ.X, radius) for x in ends]
    cut = occ.Glue([body, *circles]).solids[0] if circles else body.solids[0]
    _name_band(cut, radius, length * MILLIMETRES / 2)
    cut.mat("ring")
    return cut


def _read(part: StepSolid):
    """The one solid of the file."""
    if _NO_NUMBER.search(_TEXT.sub(b"", part.drawing)):
        raise ImpossiblePart(f"{part.source} holds numbers that are not finite; export the drawing again")
    with TemporaryDirectory() as folder:
        file = Path(folder) / "drawing.step"
        file.write_bytes(part.drawing)
        try:
            shape = occ.OCCGeometry(str(file)).shape
        except NgException as refusal:
            raise ImpossiblePart(
                f"{part.source} cannot be read as STEP: {shortened(str(refusal))}"
            ) from refusal
    if len(shape.solids) == 1:
        return shape.solids[0]
    if len(shape.solids) > 1:
        raise ImpossiblePart(
            f"{part.source} holds {len(shape.solids)} solids; allowed is one: unite them before the export"
        )
    what = (
        f"{len(shape.faces)} faces that do not close around a solid"
        if len(shape.faces)
        else "no faces at all"
    )
    raise ImpossiblePart(f"{part.source} holds {what}; allowed is one closed solid")


def _mark(body, part: StepSolid) -> None:
    """Name the picked faces, and take all other names away."""
    clamped = [_picked(body, pick, part, "clamps") for pick in part.clamps]
    raceway = _picked(body, part.raceway, part, "raceway") if part.raceway else []
    for face in body.faces:
        face.name = _NOTHING
    for faces in clamped:
        for face in faces:
            face.name = "clamped"
    for face in raceway:
        if face.name == "clamped":
            raise ImpossiblePart(f"raceway: the face {part.raceway} is clamped; draw an edge between both")
        face.name = "raceway"


def _picked(body, pick: Pick, part: StepSolid, purpose: str) -> list:
    """Faces that a pick means."""
    if isinstance(pick, Near):
        return [_nearest(body, pick, purpose)]
    faces = [face for face in body.faces if _fits(face, pick)]
    if not faces:
        raise ImpossiblePart(f"{purpose}: {part.source} has no face {pick}; {_offered(body)}")
    return faces


def _offered(body) -> str:
    """Names and colours that a user can pick."""
    names = {f'"{shortened(face.name)}"' for face in body.faces if face.name}
    screen = [_screen_colour(face) for face in body.faces]
    colours = {"#" + bytes(colour.round().astype(np.uint8)).hex() for colour in screen if colour is not None}
    return f"its names are {enumerated(names)}, its colours {enumerated(colours)}"


def _fits(face, pick: Named | Coloured) -> bool:
    if isinstance(pick, Named):
        return face.name == pick.name
    colour = _screen_colour(face)
    return colour is not None and np.abs(colour - (pick.red, pick.green, pick.blue)).max() < COLOUR


def _screen_colour(face) -> NDArray | None:
    """Colour of a face on a screen, 0 to 255 (IEC 61966-2-1); the kernel holds the intensity of light."""
    if not face.col:
        return None
    light = np.array(face.col[:3])
    return 255 * np.where(light <= 0.0031308, 12.92 * light, 1.055 * light ** (1 / 2.4) - 0.055)


def _nearest(body, pick: Near, purpose: str):
    point = occ.Vertex(occ.Pnt(*(c * MILLIMETRES for c in (pick.x, pick.y, pick.z))))
    (distance, _, face), *others = sorted(
        (face.Distance(point), number, face) for number, face in enumerate(body.faces)
    )
    if distance > CLOSE:
        raise ImpossiblePart(
            f"{purpose}: no face {pick}; the nearest one is {distance:.3g} mm away, allowed is {CLOSE:g} mm"
        )
    if others and others[0][0] < 2 * distance + 10 * EXACT:
        raise ImpossiblePart(
            f"{purpose}: the face {pick} is not clear: two faces are {distance:.3g} and "
            f"{others[0][0]:.3g} mm away; take a point well inside one of them"
        )
    return face


def _placed(body, part: StepSolid):
    """The solid in the bearing's frame, scaled."""
    frame = occ.Axes(
        occ.Pnt(*(c * MILLIMETRES for c in part.centre)), n=occ.Dir(*part.zenith), h=occ.Dir(*part.axis)
    )
    return occ.gp_Trsf.Scale(occ.Pnt(0, 0, 0), part.scale)(occ.gp_Trsf.Transformation(frame)(body))


def _raceway(body, part: StepSolid) -> tuple[float, float, float]:
    """Radius of the drawn raceway and its ends [mm]."""
    marked = [face for face in body.faces if face.name == "raceway"]
    rims = [_rim(face) for face in marked or body.faces]
    cylinders = [(radius, rim) for rim in rims if (radius := _radius(rim)) is not None]
    nominal = part.raceway_diameter / 2 * MILLIMETRES
    fitting = [(radius, rim) for radius, rim in cylinders if abs(radius - nominal) < AGREEMENT * nominal]
    if not fitting or (marked and len(fitting) < len(marked)):
        drawn = enumerated({f"{2 * radius:.6g} mm" for radius, _ in cylinders})
        which = f"the face {part.raceway}" if marked else "one face or more"
        raise ImpossiblePart(
            f"raceway: allowed is {which} on a straight cylinder of {2 * nominal:.6g} mm about the axis "
            f"{part.axis} through {part.centre} m; the diameters of those that are drawn: {drawn}"
        )
    radii = [radius for radius, _ in fitting]
    if max(radii) - min(radii) > EXACT:
        raise ImpossiblePart(
            f"raceway: cylinders of {2 * min(radii):.6g} and {2 * max(radii):.6g} mm diameter could both be "
            "meant; pick one by its name, its colour or a point"
        )
    x = np.concatenate([rim[:, 0] for _, rim in fitting])
    return float(np.mean(radii)), float(x.min()), float(x.max())


def _rim(face) -> NDArray:
    """Points on the edges of a face (points, 3) [mm]."""
    points = []
    for edge in face.edges:
        if edge.mass > EXACT:
            first, last = edge.parameter_interval
            points += [edge.Value(s) for s in np.linspace(first, last, 5)]
    return np.array([(p.x, p.y, p.z) for p in points]).reshape(-1, 3)


def _radius(rim: NDArray) -> float | None:
    """Radius of a face whose edges all lie on one cylinder about the axis."""
    radii = np.hypot(rim[:, 1], rim[:, 2])
    return float(radii.mean()) if radii.size and np.ptp(radii) < EXACT else None


def _ends(left: float, right: float, half: float) -> list[float]:
    """Where circles have to cut the raceway so that the band ends there [mm]."""
    if left > -half + EXACT or right < half - EXACT:
        raise ImpossiblePart(
            f"length = {2e-3 * half:.6g} m of the loaded band; allowed is the raceway, which reaches from "
            f"x = {left:.6g} to {right:.6g} mm"
        )
    for strip in (-half - left, right - half):
        if EXACT < strip < NARROWEST_STRIP:
            raise ImpossiblePart(
                f"the raceway reaches {strip:.3g} mm beyond the loaded band; allowed is nothing or "
                f"{NARROWEST_STRIP:g} mm and more, which can be meshed"
            )
    return [x for x, end in ((-half, left), (half, right)) if abs(x - end) > EXACT]


def _name_band(body, radius: float, half: float) -> None:
    """Name the band "raceway", and make sure that it is whole."""
    band = [face for face in body.faces if _within(_rim(face), radius, half)]
    missing = 1 - sum(face.mass for face in band) / (4 * np.pi * radius * half)
    if abs(missing) > WHOLE:
        raise ImpossiblePart(
            f"raceway: {missing:.3%} of the loaded band are not on the cylinder of {2 * radius:.6g} mm; "
            "allowed is a band without holes or grooves"
        )
    if any(face.name == "clamped" for face in band):
        raise ImpossiblePart("clamps: the loaded band is clamped; draw an edge between raceway and clamp")
    for face in body.faces:
        if face.name == "raceway":
            face.name = _NOTHING
    for face in band:
        face.name = "raceway"


def _name_groove(body, groove: Groove, arc: tuple[float, float]) -> None:
    """Name the faces of a groove "raceway", and make sure that it is whole and has an arc [rad]."""
    centre, radius = groove.centre_radius * MILLIMETRES, groove.radius * MILLIMETRES
    rims = [(face, rim) for face in body.faces if (rim := _rim(face)).size]
    arcs = [(face, rim, one) for face, rim in rims if (one := _arc(rim)) is not None and one[2] < centre]
    fitting = [each for each in arcs if np.abs(each[2] - (0.0, centre, radius)).max() < ARC * radius]
    if not fitting:
        drawn = enumerated({_words(one) for *_, one in arcs})
        raise ImpossiblePart(
            f"groove: allowed is one face or more with {_words(np.array([0.0, centre, radius]))}, about the "
            f"axis of the bearing; the arcs of those that are drawn: {drawn}"
        )
    if any(face.name == "clamped" for face, *_ in fitting):
        raise ImpossiblePart("clamps: the groove is clamped; draw an edge between groove and clamp")
    x = np.concatenate([rim[:, 0] for _, rim, _ in fitting])
    left, right = float(x.min()), float(x.max())
    first, last = radius * np.sin(arc)
    if left > first + EXACT or right < last - EXACT:
        raise ImpossiblePart(
            f"groove: its lands leave x = {first:.6g} to {last:.6g} mm for balls; allowed is a drawing that "
            f"reaches as far, but it reaches from x = {left:.6g} to {right:.6g} mm"
        )
    place, r, a = np.mean([one for *_, one in fitting], axis=0)
    ends = np.arcsin(np.clip((np.array([left, right]) - place) / a, -1, 1))
    area = 2 * np.pi * a * (r * np.ptp(ends) + a * np.ptp(np.sin(ends)))
    missing = 1 - sum(face.mass for face, *_ in fitting) / area
    if abs(missing) > WHOLE_GROOVE:
        raise ImpossiblePart(
            f"groove: {missing:.3%} of it are not on its arc; allowed is a groove without holes or notches"
        )
    for face, *_ in fitting:
        face.name = "raceway"


def _words(arc: NDArray) -> str:
    """An arc as it is offered."""
    x, centre, radius = (in_mm(length / MILLIMETRES) for length in arc)
    return f"radius {radius} about a circle of radius {centre} at x = {x}"


def _arc(rim: NDArray) -> NDArray | None:
    """Centre x and r and radius of a face whose edges all lie on one arc turned about the axis."""
    x, r = rim[:, 0], np.hypot(rim[:, 1], rim[:, 2])
    equations = np.stack([2 * x, 2 * r, np.ones_like(x)], axis=1)
    (place, centre, rest), _, rank, _ = np.linalg.lstsq(equations, x**2 + r**2)
    radius = np.sqrt(max(rest + place**2 + centre**2, 0.0))
    on_arc = np.abs(np.hypot(x - place, r - centre) - radius).max() < EXACT
    return np.array([place, centre, radius]) if rank == len(equations.T) and on_arc else None


def _within(rim: NDArray, radius: float, half: float) -> bool:
    rim_radius = _radius(rim)
    return (
        rim_radius is not None and abs(rim_radius - radius) < EXACT and np.abs(rim[:, 0]).max() < half + EXACT
    )
