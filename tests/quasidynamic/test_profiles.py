"""Profiles of rollers and raceways: closed points, printed forms, points in a file, sums of both."""

from math import e, exp, log, pi, sqrt

import numpy as np
import pytest
from pytest import approx
from scipy.interpolate import PchipInterpolator

from quasidynamic import (
    Crowned,
    ImpossiblePart,
    Logarithmic,
    LogarithmicCrown,
    PointsProfile,
    TangentCrowned,
    solve_many,
    static_loads,
)
from quasidynamic.contact.half_space import ElasticPair
from quasidynamic.contact.line import fujiwara_kawase, half_width, johns_gohar, lundberg
from quasidynamic.contact.pressure.roller import RollerOnRaceway
from tests.bearings import paper_bearing

LENGTH, RADIUS, MODULUS, LOAD = 10e-3, 4.2e-3, 226e9, 6e3
AMPLITUDE = 2 * LOAD / (pi * LENGTH * MODULUS)
END = np.array([LENGTH / 2])
STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)


def slope(profile, position, step=1e-9):
    ahead, behind = (profile.drop(np.array([position + side * step]), LENGTH)[0] for side in (1, -1))
    return (ahead - behind) / (2 * step)


def test_logarithmic_profile_at_known_places():
    drop = lundberg(LOAD, LENGTH, MODULUS).drop(
        np.array([0.0, LENGTH / 4, LENGTH / 2 * sqrt(1 - 1 / e)]), LENGTH
    )
    assert drop == approx([0.0, AMPLITUDE * log(4 / 3), AMPLITUDE], rel=1e-12, abs=1e-20)


def test_drop_at_the_end_after_johns_and_gohar_is_that_of_lundberg():
    profile = johns_gohar(LOAD, LENGTH, MODULUS, RADIUS)
    width = float(half_width(LOAD / LENGTH, RADIUS, MODULUS))
    assert profile.drop(END, LENGTH) == approx(AMPLITUDE * (1.1932 + log(LENGTH / 2 / width)), rel=2e-5)
    x = np.linspace(-1, 1, 21) * LENGTH / 2
    printed = -AMPLITUDE * np.log(1 - (1 - 0.3033 * width / (LENGTH / 2)) * (2 * x / LENGTH) ** 2)
    assert profile.drop(x, LENGTH) == approx(printed, rel=1e-4, abs=1e-20)
    assert exp(-1.1932) == approx(0.3033, rel=2e-4)


def test_three_parameters_of_one_and_its_own_drop_are_johns_and_gohar():
    known = johns_gohar(LOAD, LENGTH, MODULUS, RADIUS)
    same = fujiwara_kawase(
        LOAD, LENGTH, MODULUS, load_factor=1.0, crowned_share=1.0, end_drop=float(known.drop(END, LENGTH)[0])
    )
    x = np.linspace(-1, 1, 41) * LENGTH / 2
    assert same.drop(x, LENGTH) == approx(known.drop(x, LENGTH), rel=1e-12, abs=1e-20)


def test_three_parameters_shape_the_profile():
    profile = fujiwara_kawase(LOAD, LENGTH, MODULUS, load_factor=1.5, crowned_share=0.6, end_drop=20e-6)
    assert profile.drop(END, LENGTH) == approx(20e-6, rel=1e-12)
    assert profile.drop(np.array([0.4 * LENGTH / 2, -0.3 * LENGTH / 2]), LENGTH) == approx(0.0, abs=1e-20)
    assert slope(profile, 0.4 * LENGTH / 2) == approx(0.0, abs=1e-6)  # no corner at the straight middle
    a, y_m, big = LENGTH / 2, 0.6 * LENGTH / 2, 1.5 * AMPLITUDE
    y = 0.8 * a
    printed = -big * log(1 - (1 - exp(-20e-6 / big)) * ((y - a) / y_m + 1) ** 2)
    assert profile.drop(np.array([y]), LENGTH) == approx(printed, rel=1e-12)


def test_deep_ends_of_three_parameters_are_the_logarithm():
    deep = LogarithmicCrown(amplitude=AMPLITUDE, end_drop=60 * AMPLITUDE, crowned_share=1.0)
    x = np.linspace(-0.99, 0.99, 23) * LENGTH / 2
    assert deep.drop(x, LENGTH) == approx(
        Logarithmic(amplitude=AMPLITUDE).drop(x, LENGTH), rel=1e-12, abs=1e-20
    )


def test_circular_ends_with_and_without_a_corner():
    corner, tangent = (kind(straight_length=6e-3, crown_radius=0.5) for kind in (Crowned, TangentCrowned))
    assert tangent.drop(END, LENGTH) == approx((2e-3) ** 2 / (2 * 0.5), rel=1e-5)
    assert corner.drop(END, LENGTH) == approx(((5e-3) ** 2 - (3e-3) ** 2) / (2 * 0.5), rel=1e-4)
    assert slope(tangent, 3e-3 + 2e-9) == approx(0.0, abs=1e-7)
    assert slope(corner, 3e-3 + 2e-9) == approx(3e-3 / 0.5, rel=1e-4)
    whole = [kind(straight_length=0.0, crown_radius=0.5) for kind in (Crowned, TangentCrowned)]
    x = np.linspace(-1, 1, 11) * LENGTH / 2
    assert whole[0].drop(x, LENGTH) == approx(whole[1].drop(x, LENGTH), rel=1e-9, abs=1e-16)


@pytest.mark.parametrize("profile", ["lundberg", "johns_gohar"])
def test_design_load_spreads_evenly_along_the_roller(profile):
    """What the profiles were derived for, found by the pressure of half-spaces."""
    modulus = 2 / STEEL.plane_compliance
    shape = (
        lundberg(LOAD, LENGTH, modulus)
        if profile == "lundberg"
        else johns_gohar(LOAD, LENGTH, modulus, RADIUS)
    )
    roller = RollerOnRaceway(
        pair=STEEL, radius=RADIUS, length=LENGTH, drop=lambda y: shape.drop(y, LENGTH), cells=(32, 256)
    )
    line_load = roller.tilted(LOAD, 0.0).line_load[16:-16]
    assert line_load == approx(LOAD / LENGTH, rel=0.05)
    lighter = roller.tilted(LOAD / 3, 0.0).line_load[16:-16]
    assert np.ptp(lighter) > 0.25 * lighter.mean()


def test_points_are_hit_and_never_overshot():
    rng = np.random.default_rng(3)
    positions = np.r_[-5.0, np.sort(rng.uniform(-4.9, 4.9, 9)), 5.0] * 1e-3
    drops = rng.uniform(0, 10e-6, 11)
    drops[4] = 0.0
    profile = PointsProfile.through(positions, drops, LENGTH)
    x = np.linspace(-1, 1, 997) * LENGTH / 2
    known = PchipInterpolator(positions, drops)(x)
    assert profile.drop(x, LENGTH) == approx(known, rel=1e-9, abs=1e-18)
    assert profile.drop(positions, LENGTH) == approx(drops, rel=1e-12, abs=1e-20)
    between = np.interp(x, positions, np.arange(11)).astype(int).clip(0, 9)
    assert (profile.drop(x, LENGTH) <= np.maximum(drops[between], drops[between + 1]) + 1e-15).all()
    assert (profile.drop(x, LENGTH) >= np.minimum(drops[between], drops[between + 1]) - 1e-15).all()
    assert not profile.symmetric


def test_points_of_one_half_stand_for_both():
    half = PointsProfile.through(np.array([0, 3e-3, 5e-3]), np.array([0, 1e-6, 8e-6]), LENGTH)
    both = PointsProfile.through(
        np.array([-5e-3, -3e-3, 0, 3e-3, 5e-3]), np.array([8e-6, 1e-6, 0, 1e-6, 8e-6]), LENGTH
    )
    x = np.linspace(-1, 1, 31) * LENGTH / 2
    assert half.drop(x, LENGTH) == approx(both.drop(x, LENGTH), rel=1e-12)
    assert half.drop(x, LENGTH) == approx(half.drop(-x, LENGTH), rel=1e-12)
    assert half.symmetric
    assert both.symmetric
    two = PointsProfile.through(np.array([-5e-3, 5e-3]), np.array([0, 8e-6]), LENGTH)
    assert two.drop(x, LENGTH) == approx(4e-6 * (1 + 2 * x / LENGTH), rel=1e-12, abs=1e-20)


@pytest.mark.parametrize(
    ("positions", "drops", "words"),
    [
        ([0, 3, 4], [0, 1, 2], "reach from 0 to 4 mm; they must reach from -5 mm, or from 0 mm"),
        ([-3, 5], [0, 1], "reach from -3"),
        ([-5, 1, 1, 5], [0, 1, 2, 3], "must grow"),
        ([-5, 0, 5], [0, 1], "3 positions and 2 drops"),
        ([-5, 0, 5], [3, 1, 2], "the least drop is 1 um; it must be 0"),
        ([-5, 0, 5], [0, float("nan"), 2], "must be finite"),
        ([0], [0], "at least 2"),
    ],
)
def test_points_that_are_no_profile_are_refused(positions, drops, words):
    with pytest.raises(ImpossiblePart, match=words):
        PointsProfile.through(np.array(positions) * 1e-3, np.array(drops) * 1e-6, LENGTH)


@pytest.mark.parametrize("name", ["amplitude", "end_drop", "crowned_share"])
def test_impossible_logarithmic_ends_are_refused(name):
    given = {"amplitude": 1e-6, "end_drop": 1e-5, "crowned_share": 0.5}
    with pytest.raises(ImpossiblePart, match=name):
        LogarithmicCrown(**{**given, name: 0.0})
    with pytest.raises(ImpossiblePart, match="at most 1"):
        LogarithmicCrown(**{**given, "crowned_share": 1.1})


CROWN, SLOW = (
    LogarithmicCrown(amplitude=2e-6, end_drop=9e-6, crowned_share=0.8),
    {"load": 5e3, "speed": 100.0},
)
TILTED = {"misalignment": 4e-4}


@pytest.mark.parametrize("tilt", [{}, TILTED], ids=["aligned", "tilted"])
def test_profile_of_the_rollers_may_stand_on_both_raceways_instead(tilt):
    rollers = paper_bearing(**SLOW, **tilt, profile=CROWN).solve()
    raceways = paper_bearing(**SLOW, **tilt, inner_profile=CROWN, outer_profile=CROWN).solve()
    assert raceways.slice_loads == approx(rollers.slice_loads, rel=1e-9, abs=1e-6)
    assert raceways.life == approx(rollers.life, rel=1e-9)


def test_profiles_of_roller_and_raceways_add_up():
    """Statically only the sum at both contacts counts, wherever it stands."""
    deeper = LogarithmicCrown(amplitude=4e-6, end_drop=18e-6, crowned_share=0.8)
    on_rollers = static_loads(paper_bearing(profile=CROWN).bearing, 5e3, moment=20.0)
    on_inner = static_loads(paper_bearing(inner_profile=deeper).bearing, 5e3, moment=20.0)
    assert on_inner.slice_loads == approx(on_rollers.slice_loads, rel=1e-9, abs=1e-6)
    straight = static_loads(paper_bearing().bearing, 5e3, moment=20.0)
    assert np.abs(on_inner.slice_loads - straight.slice_loads).max() > 0.05 * straight.slice_loads.max()


def test_bearings_with_different_profiles_are_solved_in_one_call():
    ends = np.array([0, 1.5e-3, 2.5e-3])
    profiles = [
        CROWN,
        LogarithmicCrown(amplitude=1e-6, end_drop=7e-6, crowned_share=1.0),
        Logarithmic(amplitude=1.75e-6),
        TangentCrowned(straight_length=3e-3, crown_radius=0.2),
        *(PointsProfile.through(ends, np.array([0, 1e-6, last]), 5e-3) for last in (5e-6, 9e-6)),
        PointsProfile.through(np.array([-2.5e-3, 0, 2.5e-3]), np.array([6e-6, 0, 2e-6]), 5e-3),
    ]
    bearings = [paper_bearing(**SLOW, profile=profile) for profile in profiles]
    bearings += [paper_bearing(**SLOW, profile=CROWN, inner_profile=profile) for profile in profiles]
    for bearing, state in zip(bearings, solve_many(bearings), strict=True):
        alone = bearing.solve()
        assert state.slice_loads == approx(alone.slice_loads, rel=1e-8, abs=1e-4)


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_profile_of_one_raceway_leaves_the_other_contact_straighter(race):
    state = paper_bearing(**SLOW, **{f"{race}_profile": CROWN}).solve()
    loads = state.slice_loads[:, np.argmax(state.loads[0])]
    uneven = np.ptp(loads, axis=1) / loads.mean(axis=1)
    profiled = ["inner", "outer"].index(race)
    assert uneven[profiled] > 0.1
    assert uneven[1 - profiled] < 1e-6
    still = static_loads(paper_bearing(**{f"{race}_profile": CROWN}, gravity=0.0).bearing, 5e3)
    assert state.loads[0].max() == approx(still.loads.max(), rel=0.03)


def test_raceways_that_lean_against_each_other_are_straight_ones_further_apart():
    """Rollers take the slope of both: what is left is a clearance, both halves alike."""
    lean, half = 2e-4, 2.5e-3
    ends = np.array([-half, half])
    rising, falling = (
        PointsProfile.through(ends, drops, 2 * half)
        for drops in (np.array([0, 2 * lean * half]), np.array([2 * lean * half, 0]))
    )
    leaning = paper_bearing(**SLOW, inner_profile=rising, outer_profile=falling, clearance=30e-6).solve()
    apart = paper_bearing(**SLOW, clearance=30e-6 + 4 * lean * half).solve()
    assert leaning.loads == approx(apart.loads, rel=1e-6, abs=1e-3)
    assert np.ptp(leaning.slice_loads[0, 0]) < 1e-6 * leaning.slice_loads.max()
    assert leaning.rollers.contact.force.shape[1] == 2  # with a tilt


def test_mirrored_profiles_carry_mirrored_loads():
    positions, drops = np.array([-2.5e-3, -1e-3, 1e-3, 2.5e-3]), np.array([4e-6, 0.0, 0.0, 1e-6])
    here, there = (
        paper_bearing(**SLOW, profile=PointsProfile.through(positions, some, 5e-3)).solve()
        for some in (drops, drops[::-1])
    )
    assert there.slice_loads == approx(here.slice_loads[..., ::-1], rel=1e-6, abs=1e-3)
    assert here.slice_loads[0, 0, -1] > 1.05 * here.slice_loads[0, 0, 0]
