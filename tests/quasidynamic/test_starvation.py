"""Starved contacts: printed numbers, limits, derivatives."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.contact.film import Film
from quasidynamic.contact.film.thickness import (
    FIT_ENDS,
    meniscus_factor,
    starved_film,
)

RADIUS, MODULUS = 2.32e-3, 2.2487e11  # [m], [Pa]

widths = st.floats(1e-5, 3e-4)  # [m]
films = st.floats(2e-8, 3e-6)  # [m]
lengths = st.floats(1e-3, 0.3)  # [-]


def group(width, film):
    return (width**2 / (2 * film * RADIUS)) ** (2 / 3)


def factor_at(xi):
    """b^2/(2 h R) = 1, so that xi is the inlet length."""
    return meniscus_factor(np.array(1e-4), np.array(1e-6), 5e-3, xi)


def test_printed_numbers_of_the_meniscus_formula():
    """xi = 0.1, 0.5, 1, 2, 4, to the four digits printed."""
    found = [float(factor_at(xi).factor) for xi in (0.1, 0.5, 1.0, 2.0, 4.0)]
    assert found == approx([0.2138, 0.5764, 0.7621, 0.9000, 0.9684], abs=6e-5)


def test_meniscus_group_has_the_power_two_thirds():
    """b^2/(2 h R) = 8 makes xi = 4 c_s."""
    found = meniscus_factor(np.array(8**0.5 * 1e-4), np.array(1e-6), 5e-3, 0.5)
    assert found.factor == approx(0.9000, abs=6e-5)


def test_starvation_grows_from_a_dry_to_a_flooded_inlet():
    factors = np.array([float(factor_at(xi).factor) for xi in np.geomspace(1e-6, 7.999, 200)])
    assert np.all(np.diff(factors) > 0)
    assert factors[0] < 1e-4
    assert factors[-1] < 1.0


def test_film_is_continuous_where_the_fit_ends():
    """The source lets it jump by 0.9 %: a contact there had no equilibrium on either side."""
    below, above = factor_at(FIT_ENDS * (1 - 1e-9)), factor_at(FIT_ENDS * (1 + 1e-9))
    assert 1.0 - below.factor == approx(8.745e-3, rel=1e-3)
    assert above.factor == approx(below.factor, abs=1e-10)
    assert above.by_half_width == approx(below.by_half_width, rel=1e-6)
    assert factor_at(20.0).factor == approx(1.0, abs=2e-3)


def test_very_wet_inlet_is_flooded():
    assert factor_at(1e200).factor == 1.0


@given(width=widths, film=films, length=lengths)
def test_meniscus_derivatives_against_differences(width, film, length):
    def factor(b, h):
        return float(meniscus_factor(np.array(b), np.array(h), RADIUS, length).factor)

    _, by_film, by_width = meniscus_factor(np.array(width), np.array(film), RADIUS, length)
    step = 1e-5
    film_slope = (factor(width, film * (1 + step)) - factor(width, film * (1 - step))) / (2 * step)
    width_slope = (factor(width * (1 + step), film) - factor(width * (1 - step), film)) / (2 * step)
    assert by_film * film == approx(film_slope, rel=1e-6, abs=1e-9)
    assert by_width * width == approx(width_slope, rel=1e-6, abs=1e-9)


def power_law_film(q, slide, u):
    """A film that falls with load and sliding and rises with entrainment, with its derivatives."""
    h = 1e-7 * (q / 1e5) ** -0.13 * (u / 50) ** 0.7 * np.exp(-0.02 * slide)
    return Film(h, -0.13 * h / q, -0.02 * h, 0.7 * h / u)


@pytest.mark.parametrize("length", [0.02, 0.1, 0.2])
def test_starved_film_is_differentiated_by_load_sliding_and_entrainment(length):
    point = [np.array([2e4, 1e5, 3e5]), np.array([1.0, 5.0, 20.0]), np.array([20.0, 60.0, 100.0])]

    def starved(q, slide, u):
        return starved_film(power_law_film(q, slide, u), q, RADIUS, MODULUS, length)

    exact = starved(*point)
    for axis, slope in enumerate(exact[1:]):
        step = 1e-5 * point[axis]
        up, down = (
            starved(*[v + s * step if k == axis else v for k, v in enumerate(point)]) for s in (1, -1)
        )
        assert slope == approx((up.thickness - down.thickness) / (2 * step), rel=1e-6, abs=0)


def test_flooded_film_passes_through_unchanged():
    q, slide, u = np.array([1e5]), np.array([1.0]), np.array([50.0])
    flooded = power_law_film(q, slide, u)
    for starved, full in zip(starved_film(flooded, q, RADIUS, MODULUS, 1e12), flooded, strict=True):
        assert starved == approx(full, rel=1e-15, abs=0)


def test_arrays_broadcast():
    found = meniscus_factor(np.full((3, 4), 1e-4), np.full((3, 4), 1e-6), np.full((3, 1), 5e-3), 1.0)
    assert all(part.shape == (3, 4) for part in found)
