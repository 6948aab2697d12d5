"""The static load distribution: what must hold whatever the numbers are."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Crowned, ImpossiblePart, Logarithmic, Material, NotSolved
from quasidynamic.static import static_loads
from tests.bearings import paper_bearing

LOGARITHMIC = Logarithmic(amplitude=1.75e-6)
CASES = {
    "straight": ({}, {}),
    "profiled": ({"profile": LOGARITHMIC}, {}),
    "crowned, odd slices": (
        {"profile": Crowned(straight_length=3e-3, crown_radius=0.5)},
        {"slices": 21, "direction": 0.3},
    ),
    "tilted": ({"profile": LOGARITHMIC}, {"moment": 20.0, "direction": 1.0}),
    "moment alone": ({}, {"load": 0.0, "moment": 5.0}),
    "preload alone": ({"clearance": -40e-6}, {"load": 0.0}),
    "light, off the line": ({}, {"load": 1.0, "direction": 0.01}),
    "heavy": ({"contact_law": "iso16281"}, {"load": 2e5, "direction": np.pi / 30}),
}


@pytest.fixture(params=CASES.values(), ids=CASES.keys())
def case(request):
    changes, asked = request.param
    bearing, asked = paper_bearing(**changes).bearing, {"load": 19621.1, **asked}
    return bearing, asked, static_loads(bearing, **asked)


def test_rollers_hold_load_and_moment(case):
    bearing, asked, found = case
    direction, half = asked.get("direction", 0.0), bearing.roller.length / 2
    normal = np.array([np.sin(bearing.azimuths), np.cos(bearing.azimuths)])
    along = np.array([np.sin(direction), np.cos(direction)])
    width = bearing.roller.length / found.slice_loads.shape[1]
    places = (np.arange(found.slice_loads.shape[1]) + 0.5) * width - half
    size = 1e-10 * max(asked["load"], abs(asked.get("moment", 0.0)) / half, found.loads.max())
    assert normal @ found.loads == approx(asked["load"] * along, rel=0, abs=size)
    moments = normal @ (found.slice_loads @ places * width)
    assert moments == approx(asked.get("moment", 0.0) * along, rel=0, abs=size * half)
    assert found.slice_loads.sum(axis=1) * width == approx(found.loads, rel=1e-12)


def test_approach_is_that_of_rigid_rings(case):
    bearing, asked, found = case
    y, z = found.ring_displacement
    gap = bearing.clearance / 2
    expected = y * np.sin(bearing.azimuths) + z * np.cos(bearing.azimuths) - gap
    assert found.approach == approx(expected, rel=1e-12, abs=1e-18)
    if not asked.get("moment"):
        assert (found.loads[found.approach < -1e-7] < 1e-5).all()  # gaps are rounded


def test_turning_load_and_rollers_together_turns_everything():
    turn = 0.7
    here = static_loads(paper_bearing(profile=LOGARITHMIC).bearing, 5e3, 0.2, 3.0)
    there = static_loads(paper_bearing(profile=LOGARITHMIC, azimuth=turn).bearing, 5e3, 0.2 + turn, 3.0)
    rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    assert there.loads == approx(here.loads, rel=0, abs=1e-9 * here.loads.max())
    assert there.ring_displacement == approx(rotation @ here.ring_displacement, rel=1e-9)
    assert there.ring_tilt[::-1] == approx(rotation @ here.ring_tilt[::-1], rel=1e-9)


def test_stiffness_is_the_slope_of_load_over_displacement():
    bearing, step = paper_bearing(profile=LOGARITHMIC, clearance=10e-6).bearing, 1.0
    here = static_loads(bearing, 8e3, 0.4)
    load = 8e3 * np.array([np.sin(0.4), np.cos(0.4)])
    for axis in np.eye(2):
        moved = []
        for y, z in (load + step * axis, load - step * axis):
            moved.append(static_loads(bearing, float(np.hypot(y, z)), np.arctan2(y, z)).ring_displacement)
        slope = (moved[0] - moved[1]) / (2 * step)
        assert here.stiffness @ slope == approx(axis, rel=1e-6, abs=1e-6)


@pytest.mark.parametrize("moment", [0.0, 20.0], ids=["aligned", "tilted"])
def test_slow_bearing_carries_the_same(moment):
    """Both raceways solved roller by roller, at one turn in a day: hardly any film, no weight."""
    model = paper_bearing(profile=LOGARITHMIC, speed=2 * np.pi / 86400, moment=moment, gravity=0.0)
    found = static_loads(model.bearing, 19621.1, moment=moment, slices=model.slices)
    slow = model.solve()
    assert slow.loads[0] == approx(found.loads, rel=0, abs=1e-5 * found.loads.max())
    assert slow.slice_loads[0] == approx(found.slice_loads, rel=0, abs=1e-5 * found.slice_loads.max())
    assert slow.ring_displacement == approx(found.ring_displacement, rel=1e-5, abs=1e-9)
    assert slow.ring_tilt == approx(found.ring_tilt, rel=1e-5, abs=1e-8)


def test_rings_of_two_materials_share_the_approach_almost_exactly():
    """A profiled roller would have to bend to give every slice its share; outer ring of half the modulus."""
    model = paper_bearing(profile=LOGARITHMIC, speed=2 * np.pi / 86400)
    soft = Material(youngs_modulus=100e9, poisson_ratio=0.3, density=7850)
    model = replace(model, bearing=replace(model.bearing, outer_ring=soft))
    found, slow = static_loads(model.bearing, 19621.1, slices=model.slices), model.solve()
    assert slow.loads[0] == approx(found.loads, rel=0, abs=2e-4 * found.loads.max())
    assert slow.slice_loads[0] == approx(found.slice_loads, rel=0, abs=4e-2 * found.slice_loads.max())


def test_nothing_holds_a_ring_without_load():
    with pytest.raises(NotSolved, match=r"clearance of 75\.5 um: nothing holds the ring"):
        static_loads(paper_bearing().bearing, 0.0)


@pytest.mark.parametrize("load", [-1.0, float("nan"), float("inf")], ids=str)
def test_impossible_loads_are_refused(load):
    with pytest.raises(ImpossiblePart, match="load"):
        static_loads(paper_bearing().bearing, load)
    with pytest.raises(ImpossiblePart, match="moment"):
        static_loads(paper_bearing().bearing, 1.0, moment=float("nan"))
