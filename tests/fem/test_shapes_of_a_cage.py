"""Cages with a collar, with bars at both ends or with their raceway aside; rings with it aside."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from pytest import approx

from fem import ClampedFace, Foundation, Housing, ImpossiblePart, LineSupports, MeshSize, OuterRing, RigidSeat
from fem.parts.resolution import Resolution
from fem.squirrel_cage.seat_growth import cage_seat_growth
from tests.fem.condensed import as_beam, by_harmonics, with_smeared_bars
from tests.fem.test_parts import CAGE, STEEL

L, M = 5e-3, 3
COARSE = MeshSize(order=2, size=4e-3, raceway_size=2.5e-3)
SECTION = MeshSize(order=4, size=3e-3, raceway_size=1.2e-3)
ROLLERS = 2 * np.pi * np.arange(30) / 30
COLLAR = {"collar_length": 2e-3, "collar_thickness": 6e-3}
SPRINGS = Foundation(axial=1e11, radial=3e11, tangential=1e11)
HELD = {
    "seat": RigidSeat(), "springs": SPRINGS, "one-sided springs": replace(SPRINGS, pushing=True),
    "housing": Housing(thickness=8e-3, width=14e-3, elastic=STEEL),
    "narrow housing": Housing(thickness=8e-3, width=8e-3, elastic=STEEL),
}  # fmt: skip


@cache
def by_beam(part):
    return as_beam(part, L, M, 40)


@cache
def by_smeared_bars(part):
    return with_smeared_bars(part, L, M, SECTION)


@cache
def by_half_a_pitch(part):
    return by_harmonics(part, L, M, COARSE)


MODELS = {
    "beam": (by_beam, 1e-9),
    "smeared": (by_smeared_bars, 1e-3),
    "half a pitch": (by_half_a_pitch, 8e-3),
}


def plain(support, offset):
    return OuterRing(
        raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, elastic=STEEL, support=support, offset=offset
    )


def mirrored(absolute):
    """Compliance (Z, M, Z, M) of the mirror image at x = 0: odd shapes along a roller change their sign."""
    sign = (-1.0) ** np.arange(absolute.shape[1])
    return absolute * sign[:, None, None] * sign


def apart(found, true):
    return np.abs(found - true).max() / np.abs(true).max()


@pytest.mark.slow
@pytest.mark.parametrize(("condense", "_"), MODELS.values(), ids=MODELS)
@pytest.mark.parametrize(
    "none", [{"collar_thickness": 9e-3}, {"collar_length": 2e-3, "collar_thickness": 3.6e-3}], ids=str
)
def test_collar_without_length_or_height_is_none(condense, _, none):
    """To the last bit."""
    assert np.array_equal(condense(replace(CAGE, **none)).response, condense(CAGE).response)


@pytest.mark.slow
@pytest.mark.parametrize(("condense", "allowed"), MODELS.values(), ids=MODELS)
@pytest.mark.slow
def test_bars_at_both_ends_neither_tilt_nor_prefer_a_side(condense, allowed):
    """The ring is its own mirror image, and about twice as stiff as on one end."""
    both, one = (condense(replace(CAGE, two_sided=two)).at(ROLLERS) for two in (True, False))
    assert apart(mirrored(both.absolute), both.absolute) < allowed
    assert apart(mirrored(one.absolute), one.absolute) > 0.05
    assert 1.9 < both.support_stiffness / one.support_stiffness < 2.7


@pytest.mark.parametrize(("condense", "allowed"), MODELS.values(), ids=MODELS)
@pytest.mark.slow
def test_bars_at_both_ends_carry_half_the_load_each(condense, allowed):
    """Equal section forces in mirrored bars; together they carry the resultant of the rollers."""
    both = condense(replace(CAGE, two_sided=True))
    forces = np.zeros((30, M))
    forces[:, 0] = np.maximum(np.cos(ROLLERS - 0.4), 0)
    carried, _ = both.bar_response.under(ROLLERS, forces)
    right, left = np.split(carried, 2)
    assert apart(right, left) < allowed
    shear = (carried[:, [1, 3]] - carried[:, [2, 4]]) / CAGE.bar_length
    azimuth = both.bar_response.azimuths
    normal = np.stack([np.sin(azimuth), np.cos(azimuth)])
    along = np.stack([np.cos(azimuth), -np.sin(azimuth)])
    resultant = np.array([np.sin(ROLLERS), np.cos(ROLLERS)]) @ forces[:, 0]
    assert normal @ shear[:, 0] + along @ shear[:, 1] == approx(resultant, rel=5e-3)


@pytest.mark.slow
@pytest.mark.parametrize(("condense", "allowed"), MODELS.values(), ids=MODELS)
def test_raceways_aside_of_a_cage_on_both_ends_are_mirror_images(condense, allowed):
    there, here = (
        condense(replace(CAGE, two_sided=True, offset=side * 1e-3)).at(ROLLERS).absolute for side in (1, -1)
    )
    assert apart(mirrored(there), here) < allowed
    assert apart(there, here) > 0.01


@pytest.mark.slow
@pytest.mark.parametrize("support", HELD.values(), ids=HELD)
def test_raceways_aside_of_a_ring_held_alike_are_mirror_images(support):
    def condensed(side):
        ring = by_harmonics(plain(support, side * 1e-3), L, M, SECTION)
        return getattr(ring, "raceway", ring).response[:, :2, :2]

    there, here, sign = condensed(1), condensed(-1), np.array([1, -1])
    assert apart(sign[:, None] * there * sign, here) < 1e-3
    assert apart(there, here) > 0.02


def test_beam_on_springs_feels_its_raceway_aside():
    there, here = (by_beam(plain(SPRINGS, side * 1e-3)).at(ROLLERS).absolute for side in (1, -1))
    assert apart(mirrored(there), here) < 1e-12
    fine = by_harmonics(plain(SPRINGS, 1e-3), L, M, SECTION).at(ROLLERS).absolute
    assert apart(there[:, 0, :, 0], fine[:, 0, :, 0]) < 0.05


@pytest.mark.slow
@pytest.mark.parametrize("shape", [COLLAR, {"two_sided": True}, {"offset": 1e-3}], ids=str)
def test_smeared_bars_agree_with_half_a_pitch(shape):
    """6.1 % at most as measured, as without these shapes."""
    part = replace(CAGE, **shape)
    smeared, true = by_smeared_bars(part).at(ROLLERS), by_half_a_pitch(part).at(ROLLERS)
    assert smeared.support_stiffness == approx(true.support_stiffness, rel=0.08)
    assert apart(smeared.relative[:, 0, :, 0], true.relative[:, 0, :, 0]) < 0.08


@pytest.mark.slow
def test_collar_over_the_whole_ring_is_a_thicker_ring_with_bars_inside():
    """Stiffer against ovalising nearly by the third power of its thickness."""
    oval = np.zeros((30, M))
    oval[:, 0] = np.cos(2 * ROLLERS)
    whole = replace(CAGE, collar_length=10e-3, collar_thickness=6e-3)
    thin, thick = (
        np.tensordot(by_smeared_bars(part).at(ROLLERS).absolute, oval, 2)[0, 0] for part in (CAGE, whole)
    )
    assert thick < 0.75 * thin


@pytest.mark.parametrize("collar", [COLLAR, {"collar_length": 10e-3, "collar_thickness": 6e-3}], ids=str)
def test_collar_is_no_beam(collar):
    with pytest.raises(ImpossiblePart, match="collar"):
        as_beam(replace(CAGE, **collar), L, M)


def test_raceway_aside_on_lines_is_refused():
    lines = LineSupports(azimuths=(0.0, 2.1, 4.2))
    with pytest.raises(ImpossiblePart, match=r"raceway_offset = 1 mm.*allowed is zero"):
        plain(lines, 1e-3)


def test_raceway_too_far_aside_is_refused():
    with pytest.raises(ImpossiblePart, match="track"):
        as_beam(plain(ClampedFace(), 2.6e-3), L, M)


@pytest.mark.slow
def test_seat_widens_a_cage_on_both_ends_without_coning():
    resolution = Resolution(length=L, axial_modes=M, mesh_size=COARSE)
    one, both = (
        cage_seat_growth(replace(CAGE, two_sided=two), resolution).coefficients[0] for two in (False, True)
    )
    assert abs(both[1]) < 0.02 * abs(one[1])
    assert both[0] == approx(one[0], rel=0.05)
