"""Roughness: composite height, lambda, regime."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.contact.film import composite_roughness, lambda_ratio, regime
from quasidynamic.errors import OutOfRange

heights = st.floats(1e-9, 1e-5)  # [m]


@pytest.mark.parametrize(
    ("roughness", "expected"),
    [(0.05e-6, 1.65), (0.10e-6, 0.82), (0.20e-6, 0.41)],
    ids=["fine", "usual", "coarse"],
)
def test_lambda_of_the_high_speed_roller(roughness, expected):
    """Film 0.1163 um (Dowson 1968, inner raceway, 3537 N), both surfaces alike: two printed digits."""
    assert lambda_ratio(0.1163e-6, composite_roughness(roughness, roughness)) == approx(expected, abs=0.006)


@given(first=heights, second=heights)
def test_composite_roughness_is_symmetric_and_between_its_bounds(first, second):
    composite = float(composite_roughness(first, second))
    assert composite == float(composite_roughness(second, first))
    assert max(first, second) <= composite <= (first + second) * (1 + 1e-15)
    assert composite**2 == approx(first**2 + second**2, rel=1e-12, abs=0)


@given(film=heights, first=heights, second=heights)
def test_lambda_keeps_its_value_when_all_lengths_scale(film, first, second):
    ratio = lambda_ratio(film, composite_roughness(first, second))
    assert lambda_ratio(7 * film, composite_roughness(7 * first, 7 * second)) == approx(ratio, rel=1e-12)


def test_one_smooth_surface_is_allowed_and_two_are_not():
    assert lambda_ratio(0.2e-6, composite_roughness(0.1e-6, 0.0)) == approx(2.0, rel=1e-12)
    with pytest.raises(OutOfRange, match="smooth"):
        lambda_ratio(np.array([0.2e-6, 0.2e-6]), composite_roughness(np.array([0.1e-6, 0.0]), 0.0))


def test_regime_changes_at_its_stated_bounds():
    ratio = np.array([[0.0, 0.999, 1.0], [2.999, 3.0, np.inf]])
    assert regime(ratio).tolist() == [["boundary", "boundary", "mixed"], ["mixed", "full film", "full film"]]


@pytest.mark.parametrize("wrong", [-0.1, float("nan")])
def test_impossible_lambda_has_no_regime(wrong):
    with pytest.raises(OutOfRange):
        regime(np.array([1.0, wrong]))
