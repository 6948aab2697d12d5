"""Random designs between soft rings: light balls on the walls of their grooves, and a limit point."""

import numpy as np
from pytest import approx

import flexbearing
from benchmarks.elastic_balls import settings

SEED = 0xAE702F95


def solved(number, tmp_path, *more):
    case, _, design = settings(SEED, number)
    return flexbearing.run(case, [*design, *more], output=tmp_path / "design.h5")


def test_a_contact_that_only_inertia_presses_at_90_degrees_is_no_load_far_too_high(tmp_path):
    found = solved(317, tmp_path)
    assert found.attributes["status"] == "converged"
    angles, loads = np.degrees(found.flexible["contact_angle"]), found.flexible["contact_load"]
    steep = (np.abs(angles) > 89.9) & (loads > 0)
    assert 0 < loads[steep].max() < 1e-3 * loads.max()


def test_light_balls_on_the_walls_of_their_grooves_do_not_hide_a_balance(tmp_path):
    """Of whole contacts: balls of 0.1 N beside others of 50 kN stopped the search as "too soft"."""
    found = solved(366, tmp_path, "coupling.fallback=false")
    assert found.attributes["ending"] == "over the shoulder"
    assert "whole ones would be in balance" in found.attributes["message"]


def test_rings_beyond_a_limit_point_have_no_balance_by_any_method(tmp_path):
    """The square of the determinant falls in a straight line to zero at 0.674256 of the compliance.

    Contact angles are 73.8 degrees there, beyond shoulders of 64; by smaller steps than those of the program.
    """
    found = solved(214, tmp_path)
    assert (found.attributes["ending"], [*found.attributes["attempts"]]) == ("too soft", ["newton"])
    angle = float(found.attributes["message"].split("angles reach ")[1].split(" deg")[0])
    assert angle == approx(73.8, abs=0.2)
