"""Friction of contact ellipses that slip in both directions."""

import numpy as np
import pytest
from hypothesis import example, given, settings, strategies as st
from pytest import approx

from quasidynamic.balance.balls.sliding_balls import driving_load
from quasidynamic.contact.ellipse.full_sliding import Ellipse, sliding_friction
from quasidynamic.contact.ellipse.general_sliding import EllipsePoints, sliding_ellipse, strip_points
from quasidynamic.contact.ellipse.rigid_slip import rigid_slip, sagitta

ACROSS, ALONG, RADIUS, TRACTION = 0.6e-3, 0.12e-3, 5e-3, 100.0  # [m] [m] [m] [N]
FALL = ACROSS**2 / (2 * RADIUS)  # [m] of the surface to the edge
SIZES = TRACTION * np.array([1.0, FALL, ACROSS, 1.0, FALL])  # of the forces
MANY = EllipsePoints(60, 40, 1e-5)


def ellipse(growth=0.0, spin="centre"):
    """Contact under a load that has grown by a factor exp(growth)."""
    values = np.array([ACROSS, ALONG, TRACTION]) * np.exp(np.array([1 / 3, 1 / 3, 1.0]) * growth)
    return Ellipse(values[0], values[1], np.array(RADIUS), values[2], spin)


def slip(centre, spin, across, pivot=0.0):
    """From numbers of the size of one: slips over that of the edge by rolling at 1 rad/s."""
    return FALL * np.array([centre, 1 / FALL, spin / ACROSS, across, pivot / RADIUS])


slips = st.builds(
    slip, st.floats(-0.5, 1.5), st.floats(-20.0, 20.0), st.floats(-10.0, 10.0), st.floats(-30.0, 30.0)
)
smooth = st.builds(
    slip, st.floats(-0.5, 1.5), st.floats(0.5, 10.0), st.floats(-3.0, 3.0), st.floats(-30.0, 30.0)
)


def slips_at(own, x, y, spin):
    """Slip along and across, by the spin of the centre as Jones or by the motion of rigid bodies."""
    if spin == "centre":
        rise = sagitta(x, np.array(RADIUS))
        return own[0] + own[1] * rise + own[2] * x, own[3] + own[4] * rise - own[2] * y
    normal = np.stack([x, np.sqrt(RADIUS**2 - x**2), 0 * x], -1) / RADIUS  # across, up, along
    tangent = np.stack([normal[..., 1], -normal[..., 0], 0 * x], -1)
    place = RADIUS * normal + y[..., None] * [0.0, 0.0, 1.0] - [0.0, RADIUS, 0.0]
    velocity = np.cross([own[1], -own[2], -own[4]], place) + np.array([own[3], 0.0, own[0]])
    return velocity[..., 2], (velocity * tangent).sum(-1)


def summed(own, spin="centre", points=600):
    """Heat and its derivatives by a plain sum over rings and rays, of the slip of units."""
    u = (np.arange(points) + 0.5) / points
    rho, angle = np.meshgrid(np.sin(np.pi / 2 * u), 2 * np.pi * u, indexing="ij")
    x, y = ACROSS * rho * np.cos(angle), ALONG * rho * np.sin(angle)
    area = ACROSS * ALONG * rho * np.pi / 2 * np.cos(np.pi / 2 * u)[:, None] / points * 2 * np.pi / points
    force = 1.5 * TRACTION / (np.pi * ACROSS * ALONG) * np.sqrt(1 - rho**2) * area
    along, across = slips_at(own, x, y, spin)
    size = np.hypot(along, across)
    units = [slips_at(unit, x, y, spin) for unit in np.eye(5)]
    forces = [(force * (along * u + across * v) / size).sum() for u, v in units]
    return (force * size).sum(), np.array(forces)


spins = pytest.mark.parametrize("spin", ["centre", "local"])


@spins
def test_slip_at_points_is_that_of_rigid_bodies_or_of_the_spin_in_the_centre(spin):
    x, y = np.array([-0.9, 0.0, 0.3, 0.8]) * ACROSS, np.array([0.1, 0.9, -0.5, 0.4]) * ALONG
    own = slip(0.2, 0.5, 0.3, 20.0)
    found = rigid_slip(x, y, np.array([RADIUS]), spin) @ own
    assert found.T == approx(np.array(slips_at(own, x, y, spin)), rel=1e-12)


@pytest.mark.sampled(3)
@spins
@pytest.mark.parametrize(
    "own",
    [slip(0.2, 0.5, 0.3, 20.0), slip(0.0, 8.0, 2.0), slip(-0.3, -4.0, -3.0), slip(0.4, 0.0, 9.0)],
    ids=["nearly rolling", "spinning", "spinning back", "turning across"],
)
def test_friction_is_that_of_a_plain_sum(own, spin):
    found, (power, forces) = sliding_ellipse(own, ellipse(spin=spin)), summed(own, spin)
    assert found.power == approx(power, rel=2e-5)
    assert found.by_slip / SIZES == approx(forces / SIZES, abs=2e-4)


@spins
@settings(max_examples=30)
@given(centre=st.floats(-0.5, 1.5), turn=st.floats(-8.0, 8.0))
@example(centre=0.0, turn=0.02)  # both positions without slip are near each other
@example(centre=0.0, turn=0.15625)
def test_without_slip_across_friction_is_the_closed_form_over_strips(centre, turn, spin):
    own, contact = slip(centre, turn, 0.0), ellipse(spin=spin)
    found, known = sliding_ellipse(own, contact, MANY), sliding_friction(own[:3], contact)
    error = (
        3e-8 if spin == "local" else 2e-6
    )  # of 1500 pairs the largest are 7e-9 and 1.3e-6, near pure rolling
    assert found.power == approx(float(known.power), rel=1e-8)
    assert found.by_slip[:3] / SIZES[:3] == approx(known.by_slip / SIZES[:3], abs=error)
    assert found.by_slip[3:] / SIZES[3:] == approx(np.zeros(2), abs=1e-12)


@spins
@settings(max_examples=30)
@given(own=slips)
def test_points_leave_a_small_error(own, spin):
    found, fine = (sliding_ellipse(own, ellipse(spin=spin), *points) for points in ([], [MANY]))
    assert found.power == approx(float(fine.power), rel=2e-9)
    assert found.by_slip / SIZES == approx(fine.by_slip / SIZES, abs=2e-7)


@spins
@settings(max_examples=25)
@given(own=smooth)
def test_curvature_is_the_slope_of_the_force(own, spin):
    found = sliding_ellipse(own, ellipse(spin=spin))
    scale = np.sqrt(np.diagonal(found.curvature))
    for component in range(5):
        step = np.eye(5)[component] * 1e-5 / scale[component] * np.sqrt(found.power)
        ahead, behind = (sliding_ellipse(own + sign * step, ellipse(spin=spin)).by_slip for sign in (1, -1))
        slope = (ahead - behind) / (2 * step[component])
        allowed = 3e-3 * scale * scale[component] + 1e-9 * SIZES / step[component]
        assert (np.abs(found.curvature[component] - slope) <= allowed).all()


@spins
@settings(max_examples=25)
@given(own=smooth)
def test_slope_by_the_load_is_that_of_a_growing_contact(own, spin):
    step = 1e-4
    ahead, behind = (sliding_ellipse(own, ellipse(sign * step, spin)).by_slip for sign in (1, -1))
    slope = (ahead - behind) / (2 * step)
    assert sliding_ellipse(own, ellipse(spin=spin)).by_load / SIZES == approx(slope / SIZES, abs=2e-4)


@spins
@given(here=slips, there=slips)
def test_heat_lies_between_its_tangent_and_its_majorant(here, there, spin):
    found, step = sliding_ellipse(here, ellipse(spin=spin)), there - here
    tangent, heat = found.power + found.by_slip @ step, sliding_ellipse(there, ellipse(spin=spin)).power
    assert tangent <= heat * (1 + 1e-7)
    assert heat <= (tangent + (found.majorant * step**2).sum() / 2) * (1 + 1e-7)


@given(slips)
def test_mirrored_slip_has_the_mirrored_force(own):
    sign = np.array([1.0, 1.0, 1.0, -1.0, -1.0])  # y turned round: slip across and its forces change sign
    found, other = (sliding_ellipse(value, ellipse()).by_slip for value in (own, own * sign))
    assert other / SIZES == approx(sign * found / SIZES, abs=1e-12)


@settings(max_examples=50)
@given(st.floats(-8.0, 1.0), st.floats(-3.0, 3.0), st.floats(-2.0, 2.0))
def test_points_of_a_strip_follow_a_slip_that_nearly_vanishes(decades, middle, turn):
    along, k, s = (np.array([value]) for value in (10.0**decades, middle, turn))

    def heat(points):
        place, weight = strip_points(along, k, s, points)
        return (weight * np.hypot(along[:, None], k[:, None] - s[:, None] * place)).sum()

    assert heat(24) == approx(heat(200), rel=1e-8)


@given(st.floats(-4.0, 2.0), st.floats(0.1, 10.0))
def test_driving_load_is_the_load_of_pressed_balls_and_never_less_than_its_width(decades, width):
    load, w, step = np.array([width * 10.0**decades]), np.array([width]), 1e-6 * width
    found = driving_load(load, w)
    assert found.value >= max(load[0], 0.99 * width)
    assert found.hold * found.value == approx(load, rel=1e-6)
    if load > 20 * width:
        assert found.value == load
    by_load = (driving_load(load + step, w).value - driving_load(load - step, w).value) / (2 * step)
    by_width = (driving_load(load, w + step).value - driving_load(load, w - step).value) / (2 * step)
    assert found.by_load == approx(by_load, abs=1e-5)
    assert found.by_width == approx(by_width, abs=1e-5)
