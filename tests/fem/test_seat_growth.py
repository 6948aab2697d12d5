"""A seat that is warmer or colder than a ring widens and cones its raceway."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Foundation, ImpossiblePart, MeshSize, OuterRing, Resolution, RigidSeat
from fem.cage.seat_growth import cage_seat_growth
from fem.condense import seat_growth
from fem.section.seat_growth import ring_seat_growth
from tests.fem.test_parts import CAGE, STEEL

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
