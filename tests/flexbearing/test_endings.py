"""Runs that find no equilibrium of bearing and rings: what their files hold and say."""

from dataclasses import replace

import numpy as np
import pytest

import flexbearing
from flexbearing.__main__ import command
from flexbearing.coupling import PartnerFailed
from flexbearing.rings import stored
from flexbearing.rings.raceways import CondensedRaceway
from quasidynamic import NotSolved, RollerBearing, roller
from quasidynamic.solve.rollers import settled_time, strategy
from quasidynamic.solve.start import static_start
from quasidynamic.solve.step_length import SolverOutcome
from tests.bearings import paper_bearing
from tests.places import CONFIGS

PAPER = CONFIGS / "mao2016.toml"
BEAM = ["inner.kind=rigid", "accuracy.structure=beam", "accuracy.slices=10", "operation.tilt=fixed"]
METHODS = ["newton", "iqn-ils", "aitken", "relaxed"]


@pytest.fixture
def unsolvable(monkeypatch):
    """Nothing is solved between flexible raceways: newton stalls after a step, shapes have no equilibrium."""
    iterate, solve = RollerBearing.iterate, RollerBearing.solve

    def stalling(self, *given):
        iterates = iterate(self, *given)
        yield next(iterates)
        yield replace(next(iterates), status=SolverOutcome.STALLED)

    def unsolved(self, start=None, deviation=None):
        if deviation is not None:
            raise NotSolved("no shape is solved", SolverOutcome.LIMIT)
        return solve(self, start, deviation)

    monkeypatch.setattr(RollerBearing, "iterate", stalling)
    monkeypatch.setattr(RollerBearing, "solve", unsolved)


@pytest.mark.parametrize("slope", ["0 arcmin", "3 arcmin"])
def test_run_that_no_method_solves_holds_the_nearest_state_and_names_every_method(slope, unsolvable):
    result = flexbearing.run(PAPER, [*BEAM, f"operation.misalignment={slope}"])
    attempts, message = result.attributes["attempts"], result.attributes["message"]
    assert result.attributes["status"] == "not solved"
    assert list(attempts) == METHODS
    assert "by newton, whose last state is stored" in message
    assert message.endswith(attempts["newton"]["message"])
    assert all(method in message for method in METHODS)
    assert "no shape is solved" in attempts["relaxed"]["message"]
    assert not np.array_equal(result.flexible["outer_load"], result.rigid["outer_load"])
    assert result.flexible["outer_deviation"].any()


def test_run_that_no_method_solves_ends_with_one(unsolvable, tmp_path):
    code = command(["run", str(PAPER), "-o", str(tmp_path / "r.h5"), *_set(BEAM)])
    assert code == 1
    assert flexbearing.read(tmp_path / "r.h5").attributes["iterations"] == len(METHODS)


def test_state_between_rigid_raceways_is_never_the_flexible_one(monkeypatch, tmp_path):
    def nothing(self, *given):
        raise NotSolved("no step", SolverOutcome.NOT_FINITE)
        yield

    monkeypatch.setattr(RollerBearing, "iterate", nothing)
    alone = ["coupling.fallback=false", "operation.misalignment=3 arcmin"]
    result = flexbearing.run(PAPER, [*BEAM, *alone], output=tmp_path / "r.h5")
    assert result.attributes["status"] == "not solved"
    assert "no step" in result.attributes["message"]
    assert result.rigid
    assert not result.flexible


def test_rings_that_fail_at_the_end_state_leave_a_file_with_all_iterations(monkeypatch, tmp_path):
    """The file said that there were none, which was an internal error."""

    def failing(self):
        raise PartnerFailed("no figures", "not solved")

    monkeypatch.setattr(CondensedRaceway, "figures", failing)
    result = flexbearing.run(PAPER, BEAM, output=tmp_path / "r.h5")
    assert result.attributes["status"] == "not solved"
    assert result.attributes["iterations"] == len(result.iterations) > 0
    assert result.attributes["message"] == "no figures"


def test_elements_that_find_no_memory_are_an_ending_of_their_own(monkeypatch, tmp_path):
    """Meshes that are far too fine ended as an internal error."""

    def exhausted(*given, **named):
        raise MemoryError("std::bad_alloc")

    monkeypatch.setattr(stored, "condense", exhausted)
    monkeypatch.setattr(stored, "_in_memory", stored._in_memory.__wrapped__)
    result = flexbearing.run(PAPER, BEAM, output=tmp_path / "r.h5")
    assert result.attributes["status"] == "not solved"
    assert "outer ring: there is not enough memory" in result.attributes["message"]
    assert result.rigid


def _set(settings):
    return [word for setting in settings for word in ("--set", setting)]


def test_a_row_ends_at_its_budget_of_work_with_a_status_of_its_own(monkeypatch):
    """Next to no load in a wide clearance: every way was tried for minutes."""
    for module in (roller, strategy):
        monkeypatch.setattr(module, "MOST_WORK", 40)
    hardly = ["operation.radial_load=1e-6 N", "bearing.clearance=3 mm"]
    result = flexbearing.run(CONFIGS / "nu209.toml", hardly)
    assert result.attributes["status"] == result.attributes["ending"] == "work limit"
    assert "work limit after" in result.attributes["message"]


def test_settling_cage_and_spins_ends_with_its_evaluations_of_contacts(monkeypatch):
    monkeypatch.setattr(settled_time, "MOST_CONTACTS", 3)
    balance = paper_bearing().balance()
    assert settled_time.through_settled_time(balance, static_start(balance)).unknowns is None


def test_forces_that_are_not_finite_are_named_without_nan():
    result = flexbearing.run(PAPER.parent / "catalogue" / "nu210.toml", ["operation.radial_load=1e9 N"])
    message = result.attributes["message"]
    assert "without finite forces" in message
    assert "nan" not in message


def test_a_ring_that_is_held_in_every_direction_ends_by_name():
    """Where the search follows the inertia of the balls, no displacement is left to be found."""
    held = ["operation.displacement.radial_y=1000 um"]
    result = flexbearing.run(PAPER.parent / "strain_wave.toml", held)
    assert result.attributes["status"] == "not solved"
