"""Shapes along the roller that a seat, heat and rotation give a raceway."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from fem import (
    ClampedFace,
    Foundation,
    ImpossiblePart,
    MeshSize,
    OuterRing,
    Resolution,
    RigidSeat,
    RingOnShaft,
)  # fmt: skip
from fem.condense import seat_growth
from fem.section.bonded_growth import bonded_growth
from fem.section.seat_growth import ring_seat_growth
from fem.squirrel_cage.seat_growth import cage_seat_growth
from tests.fem.test_parts import CAGE, SHAFT, STEEL

THIN = OuterRing(raceway_diameter=75e-3, thickness=1e-3, width=20e-3, elastic=STEEL, support=ClampedFace())
BAND = Resolution(length=5e-3, axial_modes=3, mesh_size=MeshSize(order=4, size=3e-3, raceway_size=1e-3))
COARSE = replace(BAND, mesh_size=MeshSize(order=2, size=4e-3, raceway_size=2e-3))


def test_clamped_tube_follows_its_seat_as_a_long_shell_does():
    """w / R = exp(-s) (cos s + sin s) from the clamp on (Timoshenko, Plates and Shells, art. 115)."""
    middle = (THIN.raceway_diameter + THIN.thickness) / 2
    decay = (3 * (1 - STEEL.poisson_ratio**2)) ** 0.25 / np.sqrt(middle * THIN.thickness)
    xi, weight = np.polynomial.legendre.leggauss(12)
    s = decay * (THIN.width / 2 - xi * BAND.length / 2)  # the clamp is at +x
    shape = middle * np.exp(-s) * (np.cos(s) + np.sin(s))
    expected = [
        (2 * m + 1) / 2 * (weight * shape) @ np.polynomial.legendre.Legendre.basis(m)(xi) for m in (0, 1)
    ]
    growth = ring_seat_growth(THIN, BAND)
    assert growth.coefficients[0, :2] == approx(expected, rel=0, abs=0.005 * middle)
    assert growth.mean == growth.coefficients[0, 0]


def test_rigid_seat_takes_the_raceway_with_it():
    """The wall, held along and around, thins by (1 + nu) / (1 - nu) of the strain."""
    ring, nu = replace(THIN, support=RigidSeat()), STEEL.poisson_ratio
    growth = ring_seat_growth(ring, BAND)
    thinned = ring.thickness * (1 + nu) / (1 - nu)
    assert growth.mean == approx(ring.raceway_diameter / 2 + thinned, rel=1e-3)
    assert np.abs(growth.at(np.zeros(1))).max() < 1e-3 * growth.mean


def test_a_cage_cones_towards_its_flange_and_hardly_ripples():
    """The cage of Mao, Wang and Zhang (2016), its flange seat 50 K colder: 5 um from end to end."""
    growth = cage_seat_growth(CAGE, COARSE)
    strain = -50 * 11.2e-6
    coned = 2 * strain * growth.at(np.zeros(1))[0, 1]
    assert coned == approx(-4.9e-6, rel=0.03)  # narrower at +x, where the flange is
    azimuths = np.linspace(0, 2 * np.pi / CAGE.bars, 7)
    ripple = growth.at(azimuths)
    assert ripple[0] == approx(ripple[-1], rel=1e-9)  # a pitch
    assert np.ptp(ripple[:, 0]) < 0.01 * abs(growth.coefficients[0, 1])


@pytest.mark.slow
def test_growth_of_a_cage_is_resolved():
    fine = Resolution(length=5e-3, axial_modes=3, mesh_size=MeshSize(order=3, size=3e-3, raceway_size=2e-3))
    usual, finer = (
        cage_seat_growth(CAGE, fine),
        cage_seat_growth(CAGE, replace(fine, mesh_size=MeshSize(order=4, size=2e-3, raceway_size=1.5e-3))),
    )
    largest = np.abs(finer.coefficients).max()
    assert usual.coefficients == approx(finer.coefficients, rel=0, abs=2e-3 * largest)


def test_short_bars_follow_the_seat_more_than_long_ones():
    short, long = (
        abs(cage_seat_growth(replace(CAGE, bar_length=length), COARSE).coefficients[0, 1])
        for length in (6e-3, 20e-3)
    )
    assert short > 1.5 * long


def test_a_ring_on_springs_has_no_seat_of_its_own():
    springs = Foundation(axial=1e9, radial=1e11, tangential=1e9)
    with pytest.raises(ImpossiblePart, match="no seat"):
        seat_growth(replace(THIN, support=springs), BAND)


def test_bonded_ring_without_ribs_grows_as_compound_tubes_do():
    """Long tubes of one material, free ends: outside, the mean strain (Timoshenko and Goodier, art. 151)."""
    long = RingOnShaft(
        raceway_diameter=65e-3, track_width=160e-3, rib_diameter=None, bore=59.6e-3, width=160e-3,
        shaft_bore=51.6e-3, shaft_length=161e-3, ring=STEEL, shaft=STEEL,
    )  # fmt: skip
    growth = bonded_growth(long, BAND)
    both = growth.under((1e-3, 1e-3), (0.0, 0.0), 0.0)
    assert both == approx([1e-3 * long.raceway_diameter / 2, 0.0, 0.0], rel=1e-9, abs=1e-12)
    a, b, c = (d / 2 for d in (long.shaft_bore, long.bore, long.raceway_diameter))
    shaft = growth.under((0.0, 1e-3), (0.0, 0.0), 0.0)
    assert shaft[0] == approx(1e-3 * (b**2 - a**2) * c / (c**2 - a**2), rel=2e-3)


def test_bonded_ring_between_ribs_bulges_along_the_roller():
    hot = bonded_growth(SHAFT, BAND).under((2.24e-3, 2.898e-3), (7850.0, 8240.0), 3979.0)
    assert hot[0] > 90e-6
    assert abs(hot[1]) < 1e-9  # by symmetry
    assert hot[2] == approx(0.33e-6, rel=0.1)
