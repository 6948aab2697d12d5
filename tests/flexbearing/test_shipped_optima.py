"""The shipped optimisation files: each finds an optimum that stands up to finer models."""

import pytest

from flexbearing.optimise.run import optimise
from flexbearing.optimise.search import FEASIBLE
from tests.places import CONFIGS

pytestmark = pytest.mark.usefixtures("two_cores")

STUDIES = CONFIGS / "studies"


@pytest.mark.long
def test_profile_of_a_misaligned_bearing_beats_the_logarithmic_one(tmp_path):
    """In life at the worst slope; with 20 slices, 200 slices, and both contacts on half-spaces."""
    optimum = optimise(STUDIES / "optimum_profile.toml", tmp_path)
    assert optimum.converged
    assert len(optimum.agreeing) == len(optimum.starts)
    assert optimum.measured.objective > 1.2 * optimum.case.objective
    (sliced, finer), (standard, whole) = optimum.verified
    assert finer.objective > 1.2 * sliced.objective
    assert whole.objective > 1.1 * standard.objective


@pytest.mark.long
def test_cage_of_least_mass_meets_its_constraints_on_a_finer_model(tmp_path):
    """Searched on a beam; stiffness, stress and life as elements of order 4 have them."""
    optimum = optimise(STUDIES / "optimum_cage.toml", tmp_path)
    assert optimum.converged
    ((case, finer),) = optimum.verified
    assert finer.missed <= FEASIBLE < case.missed
    assert finer.objective < 0.95 * case.objective
    assert any("support_stiffness <=" in each.words for each in optimum.active)
    assert optimum.designs < optimum.cheap


@pytest.mark.long
def test_planet_has_an_optimum_of_clearance_and_out_of_round(tmp_path):
    """Harris and Broschard (1964): the major axis along the tooth forces, a life some 40 % longer."""
    optimum = optimise(STUDIES / "optimum_planet.toml", tmp_path)
    assert optimum.converged
    assert optimum.active == ()
    amplitude, clearance = optimum.best.point
    assert 20 < amplitude < 75  # [um], crests along the load of the pin
    assert 10 < clearance < 110  # [um]
    assert optimum.measured.objective > 1.25 * optimum.case.objective
