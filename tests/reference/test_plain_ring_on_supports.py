"""Rings that may lift off, against a polygon of beams that tries every set of lines and springs."""

import numpy as np
import pytest
from pytest import approx

from fem import Elastic, Foundation, LineForce, LineSupports, MeshSize, OuterRing, PlanetGear
from tests.fem.condensed import as_beam, by_harmonics
from tests.reference.plain_ring_on_supports import PlainRing

STEEL = Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
THICKNESS, WIDTH, INSIDE = 1.5e-3, 8e-3, 40e-3
FAIR = MeshSize(order=5, size=3e-3, raceway_size=1.25e-3)
ROLLERS = 2 * np.pi * (0.5 + np.arange(12)) / 12
FORCES = 300 * np.maximum(np.cos(ROLLERS - 0.1), 0) ** 1.5
LINES = {
    "held by two of three": (60, 180, 300),
    "held by one and a little of another": (0, 120, 240),
    "four": (0, 90, 180, 270),
    "five": (-80, -35, 20, 75, 170),
}


def ring(support):
    return OuterRing(
        raceway_diameter=2 * INSIDE, thickness=THICKNESS, width=WIDTH, elastic=STEEL, support=support
    )


@pytest.fixture(scope="module")
def plain():
    return PlainRing(INSIDE + THICKNESS / 2, THICKNESS, WIDTH, STEEL.youngs_modulus, STEEL.poisson_ratio)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("lines", LINES.values(), ids=LINES.keys())
def test_ring_on_lines_that_only_push_is_the_plain_one(plain, lines):
    azimuths = np.radians(lines)
    support = LineSupports(azimuths=tuple(azimuths), pushing=True)
    under = by_harmonics(ring(support), WIDTH, 1, FAIR).under_rollers(ROLLERS)
    pushes, deviation = plain.on_lines(azimuths, ROLLERS, FORCES)
    found = under.line_forces(FORCES[:, None]).sum(axis=1)
    assert found == approx(pushes, rel=0, abs=3e-3 * pushes.max())
    assert np.array_equal(found > 0, pushes > 0)
    moved = np.tensordot(under.near(FORCES[:, None]).relative, FORCES[:, None], 2)[:, 0]
    assert moved == approx(deviation, rel=0, abs=0.02 * np.abs(deviation).max())


@pytest.mark.slow
@pytest.mark.parametrize(
    "condensed",
    [as_beam, lambda part, length, modes: by_harmonics(part, length, modes, FAIR)],
    ids=["beam", "section"],
)
@pytest.mark.parametrize("stiffness", [1e9, 1e10, 1e11], ids="{:.0e} N/m3".format)
def test_ring_on_springs_that_only_push_is_the_plain_one(plain, condensed, stiffness):
    support = Foundation(axial=0.0, radial=stiffness, tangential=0.0, pushing=True)
    under = condensed(ring(support), WIDTH, 1).under_rollers(ROLLERS)
    per_radian = stiffness * (INSIDE + THICKNESS) * WIDTH
    pushes, deviation = plain.on_springs(per_radian, ROLLERS, FORCES)
    pressure = under.pressure(FORCES[:, None]).mean(axis=1)
    expected = np.interp(under.around, plain.azimuth, pushes) / ((INSIDE + THICKNESS) * WIDTH)
    assert pressure == approx(expected, rel=0, abs=0.02 * expected.max())
    _, bilateral = plain.on_springs(per_radian, ROLLERS, FORCES, pull=True)
    released = (under.near(FORCES[:, None]).relative - under.closed.relative)[:, 0, :, 0] @ FORCES
    assert released == approx(deviation - bilateral, rel=0, abs=0.02 * np.abs(deviation - bilateral).max())
    assert np.abs(deviation - bilateral).max() > 0.1 * np.abs(deviation).max()


@pytest.mark.slow
@pytest.mark.parametrize("radius", [None, 46e-3, 55e-3], ids=["rim", "46 mm", "55 mm"])
def test_rim_under_teeth_bends_by_their_couple_too(plain, radius):
    """Two opposite teeth push along z with 800 N, rollers against them; the pitch circle adds a couple."""
    teeth, against = [(np.pi / 2, -400.0), (3 * np.pi / 2, 400.0)], -800 * np.cos(ROLLERS) / 6
    lines = tuple(LineForce(azimuth=psi, radial=0.0, tangential=pull) for psi, pull in teeth)
    on_rim, at_radius = (
        by_harmonics(ring(PlanetGear(forces=lines, radius=at)), WIDTH, 1, FAIR).at(ROLLERS)
        for at in (None, radius)
    )
    moved = at_radius.initial_deviation[:, 0] + at_radius.absolute[:, 0, :, 0] @ against
    at = [(psi, radius or INSIDE + THICKNESS, pull) for psi, pull in teeth]
    expected = plain.under_teeth(at, ROLLERS, against)
    assert moved == approx(expected, rel=0, abs=0.02 * np.abs(expected).max())
    couple = np.abs(at_radius.initial_deviation - on_rim.initial_deviation).max()
    assert radius is None or couple > 0.1 * np.abs(on_rim.initial_deviation).max()
