"""A ring whose guide holds its tilt: the moments of the guide, and the radial stiffness they change."""

import numpy as np
import pytest
from pytest import approx

from tests.bearings import paper_bearing

HELD = {"misalignment": 3e-3, "load": 5e3}  # tilted so far that a radial displacement changes the moment


def bearing(**changes):
    return paper_bearing(**{**HELD, **changes})


@pytest.mark.parametrize("direction", [0.0, 2.0])
def test_radial_stiffness_of_a_held_ring_is_the_slope_of_its_load(direction):
    """The guide's moments follow the load so that the tilt stays: without them the ring is softer."""
    step = 1.0  # [N]
    state = bearing(load_direction=direction).solve()
    along = np.array([np.sin(direction), np.cos(direction)])
    up, down = (
        bearing(load_direction=direction, load=HELD["load"] + change).solve(start=state)
        for change in (step, -step)
    )
    moved = along @ (up.ring_displacement - down.ring_displacement)
    assert state.tangent.radial_stiffness == approx(2 * step / moved, rel=1e-5)
    turned = up.ring_moment - down.ring_moment
    assert np.abs(turned).max() > 1e-5 * 2 * step  # [N m] else the sign of the moments would not matter


@pytest.mark.parametrize("guide", [HELD, {"load": 5e3}], ids=["held", "free"])
def test_radial_stiffness_follows_from_the_radial_matrix(guide):
    tangent = paper_bearing(**guide, load_direction=2.0).solve().tangent
    moved = np.linalg.solve(tangent.radial_matrix, tangent.direction)
    assert 1 / (tangent.direction @ moved) == approx(tangent.radial_stiffness, rel=1e-9)


@pytest.mark.parametrize("direction", [0.0, 2.0])
def test_guide_tilts_the_ring_as_a_moment_would(direction):
    """The moment that a guide gives, applied to a ring free to tilt, tilts it by the held angle."""
    held = bearing(load_direction=direction).solve()
    in_plane = np.array([np.cos(direction), np.sin(direction)])
    moment = float(in_plane @ held.ring_moment)
    assert moment > 0.0  # the guide works against the rollers
    free = bearing(load_direction=direction, misalignment=0.0, moment=moment).solve()
    # The free ring also tilts a little out of the plane, where no moment is applied.
    assert in_plane @ free.ring_tilt == approx(HELD["misalignment"], rel=1e-3)
