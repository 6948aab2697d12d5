"""Raceways as curved beams, beside the same ones as finite elements."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from fem import (
    ClampedFace,
    Discretisation,
    Foundation,
    LineSupports,
    MeshSize,
    OuterRing,
    Resolution,
    RigidSeat,
)
from fem.assembly.factorisation import NotSolved
from fem.beam import support_springs, thin_ring
from fem.beam.curved_beam import CurvedBeam
from fem.condense import condense
from fem.parts.rings import ImpossiblePart
from tests.fem.condensed import as_beam, by_harmonics, with_smeared_bars
from tests.fem.test_parts import CAGE as ODD_CAGE, SHAFT, STEEL

L, M = 5e-3, 3
ROLLERS = 2 * np.pi * np.arange(30) / 30
LOADS = np.zeros((30, M))
LOADS[:, 0] = 3000 * np.maximum(np.cos(ROLLERS), 0) ** 1.1
SOFT = Foundation(axial=0.0, radial=1e10, tangential=0.0)
THIN = OuterRing(raceway_diameter=75e-3, thickness=1e-3, width=10e-3, elastic=STEEL, support=SOFT)
# the cage of configs/mao2016.toml
CAGE = replace(
    ODD_CAGE, raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, bars=24, bar_width=4e-3,
    bar_thickness=2.6e-3, bar_length=10.25e-3, flange_length=5e-3, fillet=0.0,
)  # fmt: skip


def deviation(raceway):
    """Mean deviation at the rollers under a load zone [m]."""
    return np.tensordot(raceway.at(ROLLERS).relative, LOADS, 2)[:, 0]


def error(found, true):
    """Largest error of the deviation over its largest value."""
    return np.abs(deviation(found) - deviation(true)).max() / np.abs(deviation(true)).max()


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("part", "size", "allowed"),
    [
        (THIN, 0.7e-3, 0.02),
        (replace(THIN, thickness=3.6e-3), 1.25e-3, 0.01),
        (replace(THIN, thickness=3.6e-3, support=ClampedFace()), 1.25e-3, 0.06),
    ],
    ids=["1 mm on springs", "3.6 mm on springs", "one face clamped"],
)
def test_beam_deviates_like_finite_elements(part, size, allowed):
    """1.9, 0.5 and 5.1 % as measured."""
    fine = MeshSize(order=4, size=6e-3, raceway_size=size)
    assert error(as_beam(part, L, M), by_harmonics(part, L, M, fine)) < allowed


@pytest.mark.slow
def test_inner_ring_on_its_shaft_is_only_roughly_a_beam():
    """8.8 % as measured: a hollow shaft is a shell."""
    fine = MeshSize(order=5, size=6e-3, raceway_size=1.25e-3)
    assert error(as_beam(SHAFT, L, M), by_harmonics(SHAFT, L, M, fine)) < 0.15


@pytest.mark.slow
def test_both_models_of_a_cage_deviate_like_half_a_pitch_of_it():
    """Beam 1.1 %, smeared bars 0.3 % as measured."""
    true = by_harmonics(CAGE, L, M, MeshSize(order=3, size=3e-3, raceway_size=2e-3))
    assert error(as_beam(CAGE, L, M), true) < 0.015
    assert error(with_smeared_bars(CAGE, L, M, MeshSize(order=3, size=6e-3, raceway_size=2e-3)), true) < 0.005


def test_two_models_of_a_cage_agree():
    """A beam on springs, and sections with a sleeve: 1.3 % as measured."""
    sleeve = with_smeared_bars(CAGE, L, M, MeshSize(order=3, size=6e-3, raceway_size=2e-3))
    assert error(as_beam(CAGE, L, M), sleeve) < 0.02


def test_fewer_bars_hold_a_smeared_cage_less():
    """Half as many carry half the translation of a stiff ring, nearly."""
    stiff = replace(CAGE, bar_length=60e-3, thickness=8e-3)
    wishes = L, 1, MeshSize(order=3, size=6e-3, raceway_size=3e-3)
    many, few = (with_smeared_bars(replace(stiff, bars=n), *wishes).at(ROLLERS) for n in (24, 12))
    assert few.support_stiffness == approx(many.support_stiffness / 2, rel=0.03)


def test_free_ring_of_one_percent_of_its_radius_ovalises_like_a_thin_one():
    """R^3 / (18 pi E I) per force of harmonic 2: it is far softer than its elements."""
    part = replace(THIN, thickness=0.4e-3, support=LineSupports(azimuths=(0.0, 2.0, 4.0)))
    raceway = by_harmonics(part, L, M, MeshSize(order=4, size=4e-3, raceway_size=1e-3)).ring.raceway
    oval = raceway.response[list(raceway.harmonics).index(2), 0, 0]
    inertia, radius = part.width * part.thickness**3 / 12, 37.7e-3
    assert oval == approx(radius**3 / (18 * np.pi * STEEL.youngs_modulus * inertia), rel=0.05)


@given(st.floats(0.01, 0.2), st.floats(0.02, 0.3), st.floats(0.05, 2.0))
def test_free_ring_resists_no_rigid_motion(radius, thickness, width):
    """Translation and tilt for n = 1, translation along the axis for n = 0."""
    beam = CurvedBeam(
        inside=radius * (1 - thickness / 2), outside=radius * (1 + thickness / 2), width=width * radius,
        elastic=STEEL,
    )  # fmt: skip
    across, tilt = np.array([0, 1, -1, 0, 0, 0.0]), np.array([-beam.radius, 0, 0, 1, -1, 0.0])
    still, turning = beam.stiffness([0, 1])
    assert turning @ across == approx(np.zeros(6), abs=1e-9 * turning.max())
    assert turning @ tilt == approx(np.zeros(6), abs=1e-9 * turning.max())
    assert not still[0].any()
    assert np.linalg.eigvalsh(beam.stiffness([2, 7]))[:, 0].min() > 0


def test_long_waves_bend_the_wall_and_short_ones_indent_it():
    s = np.array([0.0, 0.0999, 0.1001, 1e3, 1e5])
    share = thin_ring.layer_share(s)
    assert share[0] == 0
    assert share[2] - share[1] == approx(32 / 175 * 2e-4, rel=1e-3)  # no step between series and function
    assert share[3:] == approx(1 - 1.2 / s[3:], rel=1e-6)
    assert thin_ring.layer_share(2.0, 2) == approx(
        (np.sinh(4.0) / 2 + 2) / (np.sinh(2.0) ** 2 - 4), rel=1e-12
    )


def test_short_waves_are_those_of_a_half_space():
    """So the own terms have a sum, and what is subtracted from them is what they contain."""
    raceway = as_beam(THIN, L, M)
    last = raceway.harmonics[-1]
    n = np.arange(last - 20, last + 1)
    alone = (1 - STEEL.poisson_ratio**2) / (np.pi * STEEL.youngs_modulus) / (n * L)
    assert raceway.response[last + n, 0, 0] == approx(alone, rel=0.06)


def test_ring_on_springs_moves_as_a_whole():
    """Radial springs of a circle: K = k pi r w."""
    stiff = replace(THIN, elastic=replace(STEEL, youngs_modulus=1e16))
    held = as_beam(stiff, L, M).at(ROLLERS).support_stiffness
    assert held == approx(1e10 * np.pi * 38.5e-3 * 10e-3, rel=1e-3)


def test_response_is_symmetric_and_positive():
    for part in (THIN, CAGE, SHAFT):
        response = as_beam(part, L, M).response
        assert response == approx(response.transpose(0, 2, 1), rel=0, abs=1e-18)
        assert np.linalg.eigvalsh(response).min() > 0


def test_seat_is_refused():
    with pytest.raises(ImpossiblePart, match="RigidSeat"):
        as_beam(replace(THIN, support=RigidSeat()), L, M)


def test_band_longer_than_the_track_is_refused():
    for condensed in (
        as_beam,
        lambda *a: with_smeared_bars(*a, MeshSize(order=3, size=1, raceway_size=1)),
    ):
        with pytest.raises(ImpossiblePart, match="track"):
            condensed(CAGE, 11e-3, M)


def test_too_few_harmonics_are_refused():
    with pytest.raises(NotSolved, match="8 or more"):
        as_beam(THIN, L, M, 7)


# -- springs of supports ---------------------------------------------------------------------------


def at(x, rho, motion):
    """Displacement (x, r, t) of a point fixed to the section, as `fem.beam.curved_beam` defines it."""
    U, W, V, theta, chi, psi = motion
    return np.array([U - rho * theta, W + x * theta, V + rho * psi + x * chi])


def energy(stiffness, motion):
    return motion @ stiffness @ motion


@given(st.lists(st.floats(-1, 1), min_size=6, max_size=6), st.floats(-2e-3, 2e-3))
def test_foundation_holds_every_point_of_its_cylinder_by_its_own_springs(motion, offset):
    """Its three springs differ, and so do the places; energy by Gauss points along the cylinder."""
    springs, radius, width = (1e9, 2e9, 5e9), 40e-3, 10e-3
    node, weight = np.polynomial.legendre.leggauss(3)
    points = [at(x, offset, motion) for x in width / 2 * node]
    expected = sum(
        w * width / 2 * radius * (np.array(springs) @ u**2) for w, u in zip(weight, points, strict=True)
    )
    found = energy(support_springs.foundation(springs, radius, width, offset), np.array(motion))
    assert found == approx(expected, rel=1e-9, abs=1e-9)


@given(st.lists(st.floats(-1, 1), min_size=6, max_size=6), st.floats(-2e-2, 2e-2), st.floats(-2e-3, 2e-3))
def test_link_to_the_ground_is_stretched_by_the_motion_of_its_middle(motion, middle, offset):
    compliance = np.array([1.0, 2.0, 3.0, 4.0, 5.0, 6.0]) * 1e-9
    stretched = np.concatenate([at(middle, offset, motion), motion[3:]])
    support = support_springs.SupportCompliance(middle=middle, offset=offset, compliance=compliance)
    for stiffness in (support_springs.on_ground(support), support_springs.in_series(support)):
        expected = stretched**2 @ (1 / compliance)
        assert energy(stiffness, np.array(motion)) == approx(expected, rel=1e-6, abs=1e-9)


def test_beam_on_a_foundation_takes_each_spring_where_it_belongs():
    springs = Foundation(axial=1e9, radial=2e9, tangential=5e9)
    part = OuterRing(raceway_diameter=75e-3, thickness=1e-3, width=10e-3, elastic=STEEL, support=springs)
    held = thin_ring.stiffness_of(part, np.array([2])) - thin_ring.beam_of(part).stiffness(np.array([2]))
    area = (75e-3 / 2 + 1e-3) * 10e-3  # per radian
    assert np.diag(held[0])[:3] == approx(np.array([1e9, 2e9, 5e9]) * area, rel=1e-9)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("pushing", [False, True])
def test_beam_on_stiff_springs_takes_as_many_harmonics_as_it_needs(pushing):
    """5 to 7 % of its own compliance lay beyond the usual ones, which was refused."""
    springs = Foundation(axial=1e11, radial=1e12, tangential=3e11, pushing=pushing)
    part = OuterRing(raceway_diameter=75e-3, thickness=1e-3, width=19e-3, elastic=STEEL, support=springs)
    condensed: Any = condense(part, Discretisation.BEAM, Resolution(length=9.6e-3, axial_modes=3))
    raceway = condensed.raceway if pushing else condensed
    assert raceway.truncation < 0.05
    own = np.einsum("zmzm->zm", raceway.absolute(np.linspace(0.0, 6.0, 14)))
    assert (own > 0).all()
