"""Random designs between soft rings: light balls on the walls of their grooves, and a limit point."""

import pytest
from pytest import approx

import flexbearing
from benchmarks.elastic_balls import settings, summed

SEED = 0xAE702F95


def solved(number, tmp_path, *more):
    case, _, design = settings(SEED, number)
    return flexbearing.run(case, [*design, *more], output=tmp_path / "design.h5")


@pytest.mark.parametrize("number", [317, 366])  # four points, and radial contact at 51 rpm
def test_balls_that_only_inertia_presses_do_not_decide_whether_there_is_a_balance(number, tmp_path):
    """A ten-thousandth of a newton at 90 degrees was taken for a load far too high, or for no balance."""
    found = solved(number, tmp_path)
    assert found.attributes["status"] == "converged"
    assert summed(found) < 1e-9


def test_rings_beyond_a_limit_point_have_no_balance_by_any_method(tmp_path):
    """The square of the determinant falls in a straight line to zero at 0.674256 of the compliance.

    Contact angles are 73.8 degrees there, beyond shoulders of 64; by smaller steps than those of the program.
    """
    found = solved(214, tmp_path)
    assert (found.attributes["ending"], [*found.attributes["attempts"]]) == ("too soft", ["newton"])
    angle = float(found.attributes["message"].split("angles reach ")[1].split(" deg")[0])
    assert angle == approx(73.8, abs=0.2)
