"""Designs that are searched on a cheap model, and constraints that are met on a finer one."""

from functools import partial
from math import exp

import numpy as np
import pytest

from flexbearing.case import BadCase
from flexbearing.optimise.answer import Optimum
from flexbearing.optimise.correction import Correction
from flexbearing.optimise.evaluations import Workers
from flexbearing.optimise.run import optimise
from flexbearing.optimise.search import FEASIBLE, End
from flexbearing.optimise.worker import slope_name
from flexbearing.studies.plan import Row
from flexbearing.studies.run import Work
from tests.flexbearing.toy_studies import CASE, no_ring

pytestmark = pytest.mark.usefixtures("two_cores")

LIFE, SLIP = "life_L10 [Mrev]", "cage_slip [%]"
CHEAP, USUAL, FINE = 10, 20, 40  # slices
FILE = f"""
case = "{CASE}"
[set]
"accuracy.slices" = {USUAL}
[vary]
"bearing.clearance" = "0 um .. 60 um"
"bearing.roller.drop" = "1 um .. 20 um"
[maximise]
output = "life_L10 [Mrev]"
[constrain]
cage_slip = "<= 6 %"
"""
SURROGATE = f'[surrogate]\n"accuracy.slices" = {CHEAP}\n'
VERIFY = f'[[verify]]\n"accuracy.slices" = {FINE}\n'


def usual(x, y):
    """Logarithm of the life, slip [%], and their derivatives by both keys [um]."""
    life = -((x - 30) ** 2) / 400 - (y - 5) ** 2 / 9
    return life, x / 10 + y, (-(x - 30) / 200, -2 * (y - 5) / 9), (0.1, 1.0)


def cheap(x, y):
    """Another summit, another width, too little slip."""
    life = -((x - 42) ** 2) / 300 - (y - 7) ** 2 / 16
    return life, x / 14 + 0.7 * y, (-(x - 42) / 150, -(y - 7) / 8), (1 / 14, 0.7)


def narrow(x, y):
    """A summit so narrow and far away that steps of the corrected model are too long, and refused."""
    life = (x - 42) ** 2 / 900 - (y - 7) ** 2 / 100
    return life, x / 14 + 0.7 * y, ((x - 42) / 450, -(y - 7) / 50), (1 / 14, 0.7)


def fine(x, y):
    """As usual, with more slip."""
    life, slip, by_life, by_slip = usual(x, y)
    return life, 1.02 * slip + 0.001 * x, by_life, by_slip


def models(task, keys=None, *, surrogate=cheap):
    """Rows with slopes by both keys, each by the model that its slices name."""
    found = []
    for variant in task.variants:
        values = dict(zip(task.base.keys, variant.in_si, strict=True))
        x, y = 1e6 * values["bearing.clearance"], 1e6 * values["bearing.roller.drop"]
        model = {CHEAP: surrogate, USUAL: usual, FINE: fine}[int(values["accuracy.slices"])]
        life, slip, by_life, by_slip = model(x, y)
        numbers = {LIFE: exp(life), SLIP: slip}
        for place, key in enumerate(keys or ()):
            numbers[slope_name(LIFE, key)] = 1e6 * exp(life) * by_life[place]
            numbers[slope_name(SLIP, key)] = 1e6 * by_slip[place]
        found.append(Row(variant.identity, "converged", "", 0.1, numbers))
    return found


def found(folder, text, surrogate=cheap) -> Optimum:
    """The optimum of a file with these models."""
    file = folder / "hill.toml"
    file.write_text(FILE + text)
    work = partial(models, surrogate=surrogate)
    workers = Workers(Work(work, no_ring), lambda keys: Work(partial(work, keys=keys), no_ring))
    return optimise(file, folder / "out", work=lambda problem, folder: workers)


def on_slip(limit):
    """Where the life of the usual model is longest on x / 10 + y = limit, and the gain of 1 % more."""
    rate = (30 / 10 + 5 - limit) / (200 / 10**2 + 4.5)
    return (30 - 20 * rate, 5 - 4.5 * rate), rate


@pytest.mark.parametrize("surrogate", [cheap, narrow])
def test_surrogate_leads_to_the_optimum_of_the_case(tmp_path, surrogate):
    optimum = found(tmp_path, SURROGATE + "[search]\nstarts = 1", surrogate)
    point, rate = on_slip(6)
    assert optimum.converged
    assert optimum.best.point == pytest.approx(point, rel=2e-3)
    (active,) = optimum.active
    assert active.gain == pytest.approx(rate, rel=3e-3)
    assert optimum.cheap > optimum.designs


def test_case_is_computed_a_few_times(tmp_path):
    """Three or four designs of the case where the search without a surrogate takes more."""
    with_surrogate = found(tmp_path, SURROGATE + "[search]\nstarts = 1")
    (tmp_path / "without").mkdir()
    without = found(tmp_path / "without", "[search]\nstarts = 1")
    assert with_surrogate.designs < without.designs
    assert with_surrogate.best.point == pytest.approx(without.best.point, rel=2e-3)


def test_further_starts_end_at_the_optimum_that_is_known(tmp_path):
    optimum = found(tmp_path, SURROGATE + "[search]\nstarts = 3")
    assert len(optimum.agreeing) == 3
    assert sorted(each.iterations for each in optimum.starts)[:2] == [0, 0]  # no further design of the case
    assert len({each.start for each in optimum.starts}) == 3


def test_limit_of_designs_of_the_case_is_not_convergence(tmp_path):
    optimum = found(tmp_path, SURROGATE + "[search]\nstarts = 1\niterations = 1")
    assert optimum.best.end is End.LIMIT
    assert optimum.best.iterations == 1


@pytest.mark.parametrize("surrogate", [SURROGATE, ""])
def test_constraints_are_met_as_verified(tmp_path, surrogate):
    """Slip of the fine model is 1.02 (x / 10 + y) + 0.001 x, so that the usual one has less than 6 %."""
    optimum = found(tmp_path, f"{surrogate}[search]\nstarts = 1\nverified = true\n{VERIFY}")
    ((_, verified),) = optimum.verified
    assert optimum.converged
    assert verified.missed <= FEASIBLE
    assert verified.bounds == pytest.approx((6.0,), rel=1e-3)  # as good as used up
    point, _ = on_slip((6 - 0.001 * optimum.best.point[0]) / 1.02)
    assert optimum.best.point == pytest.approx(point, rel=3e-3)


def test_constraints_that_the_finer_model_misses_are_told(tmp_path):
    optimum = found(tmp_path, f"{SURROGATE}[search]\nstarts = 1\n{VERIFY}")
    ((_, verified),) = optimum.verified
    assert verified.missed > 0.01


def test_correction_has_values_and_slopes_of_the_case_at_one_design():
    """Also where both models differ in sign: then their difference is added."""
    cheap_there = np.array([2.0, -1.0]), np.array([[0.5, -1.0], [0.2, 0.3]])
    case_there = np.array([3.0, 0.5]), np.array([[0.1, 0.4], [-0.7, 0.1]])
    correction = Correction.between(cheap_there[0], case_there[0], (cheap_there[1], case_there[1]))
    values, slopes = correction.applied(np.zeros(2), *cheap_there)
    np.testing.assert_allclose(values, case_there[0])
    np.testing.assert_allclose(slopes, case_there[1])


def test_slopes_of_a_correction_are_those_of_its_values():
    generator, step, small = np.random.default_rng(1), np.array([0.3, -0.2]), 1e-6
    cheap_there, case_there = (
        (np.array([2.0, sign]), generator.standard_normal((2, 2))) for sign in (1.0, -1.0)
    )
    correction = Correction.between(cheap_there[0], case_there[0], (cheap_there[1], case_there[1]))

    def values(s):
        return correction.applied(s, np.array([1.5, 0.4]) + np.array([[0.2, 0.9], [0.1, -0.5]]) @ s, None)[0]

    at = np.array([1.5, 0.4]) + np.array([[0.2, 0.9], [0.1, -0.5]]) @ step
    _, slopes = correction.applied(step, at, np.array([[0.2, 0.9], [0.1, -0.5]]))
    for place, unit in enumerate(np.eye(2) * small):
        difference = (values(step + unit) - values(step - unit)) / (2 * small)
        np.testing.assert_allclose(slopes[:, place], difference, rtol=1e-7)


WRONG = {
    "[search]\nverified = true": "search.verified needs [[verify]]",
    '[surrogate]\n"accuracy.slicez" = 3': "[surrogate] ",
    '[surrogate]\n"bearing.clearance" = "1 um"': "is given in [surrogate], too",
}


@pytest.mark.parametrize(("text", "words"), WRONG.items())
def test_mistakes_are_told_with_their_place(tmp_path, text, words):
    with pytest.raises(BadCase) as told:
        found(tmp_path, text)
    assert words in str(told.value)
