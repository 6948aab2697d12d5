"""Rollers that thrust presses on ribs of both rings."""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import ImpossiblePart, solve_many
from quasidynamic.contact.rib import in_series, rib_pressure, rib_stiffness
from quasidynamic.outcome.axial_capacity import rib_strength, rib_strength_of_series_2, warm_rib_load
from quasidynamic.solve.start.frictionless import static_unknowns
from quasidynamic.solve.start.on_ribs import frictionless, pressed_on_ribs
from tests.bearings import RIBS, paper_bearing

USUAL = {"speed": 1000.0, "load": 3000.0, "clearance": 20e-6}


def on_ribs(thrust, **changes):
    return paper_bearing(axial_load=thrust, ribs=RIBS, **USUAL | changes)


@pytest.fixture(scope="module", params=[False, True], ids=["held", "free to tilt"])
def pressed(request):
    return on_ribs(600.0, free_tilt=request.param).solve()


def test_ribs_carry_the_thrust(pressed):
    assert pressed.rib_thrust.sum() == approx(600.0, rel=1e-12)
    assert pressed.rib_thrust.min() > 0


def test_couple_of_the_ribs_tilts_the_loads_of_each_roller(pressed):
    """Summed up from slices alone."""
    places, distance = pressed.slice_positions, pressed.balance.roller.bearing.rib_distance
    width = places[1] - places[0]
    inner, outer = pressed.slice_loads @ places * width
    assert outer - inner == approx(distance * pressed.rib_thrust, rel=1e-8, abs=1e-9)


def test_power_of_the_rings_is_the_heat_also_of_the_ribs(pressed):
    assert pressed.driving_power == approx(pressed.losses.total, rel=1e-10)
    assert pressed.losses.ribs == approx((pressed.rib_friction * pressed.rib_sliding).sum(), rel=1e-12)
    assert pressed.losses.ribs > 0.1 * pressed.losses.total


def test_reversed_thrust_is_seen_from_the_other_side(pressed):
    free = bool(pressed.balance.points.free_tilt[0, 0])
    mirrored = on_ribs(-600.0, free_tilt=free).solve()
    assert mirrored.rib_thrust == approx(-pressed.rib_thrust, rel=1e-9)
    assert mirrored.slice_loads[..., ::-1] == approx(pressed.slice_loads, rel=1e-8, abs=1e-3)
    assert mirrored.ring_shift == approx(-pressed.ring_shift, rel=1e-9)
    assert mirrored.ring_tilt == approx(-pressed.ring_tilt, rel=1e-6, abs=1e-12)
    assert mirrored.life == approx(pressed.life, rel=1e-9)


def test_little_thrust_changes_nothing_and_much_of_it_shortens_the_life(pressed):
    free = bool(pressed.balance.points.free_tilt[0, 0])
    without, little = paper_bearing(**USUAL, free_tilt=free).solve(), on_ribs(1e-6, free_tilt=free).solve()
    assert little.loads == approx(without.loads, rel=1e-8, abs=1e-6)
    assert little.cage_slip == approx(without.cage_slip, rel=1e-6)
    assert pressed.life < 0.95 * little.life
    assert little.life == approx(without.life, rel=1e-8)


def test_ribs_without_thrust_are_not_there():
    states = [paper_bearing(**USUAL, ribs=ribs, misalignment=1e-4).solve() for ribs in (None, RIBS)]
    assert np.array_equal(states[0].scaled, states[1].scaled)
    assert states[1].rib_thrust is None


def test_thrusts_and_no_thrust_are_solved_side_by_side():
    models = [on_ribs(thrust) for thrust in (0.0, 300.0, -600.0)]
    alone = [model.solve() for model in models]
    together = solve_many(models)
    assert [len(batch) for batch in together.batches] in ([1, 2], [2, 1])
    for one, other in zip(together, alone, strict=True):
        assert one.slice_loads == approx(other.slice_loads, rel=1e-8, abs=1e-3)


@pytest.mark.parametrize("free", [False, True])
@pytest.mark.parametrize("thrust", [900.0, -900.0])
def test_frictionless_rollers_are_tapered_ones_without_taper(thrust, free):
    """Written apart: balances that hold no friction vanish where those rollers are in balance."""
    balance = on_ribs(thrust, free_tilt=free, misalignment=0.0 if free else 2e-4).balance()
    begin = static_unknowns(balance, np.zeros_like(balance.rolling_cage))
    placed, state = pressed_on_ribs(balance, begin), frictionless(balance, begin).state
    unknowns = balance.pack(placed._replace(film=begin.film))  # films as they were there
    at, layout = balance.evaluate(unknowns), balance.layout
    contact = at.response.state.contact
    assert contact.force[:, 0, 0] == approx(state.slice_load.sum(-1) * 5e-3 / 20, rel=1e-9, abs=1e-9)
    assert np.abs(at.response.state.ribs.thrust[0]) == approx(state.rib_load, rel=1e-6, abs=1e-6)
    assert at.residual[0, layout.field(1)] == approx(np.zeros(layout.rollers), abs=1e-6)
    assert at.residual[0, [2, 3, 5]] == approx(np.zeros(3), abs=1e-6)


@pytest.mark.parametrize("share", [0.02, 0.3, 0.5])
@pytest.mark.parametrize("speed", [100.0, 4000.0])
def test_thrust_up_to_half_of_the_load_is_solved(share, speed):
    load = 19621.0
    state = on_ribs(share * load, load=load, speed=speed).solve()
    assert state.residual < 1e-9
    assert state.rib_thrust.sum() == approx(share * load)


def test_axial_stiffness_is_that_of_differences():
    low, high = (on_ribs(thrust, free_tilt=True).solve() for thrust in (599.0, 601.0))
    found = on_ribs(600.0, free_tilt=True).solve().axial_stiffness
    assert found == approx(2.0 / (high.ring_shift - low.ring_shift), rel=1e-3)


def test_elastic_raceways_under_thrust():
    model = on_ribs(600.0, free_tilt=True, axial_modes=3)
    azimuths, size = model.bearing.azimuths, model.bearing.all_rollers
    waves = sum(np.cos(n * (azimuths[:, None] - azimuths)) / n**4 for n in range(2, 6))
    compliance = np.zeros((size, 3, size, 3))
    compliance[:, range(3), :, range(3)] = 1e-8 * waves
    *_, state = model.iterate((compliance, compliance), model.solve())
    assert state.residual < 1e-9
    assert state.rib_thrust.sum() == approx(600.0)
    assert state.deviation[1] == approx(np.einsum("zmwn,wn->zm", compliance, state.forces[1]))


def test_contacts_in_series_give_way_by_the_sum_of_their_approaches():
    first, second = rib_stiffness(0.5, 110e9), rib_stiffness(0.3, 100e9)
    approaches = [(200.0 / stiffness) ** (2 / 3) for stiffness in (first, second)]
    assert 200.0 / in_series(first, second) == approx(sum(approaches) ** 1.5)


def test_pressure_of_a_rib_is_that_of_its_contact_circle():
    load, radius, modulus = np.array(200.0), 0.5, 110e9
    contact = np.cbrt(3 * load * radius / (4 * modulus))
    assert rib_pressure(load, 1 / radius, modulus) == approx(1.5 * load / (np.pi * contact**2))


def test_permitted_axial_loads_are_those_of_the_printed_equations():
    """By hand: 90 mm, 50 mm, 20 mm, C_0 69.5 kN, 3000 rpm, 10 kN radially."""
    speed = 3000 * np.pi / 30
    assert rib_strength(0.09) == approx(4.8309e3, rel=1e-3)
    assert rib_strength_of_series_2(0.09) == approx(3.8421e3, rel=1e-3)
    assert warm_rib_load(69.5e3, -speed, 0.05, 0.09, 0.02, 10e3) == approx(0.98214e3, rel=1e-4)
    assert warm_rib_load(69.5e3, speed, 0.05, 0.09, 0.02, 50e3) == 0.0
    assert np.isnan(warm_rib_load(69.5e3, speed, 0.05, 0.09, 0.2, 10e3))


@pytest.mark.parametrize(
    ("changes", "message"),
    [({"inner_height": 0.0}, "inner_height"), ({"friction": -0.1}, "friction"),
     ({"inner_height": 3e-3, "outer_height": 3e-3}, "meet at a roller")],
)  # fmt: skip
def test_impossible_ribs_are_refused(changes, message):
    with pytest.raises(ImpossiblePart, match=message):
        paper_bearing(ribs=replace(RIBS, **changes))


@pytest.mark.parametrize("changes", [{"ribs": None}, {"axial_modes": 1}])
def test_thrust_that_nothing_carries_is_refused(changes):
    with pytest.raises(ImpossiblePart, match="axial_load"):
        paper_bearing(**{"ribs": RIBS, **changes}, axial_load=1.0)
