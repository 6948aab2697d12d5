"""Solids that a user has drawn: picks, the loaded band, and the same answers as the parts built in."""

from pathlib import Path

import ngsolve as ngs
import numpy as np
import pytest
from netgen import occ
from pytest import approx

from fem import ClampedFace, ImpossiblePart, MeshSize, OuterRing, Patches
from fem.mesh.solid import meshed
from fem.mesh.step_import import solid
from fem.parts.step_solid import Coloured, Named, Near, StepSolid
from tests.fem.condensed import as_solid
from tests.fem.test_parts import STEEL
from tests.places import CONFIGS

R, THICKNESS, WIDTH = 37.5, 4.5, 10.0  # [mm] of a plain ring, drawn about x
# the bearing's z along x of the drawing, its x along z, and so its y against y
ELSEWHERE = occ.gp_Trsf.Transformation(occ.Axes(occ.Pnt(10, 20, 30), n=occ.X, h=occ.Z)).Inverted()
FRAME = {"centre": (10e-3, 20e-3, 30e-3), "axis": (0, 0, 2.0), "zenith": (3.0, 0, 0)}
EXAMPLE = CONFIGS / "step_ring.step"


def step(shape):
    """Content of a STEP file, as a drawing program would write it."""
    file = Path(step.folder) / "drawn.step"
    shape.WriteStep(str(file))
    return file.read_bytes()


@pytest.fixture(scope="module", autouse=True)
def folder(tmp_path_factory):
    step.folder = tmp_path_factory.mktemp("step")


def tube(left, right, inner, outer, axis=occ.X):
    start = occ.Pnt(*(left * (axis.x, axis.y, axis.z)[k] for k in range(3)))
    return occ.Cylinder(start, axis, outer, right - left) - occ.Cylinder(start, axis, inner, right - left)


def plain():
    ring = tube(-WIDTH / 2, WIDTH / 2, R, R + THICKNESS)
    for face in ring.faces:
        face.name = "back" if face.center.x > WIDTH / 2 - 0.1 else "other"
    return ring


def part(shape, **changes):
    given = {"raceway_diameter": 2e-3 * R, "clamps": (Named("back"),), "elastic": STEEL} | changes
    return StepSolid(drawing=shape if isinstance(shape, bytes) else step(shape), **given)


def ring_on_three_feet():
    """The drawing of the example: about z, its raceway from z = 0 to 14 mm, no plane of the feet in x."""
    ring = tube(0, 14, 75.032 / 2, 42.5, occ.Z)
    ear = occ.Box(occ.Pnt(-6, 40, -1), occ.Pnt(6, 54, 5))
    feet = [ear.Rotate(occ.Axis(occ.Pnt(0, 0, 0), occ.Z), angle) for angle in (0, 120, 240)]
    whole = ring + feet[0] + feet[1] + feet[2] - occ.Cylinder(occ.Pnt(0, 0, -1), occ.Z, 75.032 / 2, 15)
    for face in whole.faces:
        if face.center.z < -0.9:
            face.name = "foot"
            face.col = (0.8, 0.1, 0.1)
    return whole


def band_area(body):
    return sum(face.mass for face in body.faces if face.name == "raceway")


def names(body):
    return sorted(face.name for face in body.faces if face.name)


def test_loaded_band_is_a_face_of_its_own():
    body = solid(part(plain()), 6e-3)
    assert band_area(body) == approx(2 * np.pi * R * 6, rel=1e-6)
    assert names(body) == ["clamped", "raceway"]


def test_band_as_long_as_the_raceway_needs_no_cut():
    body = solid(part(plain()), WIDTH * 1e-3)
    assert (len(body.faces), band_area(body)) == (4, approx(2 * np.pi * R * WIDTH, rel=1e-6))


def test_raceway_drawn_in_halves_is_found_whole():
    lines = [occ.Segment(occ.Pnt(-WIDTH / 2, 0, z), occ.Pnt(WIDTH / 2, 0, z)) for z in (-R, R)]
    halved = occ.Glue([plain(), *lines]).solids[0]
    assert len(halved.faces) == 5
    body = solid(part(halved), 6e-3)
    assert (names(body).count("raceway"), band_area(body)) == (2, approx(2 * np.pi * R * 6, rel=1e-6))


def test_mesh_has_the_band_and_the_clamp():
    mesh = meshed(part(plain()), 6e-3, MeshSize(order=3, size=8e-3, raceway_size=6e-3))
    area = ngs.Integrate(1, mesh, ngs.BND, definedon=mesh.Boundaries("raceway"))
    assert area == approx(2 * np.pi * R * 6, rel=1e-4)
    ends = ngs.Integrate(ngs.x, mesh, ngs.BND, definedon=mesh.Boundaries("clamped"))
    assert ends == approx(WIDTH / 2 * np.pi * ((R + THICKNESS) ** 2 - R**2), rel=1e-3)


@pytest.mark.slow
def test_drawn_ring_answers_as_the_one_built_in():
    """Other meshes of the same solid, no symmetry used: below 1 % apart, 10 % with quadratic elements."""
    ring = OuterRing(
        raceway_diameter=2e-3 * R, thickness=THICKNESS * 1e-3, width=WIDTH * 1e-3, elastic=STEEL,
        support=ClampedFace(),
    )  # fmt: skip
    patches = Patches(azimuths=(0.0, 0.4), length=6e-3, axial_modes=2, width=4e-3)
    built, drawn = (
        as_solid(solid, patches, MeshSize(order=3, size=8e-3, raceway_size=5e-3), threads=1)
        for solid in (ring, part(ELSEWHERE(plain()), **FRAME))
    )
    assert drawn.absolute == approx(built.absolute, abs=0.01 * np.abs(built.absolute).max())
    assert drawn.support_stiffness == approx(built.support_stiffness, rel=0.01)


def test_azimuth_turns_from_the_zenith_and_no_symmetry_is_assumed():
    """Held on one side, at azimuth 90 degrees: a mirror image of the rollers is not the same."""
    ring = tube(-WIDTH / 2, WIDTH / 2, R, R + THICKNESS)
    pad = occ.Box(occ.Pnt(-WIDTH / 2, R + 1, -4), occ.Pnt(WIDTH / 2, R + 9, 4)) - tube(-6, 6, 0.1, R + 1)
    drawn = part(ELSEWHERE(ring + pad), clamps=(Near(10e-3, 20e-3 - (R + 9) * 1e-3, 30e-3),), **FRAME)
    rollers = Patches(azimuths=(1.0, -1.0), length=6e-3, axial_modes=2, width=4e-3)
    own = as_solid(drawn, rollers, MeshSize(order=1, size=8e-3, raceway_size=6e-3), threads=1).absolute
    assert own[1, 0, 1, 0] > 2 * own[0, 0, 0, 0]


def test_scale_makes_the_part_larger():
    body = solid(part(plain(), scale=1.001), 6e-3)
    assert body.mass == approx(1.001**3 * np.pi * WIDTH * ((R + THICKNESS) ** 2 - R**2), rel=1e-6)


def test_lengths_of_a_drawing_in_metres_are_understood():
    text = step(tube(-WIDTH / 2e3, WIDTH / 2e3, R / 1e3, (R + THICKNESS) / 1e3))
    metres = text.replace(b"SI_UNIT(.MILLI.,.METRE.)", b"SI_UNIT($,.METRE.)")
    assert metres != text
    body = solid(part(metres, clamps=(Near(WIDTH / 2e3, R / 1e3 + 2e-3, 0),)), 6e-3)
    assert band_area(body) == approx(2 * np.pi * R * 6, rel=1e-6)


def test_faces_are_picked_by_name_colour_and_point():
    """The colour is as a screen shows it; 0.8 and 0.1 of the light are 231 and 89 there."""
    picks = (Named("foot"),), (Coloured(231, 89, 89),), tuple(feet())
    frame = {"centre": (0, 0, 7e-3), "axis": (0, 0, 1.0), "zenith": (0, 1.0, 0)}
    text = step(ring_on_three_feet())
    for clamps in picks:
        body = solid(part(text, clamps=clamps, raceway_diameter=75.032e-3, **frame), 9.601e-3)
        assert names(body) == ["clamped"] * 3 + ["raceway"]


def feet():
    for azimuth in np.radians([0, 120, 240]):
        yield Near(-50e-3 * np.sin(azimuth), 50e-3 * np.cos(azimuth), -1e-3)


def test_example_is_what_its_generator_draws():
    wanted, found = ring_on_three_feet(), occ.OCCGeometry(str(EXAMPLE)).shape
    assert found.mass == approx(wanted.mass, rel=1e-6)
    assert sorted(str(face.name) for face in found.faces) == sorted(str(face.name) for face in wanted.faces)


BLIND = occ.Cylinder(occ.Pnt(0, 0, 0), occ.Z, 2.0, 60)  # a hole through the raceway
CROWNED = occ.Revolve(
    occ.Face(occ.Wire([
        occ.ArcOfCircle(occ.Pnt(-5, R, 0), occ.Pnt(0, R - 0.1, 0), occ.Pnt(5, R, 0)),
        *(occ.Segment(occ.Pnt(*a, 0), occ.Pnt(*b, 0))
          for a, b in (((5, R), (5, R + 4)), ((5, R + 4), (-5, R + 4)), ((-5, R + 4), (-5, R)))),
    ])), occ.Axis(occ.Pnt(0, 0, 0), occ.X), 360,
)  # fmt: skip
INSIDE = (Near(0, R * 1e-3, 0),)
AT_END = (Near(5e-3, R * 1e-3 + 2e-3, 0),)
TWO_SIZES = tube(-5, 0, R, R + THICKNESS) + tube(0, 5, R + 0.02, R + THICKNESS)


def spoilt(shape, **changes):
    return lambda: solid(part(shape() if callable(shape) else shape, **changes), 6e-3)


BAD = {
    "no STEP file": (lambda: part(b"solid ascii"), "no STEP file"),
    "cut off": (lambda: solid(part(step(plain())[:5000]), 6e-3), "cannot be read as STEP"),
    "two solids": (spoilt(lambda: occ.Compound([plain(), plain().Move(occ.Vec(20, 0, 0))])), "2 solids"),
    "open shell": (spoilt(lambda: plain().faces[0]), "1 faces that do not close"),
    "no such name": (spoilt(plain, clamps=(Named("bacK"),)), '"back", "other"'),
    "no such colour": (spoilt(plain, clamps=(Coloured(1, 2, 3),)), "no face of colour #010203"),
    "point in the air": (spoilt(plain, clamps=(Near(0, 0, 0),)), "37.5 mm away"),
    "point on an edge": (spoilt(plain, clamps=(Near(5e-3, R * 1e-3, 0),)), "not clear"),
    "other diameter": (spoilt(plain, raceway_diameter=80e-3), "those that are drawn: 75 mm, 84 mm"),
    "raceway is a plane": (spoilt(plain, raceway=Named("back"), clamps=INSIDE), "are drawn: none"),
    "other axis": (spoilt(plain, axis=(0, 0, 1.0), zenith=(1.0, 0, 0)), "about the axis"),
    "off the axis": (spoilt(plain, centre=(0, 0.1e-3, 0)), "about the axis"),
    "two diameters": (spoilt(TWO_SIZES, clamps=AT_END), "75 and 75.04 mm diameter could both be meant"),
    "too short": (lambda: solid(part(plain()), 11e-3), "reaches from x = -5 to 5 mm"),
    "not in the middle": (spoilt(plain, centre=(3e-3, 0, 0)), "reaches from x = -8 to 2 mm"),
    "strip": (lambda: solid(part(plain()), 9.98e-3), "reaches 0.01 mm beyond"),
    "hole": (spoilt(plain() - BLIND), "without holes"),
    "crowned": (lambda: solid(part(CROWNED, clamps=AT_END), 10e-3), "are drawn: 83 mm"),
    "clamped raceway": (spoilt(plain, clamps=INSIDE), "the loaded band is clamped"),
    "picked twice": (spoilt(plain, raceway=Named("other"), clamps=(Named("other"),)), "is clamped"),
    "no clamp": (lambda: part(plain(), clamps=()), "nothing holds the structure"),
    "skew zenith": (lambda: part(plain(), zenith=(0.1, 0, 1.0)), "right angles"),
    "no axis": (lambda: part(plain(), axis=(0, 0, 0)), "longer than zero"),
    "scale": (lambda: part(plain(), scale=0.0), "scale = 0.0"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_what_is_wrong_is_said(case):
    make, message = BAD[case]
    with pytest.raises(ImpossiblePart, match=message.replace("(", r"\(")):
        make()


def test_condensing_reports_a_wrong_drawing_before_meshing():
    told = []
    rollers = Patches(azimuths=(0.0,), length=12e-3, axial_modes=2, width=1e-3)
    with pytest.raises(ImpossiblePart, match="allowed is the raceway"):
        as_solid(
            part(plain()),
            rollers,
            MeshSize(order=1, size=8e-3, raceway_size=6e-3),
            report=lambda *a: told.append(a),
        )
    assert told == [("mesh", None)]


def test_drawing_is_not_printed_with_the_part():
    assert len(repr(part(plain()))) < 500
