"""Ratings and lives of the paper's bearing, re-solved independently, and printed tables of the standards."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx
from scipy.optimize import brentq

from quasidynamic import Logarithmic, OutOfRange
from quasidynamic.contact.line import peak_pressure
from quasidynamic.outcome.capacity import (
    dynamic_rating,
    fatigue_load_limit,
    geometry_factor,
    raceway_capacity,
    reference_raceway_capacity,
    roller_capacity,
    static_rating,
)
from quasidynamic.outcome.life import (
    RollerBody,
    basic_life,
    edge_stress_factor,
    reference_life,
    reference_load,
    slice_life,
)
from quasidynamic.outcome.life_factors import CLEANLINESS, contamination_factor
from tests.bearings import paper_bearing
from tests.literature.worked_example import WorkedExample

BEARING = paper_bearing().bearing
TURNING = (True, False)
ROLLERS = RollerBody(capacity=roller_capacity(BEARING), speed_ratio=6.96)
RNG = np.random.default_rng(4)
LOADS = RNG.uniform(100, 3000, (2, 30, 1))  # [N]


def rigid_loads(clearance, load=19621.1, stiffness=158.5e3, centrifugal=92.2):
    """Static loads between rigid rings (mm, N); the outer raceway carries the centrifugal force too."""
    azimuth = 2 * np.pi * np.arange(30) / 30

    def inner(shift):
        return stiffness * np.maximum(shift * np.cos(azimuth) - clearance / 2, 0) ** (10 / 9)

    loads = inner(brentq(lambda shift: inner(shift) @ np.cos(azimuth) - load, 0, 1))
    return loads[:, None], loads[:, None] + centrifugal


# An independent ISO 281 and ISO/TS 16281 programme; gamma 0.07145 there, 0.07143 here.
RATINGS = (
    WorkedExample("f_c at γ 0.07145", 79.48, lambda: geometry_factor(0.07145), 1e-4),
    WorkedExample("C_r without b_m", 20068, lambda: dynamic_rating(BEARING, material_factor=1.0), 2e-4, "N"),
    WorkedExample("C_r", 22075, lambda: dynamic_rating(BEARING), 2e-4, "N"),
    WorkedExample("Q_ci", 2568.0, lambda: reference_raceway_capacity(BEARING)[0], 2e-4, "N"),
    WorkedExample("Q_ce", 3105.3, lambda: reference_raceway_capacity(BEARING)[1], 2e-4, "N"),
    WorkedExample("Q_c of a roller, inner", 8285, lambda: roller_capacity(BEARING)[0], 2e-4, "N"),
    WorkedExample("Q_c of a roller, outer", 10014, lambda: roller_capacity(BEARING)[1], 2e-4, "N"),
    WorkedExample("Q_ci, 552-form", 2580.5, lambda: raceway_capacity(BEARING)[0], 2e-4, "N"),
    WorkedExample("Q_ce, 552-form", 3119.1, lambda: raceway_capacity(BEARING)[1], 2e-4, "N"),
)


@pytest.mark.parametrize("example", RATINGS, ids=lambda example: example.name)
def test_ratings_of_the_paper_bearing(example):
    example.check()


def test_rating_outside_the_table_is_refused():
    for ratio in (0.009, 0.31, float("nan")):
        with pytest.raises(OutOfRange, match="table 7"):
            geometry_factor(ratio)


def test_static_rating_is_4000_megapascal_under_the_most_loaded_roller():
    """Hertz on a roller that carries 5/Z of the load; E = 206 GPa, nu = 0.3."""
    radius = 2.5e-3 * (1 - BEARING.diameter_ratio)
    line_load = 5 / 30 * static_rating(BEARING) / 5e-3
    assert peak_pressure(line_load, radius, 206e9 / (1 - 0.3**2)) == approx(4e9, rel=0.01)


def test_fatigue_limit_is_an_eighth_of_the_static_rating_and_less_of_a_large_bearing():
    assert static_rating(BEARING) / fatigue_load_limit(BEARING) == approx(8.2, rel=1e-12)
    large = replace(BEARING, outer_raceway_diameter=205e-3)
    assert static_rating(large) / fatigue_load_limit(large) == approx(8.2 * 2**0.3, rel=1e-12)


@pytest.mark.parametrize(
    ("clearance", "life"), [(50e-6, 1.831), (75e-6, 1.517)], ids=["11 loaded", "9 loaded"]
)
def test_life_of_the_rigid_bearing(clearance, life):
    """Static loads, ISO capacities: 1.831 and 1.517 10^6 revolutions; the 552-form is 0.5 % stronger."""
    assert paper_bearing(clearance=clearance).solve().life == approx(life, rel=0.04)


REFERENCE_LIVES = {  # clearance [mm]: loaded rollers, largest load [N], life, life with edge stress [10^6]
    0.050: (11, 3305, 1.831, 0.528),
    0.070: (9, None, 1.5624, None),
    0.075: (9, 3538, 1.517, 0.438),
}
PROFILED = paper_bearing(profile=Logarithmic(amplitude=0.00035 * 5e-3)).bearing


def life_of_sliced(clearance, edge_stress=False):
    """Loads spread evenly over 30 slices."""
    sliced = [np.repeat(side / 30, 30, axis=1) for side in rigid_loads(clearance)]
    return reference_life(*sliced, PROFILED, TURNING, edge_stress=edge_stress)


@pytest.mark.parametrize(("clearance", "printed"), REFERENCE_LIVES.items())
def test_reference_life_of_rigid_rings(clearance, printed):
    """Loads from a model of three lines; its stiffness meets both printed loads within 0.2 %."""
    loaded, largest, life, at_edges = printed
    inner, outer = rigid_loads(clearance)
    assert np.count_nonzero(inner) == loaded
    assert largest is None or inner.max() == approx(largest, rel=2e-3)
    whole = reference_life(inner, outer, BEARING, TURNING)
    assert whole == approx(life, rel=5e-3)
    assert life_of_sliced(clearance) == approx(whole, rel=1e-12)
    assert at_edges is None or life_of_sliced(clearance, edge_stress=True) == approx(at_edges, rel=5e-3)


EDGE_FACTORS = {0: 2.328, 1: 1.127, 14: 1.003}  # of 30 slices: at the end, beside it, in the middle


def test_edge_stress_factors():
    factor = edge_stress_factor(30)
    assert factor[list(EDGE_FACTORS)] == approx(list(EDGE_FACTORS.values()), abs=5e-4)
    assert factor == approx(factor[::-1], rel=1e-12)
    assert edge_stress_factor(31)[15] == 1.0


def test_edge_stress_is_refused_where_it_does_not_hold():
    profiled = paper_bearing(profile=Logarithmic(amplitude=1.75e-6)).bearing
    few, enough = np.ones((30, 29)), np.ones((30, 30))
    with pytest.raises(OutOfRange, match="straight"):
        reference_life(enough, enough, BEARING, TURNING, edge_stress=True)
    with pytest.raises(OutOfRange, match="29 slices"):
        reference_life(few, few, profiled, TURNING, edge_stress=True)


def test_uniform_slices_give_the_life_of_the_whole_roller():
    for count in (1, 20, 60):
        sliced = np.repeat(LOADS / count, count, axis=2)
        assert basic_life(*sliced, BEARING, TURNING) == approx(
            basic_life(*LOADS, BEARING, TURNING), rel=1e-12
        )
        assert slice_life(*sliced, (2e3, 3e3), TURNING, rollers=ROLLERS) == approx(
            slice_life(*LOADS, (2e3, 3e3), TURNING, rollers=ROLLERS), rel=1e-12
        )


@given(st.floats(0.01, 100.0), st.booleans(), st.booleans(), st.sampled_from([None, ROLLERS]))
def test_life_falls_with_the_fourth_power_of_all_loads(factor, inner, outer, rollers):
    """Slices to the 4.5, Weibull 9/8: x times all loads costs x^4, whichever ring turns."""
    one, other = (slice_life(*(x * LOADS), (2e3, 3e3), (inner, outer), rollers=rollers) for x in (1, factor))
    assert one / other == approx(factor**4, rel=1e-9)


def test_standing_ring_suffers_more_from_the_same_unequal_loads():
    """A point of it always meets the largest load: the mean of power 4.5 instead of 4."""
    turns, stands = (slice_life(*LOADS, (2e3, 2e3), (turn, turn)) for turn in (True, False))
    equal = np.full((2, 30, 1), 1e3)
    assert stands < turns
    assert slice_life(*equal, (2e3, 2e3), (True, True)) == approx(2.0**4 * 2 ** (-8 / 9), rel=1e-12)
    assert slice_life(*equal, (2e3, 2e3), (False, False)) == approx(2.0**4 * 2 ** (-8 / 9), rel=1e-12)


def test_rollers_fail_in_the_same_weibull_sum():
    """Every one of Z rollers lives (Q_c/Q)^4 of its own turns, six of them per turn of the ring."""
    loads = np.full((2, 30, 1), 1e3)
    body = RollerBody(capacity=(8e3, 10e3), speed_ratio=6.0)
    weakest = np.array([2e3, 3e3, *30 * [8e3], *30 * [10e3]])
    lives = (weakest / 1e3) ** 4 / np.array([1, 1, *60 * [6.0]])
    assert slice_life(*loads, (2e3, 3e3), TURNING, rollers=body) == approx(
        np.sum(lives ** (-9 / 8)) ** (-8 / 9), rel=1e-12
    )


def test_stacked_load_cases_are_the_single_ones():
    cases = RNG.uniform(0, 500, (2, 3, 4, 30, 8))
    cases[:, 1, 2] = 0.0
    profiled = paper_bearing(profile=Logarithmic(amplitude=1.75e-6)).bearing
    many = np.repeat(cases, 5, axis=-1)
    for life, loads in (
        (lambda i, o: basic_life(i, o, BEARING, TURNING), cases),
        (lambda i, o: reference_life(i, o, profiled, TURNING, edge_stress=True), many),
        (lambda i, o: slice_life(i, o, (2e3, 3e3), TURNING, rollers=ROLLERS), cases),
    ):
        stacked = life(*loads)
        assert stacked.shape == (3, 4)
        assert stacked[2, 1] == approx(life(*loads[:, 2, 1]), rel=1e-12)
        assert stacked[1, 2] == float("inf")


def test_reference_load_gives_the_life_back():
    """L = (C_r/P)^(10/3)."""
    life = reference_life(*LOADS, BEARING, TURNING)
    load = reference_load(life, dynamic_rating(BEARING))
    assert (dynamic_rating(BEARING) / load) ** (10 / 3) == approx(life, rel=1e-12)
    assert reference_load(float("inf"), 2e4) == 0.0


def test_unloaded_bearing_lives_for_ever():
    none = np.zeros((30, 20))
    assert basic_life(none, none, BEARING, TURNING) == float("inf")


# ISO 281 (2007), annex A.4 to A.6: c1 and c2 of e_C, entered a second time.
CONTAMINATION = {
    "oil, in-line filter, -/13/10": (0.0864, 0.5663),
    "oil, in-line filter, -/15/12": (0.0432, 0.9987),
    "oil, in-line filter, -/17/14": (0.0288, 1.6329),
    "oil, in-line filter, -/19/16": (0.0216, 2.3362),
    "oil, no or off-line filter, -/13/10": (0.0864, 0.6796),
    "oil, no or off-line filter, -/15/12": (0.0288, 1.141),
    "oil, no or off-line filter, -/17/14": (0.0133, 1.67),
    "oil, no or off-line filter, -/19/16": (0.00864, 2.5164),
    "oil, no or off-line filter, -/21/18": (0.00411, 3.8974),
    "grease, high cleanliness": (0.0864, 0.6796),
    "grease, normal cleanliness": (0.0432, 1.141),
    "grease, slight to typical contamination": (0.0177, 1.887),
    "grease, severe contamination": (0.0115, 2.662),
    "grease, very severe contamination": (0.00617, 4.06),
}


def test_every_degree_of_cleanliness_is_checked():
    assert set(CLEANLINESS) == set(CONTAMINATION)


@pytest.mark.parametrize("name", CONTAMINATION)
def test_contamination_factor_has_the_constants_of_iso281(name):
    """At kappa 1 and 100 mm the first factor is below one, at kappa 4 and 1 m above it for clean oil."""
    rise, loss = CONTAMINATION[name]
    for kappa, pitch in ((1.0, 100.0), (4.0, 1000.0)):  # [-], [mm]
        loss = 1.677 if (name, pitch) == ("grease, slight to typical contamination", 1000.0) else loss
        expected = min(rise * kappa**0.68 * pitch**0.55, 1.0) * (1 - loss / pitch ** (1 / 3))
        assert contamination_factor(kappa, pitch * 1e-3, CLEANLINESS[name]) == approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("place", "logarithm"), [(0.0, 0.0), (0.25, 0.2876820724517809), (0.45, 1.6607312068216509)]
)
def test_logarithmic_profile_of_iso16281(place, logarithm):
    """P(x) = 0.00035 D ln 1/(1 - (2x/l)^2), on either side of mid-roller."""
    diameter, length = 10e-3, 12e-3
    profile = Logarithmic(amplitude=0.00035 * diameter)
    drop = profile.drop(np.array([-place, place]) * length, length)
    assert drop == approx(0.00035 * diameter * logarithm, rel=1e-12, abs=1e-20)
