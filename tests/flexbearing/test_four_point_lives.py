"""Lives of four-point bearings from case to result, turning, oscillating, and under a duty cycle."""

import numpy as np
import pytest
from pytest import approx

import flexbearing
from flexbearing.api import read_case
from flexbearing.findings import records
from flexbearing.life import four_point_lives
from flexbearing.runs import four_point
from quasidynamic.outcome.oscillation import critical_oscillation, guideline_factor
from tests.places import CONFIGS

JOSHI = CONFIGS / "joshi2015_fourpoint.toml"


@pytest.fixture(scope="module")
def balls():
    return four_point.solved(read_case(JOSHI)).balls


def lives(balls, *settings):
    found = four_point_lives.lives(read_case(JOSHI, settings), balls)
    assert found is not None
    return found


@pytest.fixture(scope="module")
def result():
    return flexbearing.run(JOSHI, ["operation.oscillation=2 deg", "life.reliability=0.95"])


def test_a_result_has_every_life_with_its_rule(result, balls):
    """a_1 is 0.64 at 95 %, by ISO 281."""
    found = lives(balls, "operation.oscillation=2 deg")
    summary = result.summary()["rigid"]
    assert summary["life_L10_Mrev"] == approx(found.basic / 1e6, rel=1e-9)
    assert summary["modified_life_Mrev"] == approx(0.64 * found.basic / 1e6, rel=0.01)
    assert summary["oscillations"] == approx(90e6 * summary["life_L10_Mrev"], rel=1e-9)
    hours = found.basic * 2 * np.pi / 3600  # at 1 rad/s
    assert float(result["life_L10 [h]"]) == approx(hours, rel=1e-9)
    assert result.attributes["life_rule"].split("; ") == [
        "ISO/TS 16281:2008 for each arc, C_a of ISO 281:2007, thrust bearings",
        "oscillation by the damage of each arc", "a_1 of ISO 281:2007",
    ]  # fmt: skip


def test_lives_of_arcs_and_rings_join_to_that_of_the_bearing(balls):
    """Weibull slope 10/9: the damages L^(-10/9) add up."""
    found = lives(balls)
    assert found.arcs.shape == (2, 2)
    for parts in (found.arcs, found.raceways):
        assert (parts ** (-10 / 9)).sum() == approx(found.basic ** (-10 / 9), rel=1e-12)


def test_the_guideline_multiplies_the_life_of_the_turning_bearing(balls):
    angle, settings = np.radians(2), ("operation.oscillation=2 deg", "life.oscillation=DG03")
    ratio = 35e-3 * np.cos(np.pi / 4) / 1.9
    assert angle < critical_oscillation(156, ratio).min()
    turning, found = lives(balls), lives(balls, *settings)
    assert found.oscillations is not None
    assert found.oscillations / turning.basic == approx(guideline_factor(angle, 156, ratio) ** 3, rel=1e-9)


def test_ratings_are_axial_from_45_deg_on_radial_when_wanted_and_given(balls):
    """A catalogue's C of another size in the file follows the formula."""
    axial, radial, given = (
        lives(balls, *settings)
        for settings in ([], ["life.rating=radial"], ["life.dynamic_rating=356090.09 N"])
    )
    assert (axial.rating, radial.rating) == approx((712180.2, 474693.2), rel=1e-6)
    assert given.basic == approx(axial.basic / 8, rel=1e-6)
    assert radial.basic / axial.basic == approx(4.7, rel=0.02)


def test_balls_of_another_material_and_too_large_rings_have_no_life(balls):
    for setting in ("materials.ball.youngs_modulus=250 GPa", "bearing.pitch_diameter=2600 mm"):
        case = read_case(JOSHI, [setting])
        assert four_point_lives.lives(case, balls) is None
        assert [note.code for note in four_point_lives.notes(case)] == ["no-life"]


def test_contacts_that_move_less_than_their_width_are_reported(balls):
    """0.689 of the width at 0.1 deg, by hand: 0.1 deg 1.9 m/4 over twice the largest semi-axis along."""
    case = read_case(JOSHI, ["operation.oscillation=0.1 deg"])
    found = four_point.judge(four_point.Solution(case, balls, None))
    (small,) = (each for each in found if each.finding.code == "small-oscillation")
    width = np.radians(0.1) * 1.9 / 4 / (2 * balls.ellipse.along.max())
    (record,) = records([small])
    assert record.broken
    assert record.value == approx(width, rel=1e-3)


@pytest.fixture(scope="module")
def cycle(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pitch")
    (folder / "study.toml").write_text(
        f'case = "{JOSHI}"\n[duty]\ntime = ["1 h", "3 h"]\n'
        '"operation.load.moment_y" = ["378833 N m", "200 kN m"]\n'
        '"operation.load.moment_z" = ["328601 N m", "0 N m"]\n"operation.speed" = ["1 rad/s", "0.5 rad/s"]\n'
        '"operation.oscillation" = ["10 deg", "2 deg"]\n[collect]\nlife = "life_L10 [Mrev]"\n'
    )
    return flexbearing.study(folder / "study.toml", folder, jobs=1)


def test_a_duty_cycle_of_oscillations_adds_the_damage_of_its_rows(cycle):
    """Shares of the way: 1 h at 1 rad/s, 3 h at 0.5 rad/s."""
    rows = np.array(cycle["life"].values)
    shares = np.array([1.0, 1.5]) / 2.5
    hours = 1e6 / (shares / rows).sum() * 2 * np.pi / 3600 / (2.5 / 4)
    assert float(cycle.cycles["life [h]"].values[0]) == approx(hours, rel=1e-6)
