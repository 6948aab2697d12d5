"""Pure rolling lines of a 7008 bearing: Rivera, Tong and Hong, J. Korean Soc. Precis. Eng. 38 (2021) 851.

Table 1 gives bore 40, pitch 54, ball 7.938 mm, 18 balls, 15 degrees. Conformity is not printed: 0.52 is
assumed, the only value near which the text comes out; E 206 GPa, nu 0.3, 7800 kg/m3 and no tilt assumed.
Figures are not read off: the tests follow what the text says of them, with its Eq. (15) and no net friction.
The numbers behind the words come from an independent solution of the same equations.
"""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.parts.angular_contact_bearing import RingOperation
from tests.ball_bearings import fast_bearing

RPM = np.pi / 30
INNER, OUTER = 0, 1


def solved(speeds, angle=15.0, radial=0.0, axial=500.0):
    bearing = fast_bearing(7.938e-3, 54e-3, 18, np.radians(angle), 0.52)
    operations = [
        RingOperation(
            load=(axial, 0.0, radial, 0.0, 0.0),
            displacement=(None, None, None, 0.0, 0.0),
            inner_speed=n * RPM,
        )
        for n in speeds
    ]
    return AngularContactBallBearing(bearing=bearing, control="equal").solve_many(operations)


def contacts(speeds, **changes):
    return [state.rolling_contact(spin="contact angle") for state in solved(speeds, **changes)]


def counts(speeds, **changes):
    return np.array([contact.lines.count[:, 0] for contact in contacts(speeds, **changes)])


FIRST, SECOND = -0.70, 0.08  # over the half-width, without inertia
SINGLE = {500.0: 5, 1000.0: 9}  # radial load [N]: inner contacts with one line


def test_lines_without_inertia():
    (contact,) = contacts([1.0])
    for race in (INNER, OUTER):
        assert contact.lines.first[race] == approx(np.full(18, FIRST), abs=0.01)
        assert contact.lines.second[race] == approx(np.full(18, SECOND), abs=0.005)


def test_speed_raises_spin_parameter_on_inner_race_and_lowers_it_on_outer():
    found = np.array([contact.parameter[:, 0] for contact in contacts([1.0, 5000.0, 10000.0, 15000.0])])
    assert (np.diff(found[:, INNER]) > 0).all()
    assert (np.diff(found[:, OUTER]) < 0).all()


def test_first_line_nears_the_edge_sooner_under_a_low_axial_load():
    first = [contacts([15000.0], axial=axial)[0].lines.first[INNER, 0] for axial in (300.0, 500.0, 1000.0)]
    assert (np.diff(first) > 0).all()


def test_two_lines_on_both_races_at_1000_newton():
    assert (counts([5000.0, 10000.0, 15000.0], axial=1000.0) == 2).all()


def test_unloaded_contact_angle_sets_the_number_of_lines():
    speeds = [1000.0, 5700.0, 6100.0, 15000.0]
    assert (counts(speeds, angle=15.0) == 2).all()
    assert (counts(speeds, angle=40.0) == 1).all()
    between = counts(speeds, angle=25.0)
    assert (between[:, INNER] == 1).all()
    assert list(between[:, OUTER]) == [1, 1, 2, 2]  # a second line from about 5900 rpm


@pytest.mark.parametrize(("radial", "single"), [(100.0, 0), *SINGLE.items()])
def test_radial_load_takes_a_line_from_some_inner_contacts(radial, single):
    (contact,) = contacts([15000.0], radial=radial)
    assert (contact.lines.count[INNER] == 1).sum() == single
    assert (contact.lines.count[OUTER] == 2).all()
    alone = contact.balls[contact.lines.count[INNER] == 1]
    assert all(abs(ball - 9) <= single // 2 for ball in alone)  # around 180 degrees from the load


def test_lines_estimate_the_torque_of_the_integral():
    """Fig. 11: a good match. The lines are the narrow limit, hence always below."""
    for state, contact in zip(solved([1000.0, 15000.0]), contacts([1000.0, 15000.0]), strict=True):
        weight = np.sin(state.contact_angles)
        whole = (weight * contact.spin_torques(0.1)).sum()
        assert (weight * contact.spin_torques(0.1, "lines")).sum() / whole == approx(0.97, abs=0.01)


def test_slip_field_differs_from_equation_15_at_speed():
    """Eq. (15) drops the angle between contacts and spin axis: one line on each race instead of two."""
    (state,) = solved([15000.0])
    exact = state.rolling_contact(spin="slip field")
    assert exact.parameter[:, 0] == approx([1.27, 1.19], abs=0.005)
    assert (exact.lines.count == 1).all()
    weight = np.sin(state.contact_angles)
    ratio = (weight * exact.spin_torques(0.1)).sum() / (
        weight * state.rolling_contact(spin="contact angle").spin_torques(0.1)
    ).sum()
    assert ratio == approx(1.4, abs=0.1)
