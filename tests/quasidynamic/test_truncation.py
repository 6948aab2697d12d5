"""How far contacts reach up a groove."""

import numpy as np
import pytest
from pytest import approx

from quasidynamic.outcome.truncation import edge_angle, height_above_bottom
from tests.ball_bearings import one_ball, slow_bearing


def test_chord_ends_on_the_ball_and_arc_on_the_groove():
    """a = 1 mm on a ball of 5 mm radius: a point of the ball at that distance from the contact normal."""
    angle, half = np.array([0.5]), np.array([1e-3])
    (edge,) = edge_angle(angle, half, 5e-3, "chord")
    normal, point = np.array([np.sin(0.5), np.cos(0.5)]), 5e-3 * np.array([np.sin(edge), np.cos(edge)])
    assert np.hypot(*(point - (normal @ point) * normal)) == approx(1e-3, rel=1e-12)
    assert edge_angle(angle, half, 5e-3, "arc") == approx(0.5 + 0.2, rel=1e-12)
    assert edge_angle(np.array([1.5]), half, 5e-3, "chord") == approx(np.pi / 2, rel=1e-12)


def test_both_conventions_agree_for_small_contacts():
    chord, arc = (
        edge_angle(np.array([0.4]), np.array([1e-4]), 5e-3, kind) - 0.4 for kind in ("chord", "arc")
    )
    assert chord / arc - 1 == approx(0.02**2 / 6, rel=1e-2)


def test_height_of_a_quarter_circle_is_its_radius():
    assert height_above_bottom(np.array([0.0, np.pi / 2]), 6e-3) == approx([0.0, 6e-3])


@pytest.mark.parametrize(("further", "cut"), [(-0.5, True), (0.5, False)])
def test_shoulder_cuts_off_contacts_that_reach_over_it(further, cut):
    """Shoulder half a degree before and behind the edge of the contact."""
    bearing = slow_bearing()
    balls, radius = one_ball(bearing, [45.0, 45.0], [20e3, 0.0]), 0.525 * 30e-3
    edge = 45.0 + np.degrees(balls.ellipse.across[0, 0, 0] / radius)
    found = balls.truncated(0, radius, np.radians(edge + further))
    assert found.tolist() == [[cut, False]]  # without a load nothing is cut off
