"""Quantiles, Sobol indices and linear predictions of functions whose answers are known."""

import tracemalloc
from math import pi

import numpy as np
import pytest
from pytest import approx
from scipy import stats

from flexbearing.sampling.distribution import (
    lognormal,
    normal,
    quantile,
    truncated_normal,
    uniform,
    weighted_quantile,
)
from flexbearing.sampling.indices import sobol_indices
from flexbearing.sampling.linear import Linear, explained, is_skewed
from flexbearing.sampling.points import Design

UNIFORM = uniform(-pi, pi)
ISHIGAMI = (0.3139, 0.4424, 0.0), (0.5576, 0.4424, 0.2437)  # first and total of a = 7, b = 0.1: Saltelli 2008
SLOPES, WIDTHS = np.array([1.0, 2.0, -3.0]), (1, 2)  # the last two are the numbers of one list


def ishigami(points):
    x, y, z = UNIFORM.quantile(points).T
    return np.sin(x) + 7 * np.sin(y) ** 2 + 0.1 * z**4 * np.sin(x)


def indices_of(function, count, seed, widths=(1, 1, 1)):
    points = Design("sobol_indices", count, seed).points(widths)[:]
    return sobol_indices(function(points).reshape(count, -1), seed)


def test_indices_of_the_function_of_ishigami_lie_within_their_confidence():
    found = indices_of(ishigami, 1024, 3)
    for values, interval, exact in (
        (found.first, found.first_interval, ISHIGAMI[0]),
        (found.total, found.total_interval, ISHIGAMI[1]),
    ):
        assert values == approx(np.array(exact), abs=0.02)
        assert (interval[0] <= exact).all()
        assert (exact <= interval[1]).all()
        assert np.ptp(interval, axis=0).max() < 0.25


def test_lists_are_one_input_of_a_linear_function():
    """Shares of a sum are the squares of its slopes, and a list has those of all its numbers."""
    found = indices_of(lambda points: points @ SLOPES, 2048, 1, WIDTHS)
    assert found.first == approx(np.array([1, 13]) / 14, abs=0.01)
    assert found.total == approx(np.array([1, 13]) / 14, abs=0.01)


def test_indices_are_those_of_scipy():
    values = ishigami(Design("sobol_indices", 64, 5).points((1, 1, 1))[:]).reshape(64, 5)
    a, b, mixed = values[:, 0], values[:, 1], values[:, 2:].T[:, None]
    scipy = stats.sobol_indices(func={"f_A": a[None], "f_B": b[None], "f_AB": mixed}, n=64)
    found = sobol_indices(values, 0)
    assert found.first == approx(scipy.first_order.ravel(), rel=1e-12, abs=1e-12)
    assert found.total == approx(scipy.total_order.ravel(), rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("method", ["latin_hypercube", "sobol"])
def test_points_are_those_of_scipy_in_four_bytes_a_number(method):
    engine = {"latin_hypercube": stats.qmc.LatinHypercube, "sobol": stats.qmc.Sobol}[method]
    points, expected = Design(method, 512, 7).points((3, 2)), engine(5, seed=7).random(512)
    assert np.array_equal(points[:], expected)
    assert np.array_equal(points[100:130], expected[100:130])
    tracemalloc.start()
    made = Design(method, 2**14, 7).points((14,))
    size, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert size < 4.1 * 14 * len(made)


def test_points_with_a_row_without_answer_are_left_out_and_counted():
    values = ishigami(Design("sobol_indices", 256, 5).points((1, 1, 1))[:]).reshape(256, 5)
    torn = values.copy()
    torn[[3, 100], [0, 4]] = np.nan
    found, kept = sobol_indices(torn, 2), sobol_indices(np.delete(values, [3, 100], axis=0), 2)
    assert found.points == 254
    assert found.total_interval == approx(kept.total_interval, rel=1e-12, abs=1e-15)


@pytest.mark.slow
def test_confidence_covers_the_indices_over_seeds():
    """Points of a Sobol sequence err less than the drawn ones that the bootstrap stands for."""
    inside = []
    for seed in range(60):
        found = indices_of(ishigami, 256, seed)
        for exact, interval in zip(ISHIGAMI, (found.first_interval, found.total_interval), strict=True):
            inside += [*((interval[0] <= exact) & (exact <= interval[1]))]
    assert np.mean(inside) >= 0.93


DISTRIBUTIONS = {
    "uniform": uniform(2, 5),
    "normal": normal(3, 0.5),
    "truncated": truncated_normal(3, 0.5, 2.2, 4.5),
    "truncated beside its mean": truncated_normal(1, 0.5, 2.0, 4.5),
    "lognormal": lognormal(3, 1.4),
}


@pytest.mark.parametrize("law", DISTRIBUTIONS.values(), ids=DISTRIBUTIONS.keys())
def test_weights_make_drawn_values_those_of_half_the_spread(law):
    """Each quantile then is half as far from the centre, as a difference or as a factor."""
    values = law.quantile((np.arange(200_000) + 0.5) / 200_000)
    weights = law.halving_weights(values)
    assert weights.mean() == approx(1, abs=1e-3)
    assert 0 <= weights.min() <= weights.max() <= 2 + 1e-9
    for probability in (0.1, 0.5, 0.9):
        wide = law.quantile(np.array(probability))
        narrow = np.sqrt(law.centre * wide) if law.logarithmic else (law.centre + wide) / 2
        assert weighted_quantile(values, weights, probability) == approx(narrow, rel=2e-4)


@pytest.mark.parametrize("probability", [0.1, 0.5, 0.9])
def test_quantiles_of_a_known_distribution_lie_within_their_confidence(probability):
    exact = stats.norm.ppf(probability)
    inside = 0
    for seed in range(40):
        drawn = np.random.default_rng(seed).normal(size=400)
        found = quantile(drawn, 0, probability)
        inside += found.low <= exact <= found.high
        assert found.low <= found.value <= found.high
    assert inside >= 35  # of 38 expected; fewer in 1 of 40 trials


def test_rows_without_an_answer_widen_the_interval_by_all_they_could_be():
    drawn = np.random.default_rng(1).normal(size=400)
    worst = np.sort(drawn)[:12]
    for some in (drawn[drawn > worst.max()], drawn[drawn < np.sort(drawn)[-12]]):
        found = quantile(some, 12, 0.5)
        assert found.low <= quantile(drawn, 0, 0.5).low
        assert found.high >= quantile(drawn, 0, 0.5).high


def test_too_few_rows_tell_no_end_of_the_interval():
    found = quantile(np.arange(10.0), 0, 0.1)
    assert found.low == -np.inf
    assert np.isfinite(found.high)


def test_linear_prediction_of_a_linear_function_is_exact():
    laws = uniform(2, 5), normal(1, 0.3), lognormal(2, 1.5)
    means, deviations = (np.array([getattr(law, name) for law in laws]) for name in ("mean", "deviation"))
    linear = Linear(float(4 + means @ SLOPES), SLOPES, means, deviations)
    points = Design("sobol", 4096, 0).points((1, 1, 1))[:]
    numbers = np.array([law.quantile(column) for law, column in zip(laws, points.T, strict=True)]).T
    values = 4 + numbers @ SLOPES
    assert linear.at(numbers) == approx(values, rel=1e-12)
    assert explained(values, linear.at(numbers)) == approx(1, abs=1e-12)
    assert linear.value == approx(values.mean(), rel=1e-3)
    assert linear.deviation == approx(values.std(), rel=5e-3)


def test_a_skewed_output_above_zero_is_predicted_by_its_logarithm():
    numbers = np.random.default_rng(0).normal(0, 1, (20_000, 1))
    lives = 50 * np.exp(1.5 * numbers[:, 0])
    slope, zero, one = np.array([75.0]), np.zeros(1), np.ones(1)
    assert is_skewed(lives)
    assert not is_skewed(lives - 50)
    assert not is_skewed(100 + numbers[:, 0])
    plain, linear = (Linear(50.0, slope, zero, one, logarithmic=of) for of in (False, True))
    assert plain.at(numbers).min() < 0
    assert linear.at(numbers) == approx(lives)
    assert linear.mean == approx(lives.mean(), rel=0.05)
    assert linear.deviation == approx(lives.std(), rel=0.2)
    wide = Linear(50.0, 100 * slope, zero, one, logarithmic=True)
    assert (wide.mean, wide.at(np.full((1, 1), 9.0))[0]) == (np.inf, np.inf)
