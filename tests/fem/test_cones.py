"""Rings with conical raceways: rigid motions, the cylinder as a limit, own terms, what cannot be."""

from dataclasses import replace
from math import cos, radians, sin, tan

import numpy as np
import pytest
from numpy.polynomial import legendre
from pytest import approx

import fem
from fem.condense import BEAM, HARMONICS, condense

BAND, WIDTH, RADIUS, THICKNESS = 14e-3, 16e-3, 31e-3, 5e-3
STEEL = fem.Elastic(youngs_modulus=206e9, poisson_ratio=0.3)
SPRINGS = 1e11, 2e11, 3e11  # axial, radial, tangential [N/m^3]
TAPER = radians(14)
SLIGHT = TAPER / 4
AZIMUTHS = 2 * np.pi * np.arange(7) / 7
SHAPES = 3


def cup(taper=TAPER, **changes):
    axial, radial, tangential = SPRINGS
    parts = {
        "raceway_diameter": 2 * RADIUS, "thickness": THICKNESS, "width": WIDTH, "elastic": STEEL,
        "taper": taper, "support": fem.Foundation(axial=axial, radial=radial, tangential=tangential),
    }  # fmt: skip
    return fem.OuterRing(**{**parts, **changes})


def condensed(part, shapes=SHAPES, harmonics=None, size=0.25 * BAND, along=False):
    mesh = fem.MeshSize(order=5, size=1.2 * BAND, raceway_size=size)
    resolution = fem.Resolution(
        length=BAND, axial_modes=shapes, mesh_size=mesh, harmonics=harmonics, row_distance=part.row_distance,
        along=along,
    )  # fmt: skip
    return condense(part, HARMONICS, resolution)


def motions(x, radius, azimuth):
    """Axial, radial and tangential displacement (3, 5) of a point by x, y, z and turns about y and z."""
    s, c = np.sin(azimuth), np.cos(azimuth)
    return np.array([
        [1, 0, 0, radius * c, -radius * s], [0, s, c, -x * c, x * s], [0, c, -s, x * s, x * c],
    ])  # fmt: skip


@pytest.mark.parametrize("apart", [0.0, 20e-3], ids=["one row", "two rows"])
@pytest.mark.parametrize("taper", [TAPER, -TAPER])
def test_nearly_rigid_cup_on_springs_is_a_closed_form(apart, taper):
    outside, width, stiffness = RADIUS + THICKNESS, WIDTH + apart, np.zeros((5, 5))
    points, weights = legendre.leggauss(6)
    for azimuth in 2 * np.pi * np.arange(12) / 12:
        for x, weight in zip(points * width / 2, weights * width / 2, strict=True):
            moved = motions(x, outside, azimuth)
            area = weight * outside * 2 * np.pi / 12
            stiffness += area * np.einsum("i,ia,ib->ab", SPRINGS, moved, moved)
    rows = [(-apart / 2, taper), (apart / 2, -taper)][: 1 + bool(apart)]
    places = [(*row, azimuth) for row in rows for azimuth in AZIMUTHS]
    read = np.zeros((len(places), SHAPES + 1, 5))
    for j, (middle, angle, azimuth) in enumerate(places):
        for x, weight in zip(points, weights, strict=True):
            axial, radial, _ = motions(middle + x * BAND / 2, RADIUS + x * BAND / 2 * tan(angle), azimuth)
            shapes = legendre.legvander(np.array([x]), SHAPES - 1)[0] * (2 * np.arange(SHAPES) + 1) / 2
            read[j, :-1] += weight * np.outer(shapes, cos(angle) * radial - sin(angle) * axial)
            read[j, -1] += weight / 2 * (cos(angle) * axial + sin(angle) * radial)
    expected = np.einsum("jma,ab,knb->jmkn", read, np.linalg.inv(stiffness), read)
    stiff = replace(STEEL, youngs_modulus=1e6 * STEEL.youngs_modulus)
    part = cup(taper, elastic=stiff, width=width, row_distance=apart)
    found = condensed(part, along=True).at(np.tile(AZIMUTHS, len(rows))).absolute
    assert found == approx(expected, rel=0, abs=5e-5 * np.abs(expected).max())


def test_rows_far_apart_on_a_seat_have_rings_of_their_own():
    """But for the wall between the rows, which is no cone: differences fall with the angle."""
    parts = {"support": fem.RigidSeat(), "thickness": 8e-3, "width": 2 * WIDTH}
    apart = 80e-3
    one = condensed(cup(SLIGHT, **{**parts, "width": 2 * WIDTH + apart, "row_distance": apart})).at(
        np.tile(AZIMUTHS, 2)
    )
    for row, taper in enumerate((SLIGHT, -SLIGHT)):
        own, other = (slice(each * 7, each * 7 + 7) for each in (row, 1 - row))
        alone = condensed(cup(taper, **parts)).at(AZIMUTHS).absolute
        size = np.abs(alone).max()
        assert one.absolute[own, :, own] == approx(alone, rel=0, abs=1e-2 * size)
        assert np.abs(one.absolute[own, :, other]).max() < 1e-3 * size


def test_the_cylinder_is_the_limit():
    cylinder = condensed(cup(0.0)).at(AZIMUTHS)
    for taper in (1e-3, 1e-5):
        cone = condensed(cup(taper)).at(AZIMUTHS)
        change = np.abs(cone.absolute - cylinder.absolute).max() / np.abs(cylinder.absolute).max()
        assert 0.2 * taper < change < taper
        assert cone.support_stiffness == approx(cylinder.support_stiffness, rel=taper)


def test_own_terms_are_those_beside_a_roller_without_the_half_space():
    """A line on a cone and two near it, which are further away where the cone is wide, followed to none."""
    near = np.array([0.0, 0.01, 0.02])
    compliance = condensed(cup(), harmonics=120, size=0.03 * BAND).at(near).absolute[0]  # (M, Z, M)
    points, weights = legendre.leggauss(400)
    along, radius = points * BAND / 2 / cos(TAPER), RADIUS + points * BAND / 2 * tan(TAPER)
    shapes = legendre.legvander(points, SHAPES - 1) * (2 * np.arange(SHAPES) + 1) / 2 * weights[:, None]
    beside = []
    for number in (1, 2):
        gap = 2 * np.sqrt(np.multiply.outer(radius, radius)) * sin(near[number] / 2)
        distance = np.hypot(along[:, None] - along, gap)
        half_space = (1 - 0.3**2) / (np.pi * 206e9) * shapes.T @ (1 / distance) @ shapes
        beside.append(compliance[:, number] - half_space)
    own, followed = compliance[:, 0], 2 * beside[0] - beside[1]
    assert own == approx(followed, rel=0, abs=3e-3 * own.max())
    assert own[0, 1] == approx(followed[0, 1], rel=6e-3)  # 1.5 % less without what the wide end gains


def test_a_ring_on_a_shaft_has_a_conical_raceway():
    shaft = fem.RingOnShaft(
        raceway_diameter=44e-3, track_width=WIDTH, rib_diameter=None, bore=30e-3, width=WIDTH, shaft_bore=0.0,
        shaft_length=40e-3, ring=STEEL, shaft=STEEL, taper=-radians(10),
    )  # fmt: skip
    own = condensed(shaft).at(AZIMUTHS).absolute[0, :, 0]
    mirrored = condensed(replace(shaft, taper=radians(10))).at(AZIMUTHS).absolute[0, :, 0]
    sign = np.array([1.0, -1.0, 1.0])
    assert mirrored == approx(sign[:, None] * own * sign, rel=0, abs=1e-3 * own.max())
    assert abs(own[0, 1]) > 0.3 * own[0, 0]  # wall and radius are larger at one end


IMPOSSIBLE = {
    "wall": (lambda: cup(thickness=1.9e-3), "leaves a wall"),
    "lines": (
        lambda: cup(support=fem.LineSupports(azimuths=(0.0, 2.0, 4.0))),
        "conical raceway is impossible",
    ),
    "springs": (
        lambda: cup(support=fem.Foundation(axial=0.0, radial=1e11, tangential=0.0)),
        "along its axis",
    ),
    "rows elsewhere": (
        lambda: condense(cup(), HARMONICS, fem.Resolution(length=BAND, axial_modes=2, row_distance=20e-3)),
        "0 mm apart are impossible under rows 20 mm apart",
    ),
    "wall of two rows": (lambda: cup(thickness=2.2e-3, width=36e-3, row_distance=16e-3), "leaves a wall"),
    "beam": (lambda: condense(cup(), BEAM, fem.Resolution(length=BAND)), "impossible as BEAM"),
}


@pytest.mark.parametrize(("made", "why"), IMPOSSIBLE.values(), ids=IMPOSSIBLE)
def test_impossible_cones_are_refused(made, why):
    with pytest.raises(fem.ImpossiblePart, match=why):
        made()
