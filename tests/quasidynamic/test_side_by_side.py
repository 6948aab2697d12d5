"""Bearings solved side by side are those of one solve after the other, whatever numbers they differ in."""

from dataclasses import fields, is_dataclass, replace
from functools import cache, partial
from typing import Any

import numpy as np
import pytest
from pytest import approx

from quasidynamic import (
    AdoreType,
    BairWiner,
    Crowned,
    Eyring,
    FourPointCurve,
    Logarithmic,
    LogarithmicCrown,
    PointsProfile,
    TangentCrowned,
    oil_at,
    solve_many,
)
from quasidynamic.columns import kind_and_numbers, taken, with_columns
from quasidynamic.contact.traction import ROLLING_LAWS, in_any_contact
from quasidynamic.contact.traction.adore import ADORE_OILS
from quasidynamic.contact.traction.asperity_friction import Carter, RoundedCoulomb
from quasidynamic.contact.traction.mixed import ZHOU_HOEPRICH, RoughContacts
from quasidynamic.parts.raceway_waves import RacewayWaves
from tests.bearings import RPM, paper_bearing
from tests.random_rollers import design, wide_design

INNER_LAND = {"guidance": "inner", "land_diameter": 65.4e-3, "land_flow": "vortices"}
DROP = Logarithmic(amplitude=2e-6)
CURVE = FourPointCurve.through(at_rest=0.01, peak=0.05, peak_slip=0.02, far=0.03)
ROUGH = RoughContacts(
    fluid=partial(Eyring, limiting_ratio=0.05, eyring_stress=6e6, film_heating=True),
    share=ZHOU_HOEPRICH,
    asperities=partial(in_any_contact, RoundedCoulomb(coefficient=0.1, sign_speed=1e-3)),
    inner_roughness=3e-7,
    outer_roughness=2e-7,
)
CREEPING = replace(ROUGH, asperities=partial(Carter, coefficient=0.1))
ADORE = partial(AdoreType, rheology=ADORE_OILS["MIL-L-23699"], limiting_ratio=0.07)
BEARINGS = {
    "aligned": {"profile": DROP, "load": 5e3},
    "odd slices, crowned": {"profile": Crowned(straight_length=3e-3, crown_radius=1.0), "slices": 7},
    "profiles of raceways": {
        "profile": LogarithmicCrown(amplitude=1e-6, end_drop=8e-6, crowned_share=0.7),
        "inner_profile": TangentCrowned(straight_length=2e-3, crown_radius=0.8),
        "outer_profile": PointsProfile.through(np.array([0, 1.5, 2.5]), np.array([0, 1e-6, 3e-6]), 5.0),
        "load": 5e3,
    },
    "free tilt": {"moment": 4.0, "profile": DROP},
    "misaligned": {"misalignment": 3e-4, "load_direction": 0.4, "contact_law": "iso16281"},
    "moment alone": {"load": 0.0, "moment": 4.0, "profile": DROP},
    "free cage": {"cage": {"free": True, "unbalance": 1e-5, **INNER_LAND}, "moment": 2.0},
    "fast and light": {"load": 30.0, "cage": INNER_LAND, "churning_gap": 1e-3},
    "waves": {
        "inner_waves": RacewayWaves(numbers=(2, 5), amplitudes=(3e-6, 1e-6), crests=(0.3, 0.1)),
        "outer_waves": RacewayWaves(numbers=(3,), amplitudes=(2e-6,), crests=(0.2,)),
        "clearance": 1e-5,
    },
    "unlike rollers": {"roller_deviations": tuple(1e-7 * (n % 7 - 3) for n in range(30)), "clearance": 1e-5},
    "slow": {"load": 30.0, "speed": 20 * RPM, "misalignment": 1e-4, "cage": {"guidance": "rollers"}},
    "starved": {"inlet_length": 0.5, "drag_coefficient": 1.1, "outer_speed": -2000 * RPM},
    "bair-winer": {"traction": partial(BairWiner, limiting_ratio=0.05, film_heating=True)},
    "adore": {"traction": ADORE, "rolling": ROLLING_LAWS["goksem-hargreaves"]},
    "four points": {"traction": partial(in_any_contact, CURVE), "rolling": ROLLING_LAWS["zhou-hoeprich"]},
    "rough": {"traction": ROUGH, "rolling": ROLLING_LAWS["dowson-higginson"], "load": 1e3},
    "rough and slow": {"traction": CREEPING, "load": 1e3, "speed": 20 * RPM},
}
FEW = ("aligned", "free tilt", "free cage", "rough")
STEP = 1e-4  # of a number that is zero


def places(part, name="bearing"):
    """Dotted names of the numbers of a part, in their order."""
    if isinstance(part, float | int) and not isinstance(part, bool):
        yield name
    if isinstance(part, partial):
        inside = {**dict(enumerate(part.args)), **part.keywords}
    elif isinstance(part, tuple):
        inside = {i: value for i, value in enumerate(part) if type(value) is not int}
    elif is_dataclass(part) and not isinstance(part, type):
        whole = {entry.name for entry in fields(part) if entry.type is int or not entry.compare}
        inside = {entry.name: getattr(part, entry.name) for entry in fields(part)}
        inside = {each: value for each, value in inside.items() if each not in whole}
    else:
        inside = {}
    for each, value in inside.items():
        yield from places(value, f"{name}.{each}")


def with_numbers(model, numbers):
    """The same bearing with other numbers, in the order of `places`."""
    both = with_columns(model, np.array([kind_and_numbers(model)[1], numbers]))
    return taken(both, np.array([1]))


@cache
def bearing(name):
    return paper_bearing(**BEARINGS[name])


@cache
def alone(name):
    return solve_many([bearing(name)])[0]


def same(state, single):
    """Loads to 1e-10 of the largest one, slips of cage and rollers to 1e-10, the ring to 1e-9 of its way."""
    assert state.status is single.status
    assert state.loads == approx(single.loads, rel=0, abs=1e-10 * single.loads.max())
    assert state.cage_slip == approx(single.cage_slip, rel=0, abs=1e-10)
    spin = single.balance.rolling_spin
    assert state.unknowns.spin_drift / spin == approx(single.unknowns.spin_drift / spin, rel=0, abs=1e-10)
    way = np.abs(single.ring_displacement).max()
    assert state.ring_displacement == approx(single.ring_displacement, rel=0, abs=1e-9 * way)


def differing(name, index, factor):
    """The bearing with one number multiplied, or off zero."""
    numbers = kind_and_numbers(bearing(name))[1]
    numbers[index] = numbers[index] * factor or (factor - 1.0) * STEP
    return with_numbers(bearing(name), numbers)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("name", FEW)
def test_bearings_may_differ_in_one_number_alone(name):
    """Some of all; that all may differ at once is asked below."""
    count = len(list(places(bearing(name))))
    for index in np.random.default_rng(3).choice(count, 5, replace=False):
        other = differing(name, index, 1.03)
        here, there = solve_many([bearing(name), other])
        same(here, alone(name))
        same(there, solve_many([other])[0])


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=pytest.mark.slow) if name.endswith("slow") else name for name in BEARINGS],
)
def test_bearings_may_differ_in_all_numbers(name):
    model, rng = bearing(name), np.random.default_rng(7)
    numbers = np.array(kind_and_numbers(model)[1])
    assert len(numbers) == len(list(places(model)))
    models = [with_numbers(model, numbers * rng.uniform(0.97, 1.03, len(numbers))) for _ in range(5)]
    many = solve_many(models)
    assert len(many.batches) == 1
    for model, state in zip(models, many, strict=True):
        same(state, solve_many([model])[0])


@pytest.mark.slow
def test_a_solve_does_not_depend_on_what_stands_beside_it():
    """Slow and fast, light and heavy, tilted by load or by moment alone: as many evaluations as alone."""
    points = ((3, 3e3), (7, 3e3), (450, 0.0), (450, 1.0), (450, 3e3), (1e3, 0.0), (13e3, 1.0), (3e4, 30.0))
    clearances = np.linspace(1e-5, 1e-4, len(points))
    models = [
        paper_bearing(speed=speed * RPM, load=load, moment=3.0, clearance=clearance)
        for (speed, load), clearance in zip(points, clearances, strict=True)
    ]
    many = solve_many(models)
    assert len(many.batches) == 1
    for model, state in zip(models, many, strict=True):
        single = solve_many([model])[0]
        assert state.number == single.number
        same(state, single)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(15))
def test_variants_of_random_designs(seed):
    """Also those that only the later ways solve, each for itself."""
    rng = np.random.default_rng([5, seed])
    model, _ = (wide_design if seed % 2 else design)(rng)
    numbers = np.array(kind_and_numbers(model)[1])
    models = [with_numbers(model, numbers * rng.uniform(0.9, 1.1, len(numbers))) for _ in range(4)]
    for model, state in zip(models, solve_many(models), strict=True):
        same(state, solve_many([model])[0])


def test_answers_come_in_the_order_of_the_bearings():
    """Those that are tilted, aligned, or have other numbers of rollers are not solved together."""
    models = [
        paper_bearing(load=load, rollers=rollers, misalignment=slope)
        for load, rollers, slope in ((1e3, 30, 0.0), (2e3, 28, 0.0), (3e3, 30, 1e-4), (4e3, 30, 0.0))
    ]
    many = solve_many(models)
    assert [len(batch) for batch in many.batches] == [2, 1, 1]
    assert [state.balance.points.load[0, 0] for state in many] == [1e3, 2e3, 3e3, 4e3]
    slips = many.in_order(lambda batch: batch.states.cage_slip)
    assert slips == approx([state.cage_slip for state in many], rel=1e-12)


def test_a_single_case_of_many_holds_numbers():
    """What is taken from a batch for one case is what the bearing alone would be."""
    numbers = np.array(kind_and_numbers(bearing("rough"))[1])
    other = with_numbers(bearing("rough"), 1.01 * numbers)
    roller = solve_many([bearing("rough"), other])[1].balance.roller
    assert kind_and_numbers(roller.bearing) == kind_and_numbers(other.bearing)
    assert kind_and_numbers(roller.lubrication) == kind_and_numbers(other.lubrication)


def test_what_is_the_same_in_all_cases_stays_a_number():
    many = solve_many([paper_bearing(load=load, clearance=c) for load, c in ((1e3, 5e-5), (2e3, 6e-5))])
    roller: Any = many.batches[0].states.balance.roller
    assert roller.bearing.clearance.shape == (2, 1)
    assert isinstance(roller.bearing.roller.diameter, float)
    assert roller.levers.ndim == 2


def test_whole_numbers_and_notes_do_not_separate_bearings():
    first = paper_bearing(load=1000, oil=oil_at("MIL-PRF-23699", 350.0))
    second = paper_bearing(load=2500.5, oil=oil_at("MIL-PRF-23699", 500.0))  # noted as extrapolated
    assert first.lubrication.oil.notes != second.lubrication.oil.notes
    assert len(solve_many([first, second]).batches) == 1


def test_other_functions_separate_bearings():
    """Curves made by two functions may be anything; the same function is one law."""
    one, other = (paper_bearing(traction=lambda **_: CURVE) for _ in range(2))
    heavier = replace(one, operation=replace(one.operation, radial_load=2e4))
    assert [len(batch) for batch in solve_many([one, other, heavier]).batches] == [2, 1]
