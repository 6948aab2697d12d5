"""What oil between balls and races makes them do."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from pytest import approx
from scipy.special import ellipe

from quasidynamic import Eyring, Regression4109, oil_at
from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.balance.balls.angular_contact import lubricated_races, race_contacts
from quasidynamic.contact.drag import ball_churning, ball_drag_force
from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.ellipse.rigid_slip import ACROSS, CENTRE, SPIN
from quasidynamic.contact.film import ELLIPTIC_FORMULAS, Film
from quasidynamic.contact.line import half_width
from quasidynamic.contact.lubrication import BallLubrication
from quasidynamic.contact.traction.asperity_friction import RoundedCoulomb
from quasidynamic.contact.traction.mixed import ZHOU_HOEPRICH, RoughContacts
from quasidynamic.contact.traction.traction_law import in_any_contact
from quasidynamic.errors import ImpossiblePart, NotSolved
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.solve.balls.coulomb_control import CoulombControl
from quasidynamic.solve.balls.free_ball_search import free_ball_motion
from tests.ball_bearings import fast_bearing
from tests.random_balls import FILM, drawn_oiled, identities, unbalanced

BEARING = fast_bearing(7.938e-3, 54e-3, 6, np.radians(15.0), 0.52, 0.525)
CONTACTS = race_contacts(BEARING)
OIL = oil_at("ISO VG 32", 343.15)
OILED = BallLubrication(oil=OIL, oil_fraction=0.02, traction=FILM, churning_gap=1e-3)


def thrust(load, speed, outer_speed=0.0):
    """Operation without tilt; speeds in rpm."""
    return RingOperation(
        load=(load, 0.0, 0.0, 0.0, 0.0),
        displacement=(None, None, None, 0.0, 0.0),
        inner_speed=speed * np.pi / 30,
        outer_speed=outer_speed * np.pi / 30,
    )


def solved(operation, lubrication=OILED, bearing=BEARING):
    model = AngularContactBallBearing(bearing=bearing, control="oil", lubrication=lubrication)
    return model.solve(operation)


def printed_central(u, g, w, k):
    return 2.69 * u**0.67 * g**0.53 * w**-0.067 * (1 - 0.61 * np.exp(-0.73 * k))


def printed_minimum(u, g, w, k):
    return 3.63 * u**0.68 * g**0.49 * w**-0.073 * (1 - np.exp(-0.68 * k))


@pytest.mark.parametrize(
    ("name", "printed"),
    [("hamrock_dowson", printed_central), ("hamrock_dowson_minimum", printed_minimum)],
    ids=["central", "minimum"],
)
def test_film_of_a_ball_is_that_of_the_printed_formula(name, printed):
    laws = replace(OILED, film=ELLIPTIC_FORMULAS[name], inlet_heating=False)
    races = lubricated_races(BEARING, CONTACTS, laws)
    load, speed = np.array([[80.0, 100.0]]), np.array([[20.0, 21.0]])
    film = races.film(load, np.array([[1e-4, 1e-4]]), 0 * speed, speed).thickness
    ratio = np.array([contact.across / contact.along for contact in CONTACTS])
    elastic = races.modulus * races.radius
    groups = OIL.viscosity * speed / elastic, OIL.pressure_viscosity * races.modulus
    assert film == approx(races.radius * printed(*groups, load / (elastic * races.radius), ratio), rel=1e-12)
    assert races.radius == approx(
        3.969e-3 * np.array([1, 1]) * (1 + np.array([-1, 1]) * 0.147 * np.cos(np.radians(15.0)))
    )


def test_an_inlet_that_is_short_starves_the_film_without_a_leap():
    formula = ELLIPTIC_FORMULAS["hamrock_dowson"]
    h, b, radius = np.array(4e-7), np.array(1e-4), np.array(3.5e-3)
    full = 3.06 * (h * radius / b**2) ** 0.58
    film = Film(h, np.array(0.0), np.array(0.0), h / 20.0)
    assert formula.starved_film(film, b, radius, 1.01 * full).thickness == h
    assert formula.starved_film(film, b, radius, 0.5 * full).thickness == approx(h * 0.5**0.29, rel=1e-12)
    thicker = Film(1.001 * h, *film[1:])
    slope = (
        formula.starved_film(thicker, b, radius, 0.5 * full).thickness
        - formula.starved_film(film, b, radius, 0.5 * full).thickness
    ) / (1e-3 * h)
    by_speed = formula.starved_film(film, b, radius, 0.5 * full).by_entrainment
    assert by_speed / film.by_entrainment == approx(slope, rel=1e-3)


def test_strips_of_an_ellipse_are_line_contacts():
    races = lubricated_races(BEARING, CONTACTS, OILED)
    for race, contact in enumerate(CONTACTS):
        a, b = contact.semi_axes(80.0)
        middle = 0.75 * 80.0 / a
        assert half_width(middle, races.strip_radius[race], races.modulus[race]) == approx(b, rel=1e-12)
        mean = middle / (2 * b)
        assert mean == approx(np.pi / 4 * contact.peak_pressure(80.0), rel=1e-12)


def test_an_oil_at_its_limiting_stress_spins_as_coulomb_friction_does():
    """3/8 Lambda Q a E(1 - b^2/a^2), the spinning torque of a Hertz ellipse, and no force."""
    stiff = partial(Eyring, limiting_ratio=0.05, eyring_stress=1e12)
    races = lubricated_races(
        BEARING, CONTACTS, replace(OILED, oil=replace(OIL, viscosity=1e3), traction=stiff)
    )
    load = np.array([[80.0, 100.0]])
    a, b = (np.array([[c.semi_axes(q)[i] for c, q in zip(CONTACTS, load[0], strict=True)]]) for i in (0, 1))
    slip = np.zeros((1, 2, 5))
    slip[..., SPIN] = 0.3
    ellipse = Ellipse(a, b, np.full_like(a, 4.05e-3), load, "centre")
    found = races.traction(slip, ellipse, np.array([1500.0]), np.array([[20.0, 21.0]])).sliding.by_slip
    assert found[..., SPIN] == approx(3 / 8 * 0.05 * load * a * ellipe(1 - (b / a) ** 2), rel=1e-6)
    assert found[..., [CENTRE, ACROSS]] == approx(0.0, abs=1e-9)


@pytest.mark.parametrize(
    "law", [FILM, Regression4109, partial(FILM, film_heating=True)], ids=["eyring", "4109", "hot"]
)
def test_slopes_of_traction_by_slip_speed_and_film(law):
    races = lubricated_races(BEARING, CONTACTS, replace(OILED, traction=law))
    load = np.array([[80.0, 100.0]])
    a, b = (np.array([[c.semi_axes(q)[i] for c, q in zip(CONTACTS, load[0], strict=True)]]) for i in (0, 1))
    ellipse = Ellipse(a, b, np.full_like(a, 4.05e-3), load)
    slip = np.array([[[-8e-6, 4.0, 0.6, 1e-6, 0.01], [5e-6, -4.0, 0.2, -2e-6, 0.02]]])
    speed, u = np.array([1500.0]), np.array([[20.0, 21.0]])

    def by_slip(slip, u):
        return races.traction(slip, ellipse, speed, u).sliding.by_slip

    here = races.traction(slip, ellipse, speed, u)
    for k, size in enumerate([1e-6, 1.0, 1.0, 1e-6, 1.0]):
        step = np.zeros(5)
        step[k] = 1e-5 * size
        change = (by_slip(slip + step, u) - by_slip(slip - step, u)) / (2e-5 * size)
        expected = here.sliding.curvature[..., k]
        if k == 0:  # it heats the inlet
            expected = expected + here.sliding.by_film * (here.film.by_sliding * speed[:, None])[..., None]
        scale = np.abs(expected).max((0, 1))
        assert change == approx(expected, rel=2e-3, abs=2e-3 * scale.max())
    change = (by_slip(slip, 1.0001 * u) - by_slip(slip, 0.9999 * u)) / (2e-4 * u[..., None])
    total = here.sliding.by_entrainment + here.sliding.by_film * here.film.by_entrainment[..., None]
    assert change == approx(total, rel=1e-3, abs=1e-3 * np.abs(total).max())


def test_drag_and_churning_of_a_ball():
    force, slope = ball_drag_force(np.array([-12.0, 12.0]), 8e-3, OIL, 1.0, 0.4)
    assert force == approx([-1, 1] * np.array(0.4 * OIL.density / 2 * np.pi / 4 * 8e-3**2 * 144), rel=1e-12)
    assert slope == approx(2 * np.abs(force) / 12.0)
    slow = ball_churning(np.array(0.01), 8e-3, OIL, oil_fraction=1.0, gap=1e3)
    assert slow.torque == approx(8 * np.pi * OIL.viscosity * 4e-3**3 * 0.01, rel=1e-6)
    fast = [
        ball_churning(np.array(w), 8e-3, OIL, oil_fraction=1.0, gap=1e-3) for w in (999.0, 1000.0, 1001.0)
    ]
    assert fast[1].by_spin == approx((fast[2].torque - fast[0].torque) / 2.0, rel=1e-6)


def dry_limit(friction):
    """Oil that does nothing, and asperities with all the load."""
    thin = replace(OIL, viscosity=1e-20, density=1e-20)
    rubbing = RoundedCoulomb(coefficient=friction, sign_speed=1e-12)
    rough = RoughContacts(
        fluid=partial(Eyring, limiting_ratio=1e-12, eyring_stress=1.0),
        share=ZHOU_HOEPRICH,
        asperities=partial(in_any_contact, rubbing),
        inner_roughness=1.0,
        outer_roughness=1.0,
    )
    return BallLubrication(
        oil=thin, oil_fraction=0.0, traction=rough, drag_coefficient=1e-15, inlet_heating=False
    )


@pytest.mark.parametrize("speed", [5000.0, -5000.0, 1.0])
def test_without_oil_balls_are_those_of_coulomb_friction(speed):
    operation = thrust(1000.0, speed)
    oiled = solved(operation, dry_limit(0.06))
    dry = AngularContactBallBearing(bearing=BEARING, control="coulomb", friction=0.06).solve(operation)
    names = (
        "friction_torque",
        "orbital_speed",
        "ball_speed",
        "attitude",
        "loads",
        "contact_angles",
        "ring_displacement",
    )
    for name in names:
        assert getattr(oiled, name) == approx(getattr(dry, name), rel=1e-9, abs=1e-15), name
    assert oiled.yaw == approx(dry.yaw, abs=1e-9)
    assert oiled.tractions == approx(dry.tractions, abs=1e-9 * dry.loads.max())
    assert oiled.stiffness == approx(dry.stiffness, rel=1e-6, abs=1e-6 * dry.stiffness.max())


def test_oil_must_be_given_with_its_control_alone():
    with pytest.raises(ImpossiblePart, match="lubrication"):
        AngularContactBallBearing(bearing=BEARING, control="oil")
    with pytest.raises(ImpossiblePart, match="lubrication"):
        AngularContactBallBearing(bearing=BEARING, control="outer", lubrication=OILED)


@pytest.mark.parametrize("outer_speed", [0.0, -3000.0])
def test_power_of_the_rings_is_the_heat_and_their_torque_the_drag(outer_speed):
    still = replace(OILED, churning_gap=None)
    power, momentum, _ = identities(solved(thrust(300.0, 15000.0, outer_speed), still))
    assert abs(power) < 1e-9
    assert momentum < 1e-9
    power, *_ = identities(solved(thrust(300.0, 15000.0, outer_speed)))
    assert abs(power) < 1e-9


def test_a_mirrored_sense_of_rotation_mirrors_the_bearing():
    forward, back = solved(thrust(300.0, 12000.0)), solved(thrust(300.0, -12000.0))
    assert back.orbital_speed == approx(-forward.orbital_speed, rel=1e-10)
    assert back.oil.ring_torque == approx(-forward.oil.ring_torque, rel=1e-8)
    assert back.oil.heat == approx(forward.oil.heat, rel=1e-9)
    assert back.oil.slip == approx(forward.oil.slip, abs=1e-10)


def test_cases_side_by_side_are_those_alone():
    model = AngularContactBallBearing(bearing=BEARING, control="oil", lubrication=OILED)
    operations = [thrust(300.0, 15000.0), thrust(500.0, 9000.0)]
    for together, alone in zip(model.solve_many(operations), map(model.solve, operations), strict=True):
        assert together.oil.heat == approx(alone.oil.heat, rel=1e-9)
        assert together.contact_angles == approx(alone.contact_angles, rel=1e-10)


@pytest.mark.sampled(4)
@pytest.mark.parametrize("seed", range(20))
def test_random_bearings_in_oil_are_in_balance(seed):
    model, operation = drawn_oiled(seed)
    try:
        state = model.solve(operation)
    except NotSolved as failure:
        pytest.skip(str(failure))
    assert unbalanced(state) < 2e-9
    power, momentum, _ = identities(state)
    assert abs(power) < 1e-9
    if model.lubrication.churning_gap is None:
        assert momentum < 1e-9


def test_balls_that_friction_does_not_balance_are_named(monkeypatch):
    def lost(balls, nearby=None, *starts):
        found = free_ball_motion(balls, nearby, *starts)
        found.motion[3] = np.nan
        return found

    monkeypatch.setattr("quasidynamic.solve.balls.coulomb_control.free_ball_motion", lost)
    with pytest.raises(NotSolved, match=r"no motion of \d+ balls found") as caught:
        solved(thrust(300.0, 15000.0))
    assert "wrong unit" not in str(caught.value)


def test_a_ball_whose_friction_is_not_found_again_is_no_solution(monkeypatch):
    """Of 2000 random bearings in cages one was stored without its heat (`drawn_caged(1373)`)."""
    whole = CoulombControl.oiled

    def without_one(*given):
        found = whole(*given)
        found.drag_heat[..., 3] = np.nan
        return found

    monkeypatch.setattr(CoulombControl, "oiled", without_one)
    with pytest.raises(NotSolved, match="no motion of 1 balls found"):
        solved(thrust(500.0, 15000.0))


@pytest.mark.parametrize("seed", [23, 38, 43])
def test_slow_bearings_without_a_cage_are_solved(seed):
    """At 0.7 to 4.4 rpm unloaded balls were lost to inlets, or the ring stalled at balls with two motions."""
    test_random_bearings_in_oil_are_in_balance(seed)
