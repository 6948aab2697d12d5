"""Raceways with a form error."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from pytest import approx

from quasidynamic import ImpossiblePart, solve_many, static_loads
from quasidynamic.parts.raceway_waves import RacewayWaves
from quasidynamic.several.passage import after_passing_pitches
from quasidynamic.trace import trace
from tests.bearings import paper_bearing

OVAL = RacewayWaves(numbers=(2,), amplitudes=(10e-6,), crests=(0.3,))
ROUND_LOADS = paper_bearing().solve().loads


def waves(number, amplitude, crest=0.0):
    return RacewayWaves(numbers=(number,), amplitudes=(amplitude,), crests=(crest,))


@pytest.mark.parametrize("turn", [0.0, 0.05, 1.0])
@pytest.mark.parametrize("race", ["inner_waves", "outer_waves"])
def test_crests_at_all_rollers_close_the_clearance_by_twice_their_height(race, turn):
    """Wherever rollers stand, with as many waves as rollers: a closed form, equal to the last digits."""
    with_waves = paper_bearing(azimuth=turn, **{race: waves(30, 6e-6, turn)}).solve()
    closer = paper_bearing(azimuth=turn, clearance=75.5e-6 - 2 * 6e-6).solve()
    assert with_waves.loads == approx(closer.loads, rel=1e-9, abs=1e-6)
    assert with_waves.cage_slip == approx(closer.cage_slip, rel=1e-8)
    assert closer.loads[0].max() < 0.98 * ROUND_LOADS[0].max()


def test_valleys_at_all_rollers_open_the_clearance():
    opened = paper_bearing(clearance=75.5e-6 + 2 * 6e-6).solve().loads
    assert paper_bearing(outer_waves=waves(30, 6e-6, pi / 30)).solve().loads == approx(opened, abs=1e-6)


@pytest.mark.parametrize("race", [0, 1], ids=["inner", "outer"])
def test_waves_are_a_given_deviation_of_the_raceway(race):
    """Outward is towards the rollers inside and away from them outside."""
    name, outward = (("inner_waves", 1), ("outer_waves", -1))[race]
    bearing, plain = paper_bearing(free_tilt=True, **{name: OVAL}), paper_bearing(free_tilt=True)
    deviation = np.zeros((2, 30, plain.axial_modes))
    deviation[race, :, 0] = outward * OVAL.height(plain.bearing.azimuths)
    given = plain.solve(deviation=deviation)
    assert bearing.solve().loads == approx(given.loads, rel=1e-8, abs=1e-5)
    assert np.abs(given.loads - ROUND_LOADS).max() > 50


def test_waves_stay_between_elastic_raceways():
    """On a raceway with springs under every roller, as a deviation that is there without load."""
    bearing, plain = paper_bearing(outer_waves=OVAL), paper_bearing()
    size = 30 * plain.axial_modes
    springs = (1e-9 * np.eye(size)).reshape(30, plain.axial_modes, 30, plain.axial_modes)
    deviation = np.zeros((2, 30, plain.axial_modes))
    deviation[1, :, 0] = -OVAL.height(plain.bearing.azimuths)
    *_, of_bearing = bearing.iterate((None, springs), bearing.solve())
    *_, given = plain.iterate((None, springs), plain.solve(), deviation)
    assert of_bearing.loads == approx(given.loads, rel=1e-8, abs=1e-5)
    assert np.abs(of_bearing.loads - bearing.solve().loads).max() > 50


def test_a_bearing_turned_as_a_whole_carries_the_same_loads():
    straight = paper_bearing(outer_waves=waves(2, 10e-6), gravity=0.0).solve()
    turned = paper_bearing(
        outer_waves=waves(2, 10e-6, 0.4), azimuth=0.4, load_direction=0.4, gravity=0.0
    ).solve()
    assert turned.loads == approx(straight.loads, rel=1e-9, abs=1e-6)


def test_a_crest_in_the_load_zone_concentrates_the_load_a_valley_spreads_it():
    crest, valley = (
        paper_bearing(outer_waves=waves(2, height)).solve().loads[0].max() for height in (10e-6, -10e-6)
    )
    assert valley < ROUND_LOADS[0].max() < crest


def test_several_waves_add_up():
    both = RacewayWaves(numbers=(2, 5), amplitudes=(10e-6, -3e-6), crests=(0.3, 0.1))
    phi = np.linspace(0, 6, 50)
    assert both.height(phi) == approx(OVAL.height(phi) + waves(5, -3e-6, 0.1).height(phi), abs=1e-20)
    assert both.height(phi) == approx([
        10e-6 * np.cos(2 * (x - 0.3)) - 3e-6 * np.cos(5 * (x - 0.1)) for x in phi
    ], abs=1e-18)  # fmt: skip


def test_static_loads_feel_the_waves_and_balance():
    """Between wavy raceways nothing but the clearance at each roller changes."""
    model = paper_bearing(outer_waves=OVAL).bearing
    loads = static_loads(model, 19621.1)
    azimuth, (y, z) = model.azimuths, loads.ring_displacement
    approach = y * np.sin(azimuth) + z * np.cos(azimuth) - 75.5e-6 / 2 + 10e-6 * np.cos(2 * (azimuth - 0.3))
    assert loads.approach == approx(approach, rel=1e-12)
    assert loads.loads @ np.cos(azimuth) == approx(19621.1, rel=1e-9)
    assert (loads.loads > 1).tolist() == (approach > 0).tolist()


def test_wavy_bearings_side_by_side_are_those_alone():
    bearings = [paper_bearing(load=load, outer_waves=w) for load in (5e3, 2e4) for w in (None, OVAL)]
    bearings += [replace(bearings[1], bearing=replace(bearings[1].bearing, clearance=50e-6))]
    for state, bearing in zip(solve_many(bearings), bearings, strict=True):
        assert state.loads == approx(bearing.solve().loads, rel=1e-9, abs=1e-6)


def test_rollers_that_pass_pitches_pass_the_waves():
    """In the end they stand where they stood: loads of a motion differ little from the equilibrium's."""
    state = paper_bearing(outer_waves=OVAL).solve()
    passed = after_passing_pitches(state)
    assert passed is not None
    assert passed.settled
    assert passed.state.loads == approx(state.loads, abs=0.03 * state.loads.max())
    assert np.abs(passed.state.loads - ROUND_LOADS).max() > 0.05 * state.loads.max()


def test_branch_over_the_load_keeps_the_waves():
    bearing = paper_bearing(outer_waves=OVAL)
    branch = trace(bearing, over="radial_load", span=(15e3, 19621.1))
    assert branch.points[-1].equilibrium.loads == approx(bearing.solve().loads, rel=1e-6, abs=1e-2)


def test_unloaded_ring_that_waves_clamp_has_a_place():
    """Crests reach further than the clearance: without load rollers touch, two by two."""
    state = paper_bearing(load=0.0, clearance=10e-6, outer_waves=waves(2, 20e-6)).solve()
    assert (state.loads[0] > 10).sum() >= 4
    assert not state.balance.undetermined.any()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"numbers": (1,)}, "2 or more"),
        ({"numbers": (2, 3)}, "one of each"),
        ({"amplitudes": (float("nan"),)}, "finite"),
    ],
    ids=str,
)
def test_impossible_waves_are_named(change, message):
    with pytest.raises(ImpossiblePart, match=message):
        replace(OVAL, **change)


@pytest.mark.parametrize(("number", "amplitude"), [(2, 190e-6), (300, 0.65e-6)], ids=["steep", "curved"])
def test_waves_that_a_roller_cannot_follow_are_refused(number, amplitude):
    with pytest.raises(ImpossiblePart, match=r"bearing.form_error.outer: .* at most"):
        paper_bearing(outer_waves=waves(number, amplitude))
    paper_bearing(outer_waves=waves(number, 0.9 * amplitude))


def test_larger_rollers_close_the_clearance_by_twice_their_deviation():
    """All alike: a closed form, equal to the last digits."""
    larger = paper_bearing(roller_deviations=(1e-6,) * 30).solve()
    closer = paper_bearing(clearance=75.5e-6 - 2e-6).solve()
    assert larger.loads == approx(closer.loads, rel=1e-9, abs=1e-6)


def test_one_larger_roller_takes_load_from_its_neighbours():
    deviations = (2e-6, *(0.0,) * 29)  # the first one stands under the load
    loads = paper_bearing(roller_deviations=deviations).solve().loads[1]
    assert loads[0] > ROUND_LOADS[1][0] + 50
    assert (loads[[1, 2, 28, 29]] < ROUND_LOADS[1][[1, 2, 28, 29]] - 5).all()


@pytest.mark.parametrize("deviations", [(1e-6,) * 29, (1e-5, *(0.0,) * 29)], ids=["too few", "too large"])
def test_impossible_rollers_are_refused(deviations):
    with pytest.raises(ImpossiblePart, match=r"bearing\.form_error\.roller_diameters"):
        paper_bearing(roller_deviations=deviations)
