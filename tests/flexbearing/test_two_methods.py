"""Two coupling methods that end apart: both at an equilibrium, or one of them at none."""

from dataclasses import replace

import pytest

from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupling import PartnerFailed
from flexbearing.progress import Logged
from flexbearing.rings.condensed import condensed_raceways
from flexbearing.runs.several import between_flexible_raceways
from quasidynamic import NotSolved, RollerBearing
from quasidynamic.solve.step_length import SolverOutcome
from tests.cold_oil import cold_case, settings
from tests.two_methods import AGAIN, SAME, difference, iterated, solved_again

pytestmark = pytest.mark.slow
THICK_RING = (
    "inner.kind=rigid", "outer.kind=ring", "outer.thickness=15 mm", "accuracy.structure=beam",
    "operation.tilt=fixed", "accuracy.slices=10",
)  # fmt: skip


@pytest.fixture(scope="module")
def cold(tmp_path_factory):
    """Bearing, rings, newton's end state and another equilibrium of cold oil between a flexible ring."""
    case = read_case(cold_case(tmp_path_factory.mktemp("cold")), [*THICK_RING, *settings(13.0)])
    bearing = BearingPartner(roller_bearing.bearing(case))
    rings = condensed_raceways(case, bearing.model.bearing.azimuths, Logged())
    *_, last = iterated(bearing, rings, bearing.solve(), "newton", 1e-8)
    several = between_flexible_raceways(last.state, rings.linearised(last.state.forces))
    assert several is not None
    assert several.raceways == "flexible raceways"
    return bearing, rings, last.state, several.others[0]


def test_two_equilibria_are_solved_again_by_the_other_method_and_named(cold):
    bearing, rings, ours, other = cold
    assert difference(ours.loads, other.loads) > 100 * SAME
    two = solved_again(bearing, rings, ours, other)
    assert two.by_other <= AGAIN
    assert two.by_newton <= AGAIN
    assert two.both_right
    for state in (ours, other):
        assert f"{state.loads[0].max():.6g} N" in two.names
    assert "newton: " in two.names
    assert "iqn-ils: " in two.names


def test_a_state_that_is_no_equilibrium_is_left_by_the_other_method(cold):
    bearing, rings, ours, _ = cold
    heavier = BearingPartner(
        replace(bearing.model, operation=replace(bearing.model.operation, radial_load=2002.0))
    )
    *_, last = iterated(heavier, rings, ours, "iqn-ils", 1e-8)
    assert last.status == "converged"
    two = solved_again(bearing, rings, ours, last.state)
    assert two.by_newton > AGAIN
    assert not two.both_right


def test_a_method_that_fails_at_the_state_of_the_other_explains_nothing(cold, monkeypatch):
    """It ends where it began, which is no agreement."""
    bearing, rings, ours, other = cold

    def nothing(self, *given):
        raise NotSolved("no step", SolverOutcome.NOT_FINITE)
        yield

    monkeypatch.setattr(RollerBearing, "iterate", nothing)
    with pytest.raises(PartnerFailed):
        next(bearing.iterate((None, None), ours, None))
    two = solved_again(bearing, rings, ours, other)
    assert two.by_newton == float("inf")
    assert not two.both_right
