"""Grooves in drawn rings: how they are found, pressed, and that they answer as those of a section."""

from functools import cache

import ngsolve as ngs
import numpy as np
import pytest
from netgen import occ
from pytest import approx

from fem import ClampedFace, ImpossiblePart, MeshSize, OuterRing, Resolution, Stations
from fem.condense import HARMONICS, SOLID, condense_in_process
from fem.errors import NotSolved
from fem.mesh.step_import import solid
from fem.parts.groove import Groove
from fem.parts.step_solid import Named, Near, StepSolid
from fem.solid.factored_solid import factored
from tests.drawn_grooves import GROOVE, HALF, LAND, OUTSIDE, ring, stations, torus, tube, written
from tests.fem.test_parts import STEEL

WIDTH = 1.2e-3  # of patches [m]
BALLS = (0.0, 0.7)
BACK = (Near(HALF * 1e-3, 40e-3, 0.0),)


@cache
def plain():
    return written(ring())


def part(drawing=None, **changes):
    given = {"raceway_diameter": 2 * LAND, "clamps": (Named("back"),), "elastic": STEEL, "groove": GROOVE}
    return StepSolid(drawing=drawing or plain(), **given | changes)


def resolution(order, size=WIDTH, width=WIDTH):
    return Resolution(
        length=GROOVE.width(LAND, 1), mesh_size=MeshSize(order=order, size=4e-3, raceway_size=size),
        stations=Stations(angles=stations(width, 3), width=width), azimuths=BALLS, threads=1,
    )  # fmt: skip


def found(drawing=None, **changes):
    return solid(part(drawing, **changes), GROOVE.width(LAND, 1))


def area(body):
    return sum(face.mass for face in body.faces if face.name == "raceway")


def test_groove_is_found_whole_also_where_it_is_drawn_in_pieces():
    end = GROOVE.end(LAND, 1)
    r, R = 1e3 * GROOVE.radius, 1e3 * GROOVE.centre_radius
    whole = 4 * np.pi * r * (R * end + r * np.sin(end))
    assert area(found()) == approx(whole, rel=1e-6)
    side = r * np.sin(end), 1e3 * LAND
    arcs = [
        occ.ArcOfCircle(
            occ.Pnt(-side[0], s * side[1], 0), occ.Pnt(0, s * (R + r), 0), occ.Pnt(*side[:1], s * side[1], 0)
        )
        for s in (-1, 1)
    ]
    halved = occ.Glue([ring(), *arcs]).solids[0]
    body = found(written(halved))
    assert [face.name for face in body.faces].count("raceway") == 2
    assert area(body) == approx(whole, rel=1e-6)


def test_a_patch_presses_along_the_normal_of_its_station():
    """By what it reads of rigid motions; outer patches are cut by the end of the arc, which moves them."""
    given = resolution(2)
    pressed = factored(part(), given.patches, given.mesh, 1)
    motion = ngs.GridFunction(pressed.space)
    read = []
    for axis in np.eye(3):
        motion.Set(ngs.CF(tuple(axis)))
        read.append(pressed.loads.T @ motion.vec.FV().NumPy())
    alpha, phi = np.tile(stations(WIDTH, 3), 2), np.repeat(BALLS, 3)
    normal = np.array([np.sin(alpha), np.cos(alpha) * np.sin(phi), np.cos(alpha) * np.cos(phi)])
    assert np.sum(read * normal, axis=0) == approx(1.0, abs=1e-3)
    assert np.array(read)[:, 1::3] == approx(normal[:, 1::3], abs=1e-3)


def test_a_drawn_ring_answers_as_its_section_the_closer_the_finer_it_is():
    as_section = OuterRing(
        raceway_diameter=2 * LAND, thickness=OUTSIDE * 1e-3 - LAND, width=2e-3 * HALF, elastic=STEEL,
        support=ClampedFace(), groove=GROOVE,
    )  # fmt: skip
    exact = condense_in_process(as_section, HARMONICS, resolution(5, 1e-3)).at(BALLS).absolute
    errors = [
        np.abs(condense_in_process(part(), SOLID, resolution(order)).absolute - exact).max()
        / np.abs(exact).max()
        for order in (2, 3)
    ]
    assert errors[0] < 0.06
    assert errors[1] < min(0.01, errors[0] / 3)


def test_wide_elements_are_refused():
    with pytest.raises(NotSolved, match="too narrow for this mesh of the groove"):
        condense_in_process(part(), SOLID, resolution(1, 4e-3, 0.1e-3))


BAD = {
    "plain bore": (tube(1e3 * LAND, OUTSIDE), {"clamps": BACK}, "arcs of those that are drawn: none"),
    "elsewhere": (ring(aside=0.1), {}, r"at x = 0\.1 mm"),
    "other arc": (ring(Groove(radius=6.7e-3, centre_radius=32.25e-3)), {}, r"drawn: radius 6\.7 mm"),
    "other pitch": (None, {"groove": Groove(radius=6.6e-3, centre_radius=32.4e-3)}, r"radius 32\.25"),
    "off the axis": (None, {"centre": (0, 0.1e-3, 0)}, "arcs of those that are drawn: none"),
    "hole": (ring() - occ.Cylinder(occ.Pnt(0, 0, 0), occ.Z, 1.0, 60), {}, "without holes"),
    "low shoulders": (tube(37.5, OUTSIDE) - torus(), {"clamps": BACK}, "reaches from x = -"),
    "clamped": (None, {"clamps": (Near(0.0, 38.85e-3, 0.0),)}, "the groove is clamped"),
}  # fmt: skip


@pytest.mark.parametrize("case", BAD)
def test_what_is_wrong_with_a_groove_is_said(case):
    shape, changes, words = BAD[case]
    with pytest.raises(ImpossiblePart, match=words):
        found(None if shape is None else written(shape), **changes)


def test_only_drawn_grooves_are_meshed_in_space():
    built = OuterRing(
        raceway_diameter=2 * LAND,
        thickness=5e-3,
        width=19e-3,
        elastic=STEEL,
        support=ClampedFace(),
        groove=GROOVE,
    )
    with pytest.raises(ImpossiblePart, match="a groove is impossible as SOLID"):
        condense_in_process(built, SOLID, resolution(2))
    with pytest.raises(ImpossiblePart, match="a groove is impossible as HARMONICS"):
        condense_in_process(part(), HARMONICS, resolution(2))
