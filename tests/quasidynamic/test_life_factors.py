"""Life factors: the printed numbers, their limits, and what is never applied in silence."""

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic.errors import OutOfRange
from quasidynamic.outcome.life_factors import (
    BALLS,
    CLEANLINESS,
    FILM_FACTORS,
    FILM_RATIOS,
    ROLLERS,
    LifeFactor,
    ModifiedLife,
    contamination_factor,
    film_factor,
    material_factor,
    modification_factor,
    modification_slope,
    reference_viscosity,
    reliability_factor,
    viscosity_ratio,
)

RPM = 2 * np.pi / 60
PITCH = 70e-3  # [m]
KAPPAS = st.floats(0.1, 4.0)


def test_reference_viscosity_of_the_paper_bearing():
    """38000 1/min on 70 mm: 2.760 mm2/s; 1.355 mm2/s of oil make 0.49 of it."""
    assert reference_viscosity(38000 * RPM, PITCH) == approx(2.760e-6, rel=1e-3)
    assert reference_viscosity(-38000 * RPM, PITCH) == reference_viscosity(38000 * RPM, PITCH)
    assert viscosity_ratio(1.355e-6, 38000 * RPM, PITCH) == approx(0.49, abs=5e-3)


def test_reference_viscosity_has_a_slow_and_a_fast_branch():
    """45000 n^-0.83 D^-0.5 below 1000 1/min, 4500 n^-0.5 D^-0.5 from there on."""
    slow, below, above = reference_viscosity(np.array([100, 999.999, 1000.001]) * RPM, 100e-3)
    assert slow == approx(4500 * 100**-0.83 * 1e-6, rel=1e-12)
    assert above == approx(450 * 1000**-0.5 * 1e-6, rel=1e-5)
    assert below / above == approx(1.0233, rel=1e-3)
    with pytest.raises(OutOfRange, match="at rest"):
        reference_viscosity(0.0, PITCH)


@pytest.mark.parametrize(
    ("kappa", "factors"),
    [
        (0.4, [0.138, 0.154, 0.197, 0.307]),
        (0.49, [0.163, 0.191, 0.279, 0.560]),
        (1.0, [0.280, 0.399, 0.945, 5.311]),
        (2.0, [0.337, 0.516, 1.474, 12.93]),
    ],
    ids=str,
)
def test_modification_factor_of_roller_bearings(kappa, factors):
    """At e_C C_u/P of 0.05, 0.1, 0.3 and 1, computed once by hand from the equations of ISO 281."""
    found = modification_factor(kappa, np.array([0.05, 0.1, 0.3, 1.0])).value
    assert found == approx(factors, rel=5e-4, abs=5e-4)


@pytest.mark.parametrize("kappa", [0.4, 1.0])
def test_bands_of_the_viscosity_ratio_meet(kappa):
    """The printed constants close the bands to the fourth digit."""
    below, above = (modification_factor(k, 0.5).value for k in (kappa * (1 - 1e-9), kappa))
    assert below == approx(above, rel=1e-3)


@given(KAPPAS, KAPPAS, st.floats(0.0, 10.0), st.floats(0.0, 10.0))
def test_more_film_and_less_load_never_shorten_the_life(kappa, other, ratio, more):
    thin, thick = sorted((kappa, other))
    low, high = sorted((ratio, more))
    assert modification_factor(thick, high).value >= modification_factor(thin, low).value * (1 - 2e-3)


def test_modification_factor_says_where_it_was_held():
    assert modification_factor(1.0, 0.1).note == ""
    held = modification_factor(7.0, 0.1)
    assert held.value == modification_factor(4.0, 0.1).value
    assert "rated as 4" in held.note
    high = modification_factor(4.0, np.array([0.1, 1e3]))
    assert high.value[1] == approx(50.0, rel=1e-12)
    assert "limit of 50" in high.note
    assert modification_factor(4.0, 0.0).value == approx(0.1, rel=1e-12)


@pytest.mark.parametrize("kappa", [0.0999, 0.0, -1.0, float("nan")])
def test_too_thin_an_oil_is_refused(kappa):
    with pytest.raises(OutOfRange, match="viscosity ratio"):
        modification_factor(kappa, 0.1)
    with pytest.raises(OutOfRange, match="viscosity ratio"):
        contamination_factor(np.array([1.0, kappa]), PITCH, CLEANLINESS["grease, normal cleanliness"])


def test_negative_load_ratio_is_refused():
    with pytest.raises(OutOfRange, match="negative"):
        modification_factor(1.0, -0.1)


def test_contamination_factor_in_full_and_limited():
    """In-line filter -/15/12, c = 0.0432 and 0.9987, on 70 mm."""
    clean = CLEANLINESS["oil, in-line filter, -/15/12"]
    left = 1 - 0.9987 / 70 ** (1 / 3)
    expected = 0.0432 * 0.5**0.68 * 70**0.55 * left
    assert contamination_factor(0.5, PITCH, clean) == approx(expected, rel=1e-12)
    assert contamination_factor(4.0, PITCH, clean) == approx(left, rel=1e-12)
    dirty = CLEANLINESS["oil, no or off-line filter, -/21/18"]
    assert contamination_factor(9.0, PITCH, dirty) == contamination_factor(4.0, PITCH, dirty)
    with pytest.raises(OutOfRange, match=r"more than 59\.2 mm"):
        contamination_factor(1.0, 50e-3, dirty)


@given(KAPPAS, st.floats(70e-3, 2.0), st.sampled_from(sorted(CLEANLINESS)))
def test_contamination_leaves_a_share(kappa, pitch, name):
    assert 0 < contamination_factor(kappa, pitch, CLEANLINESS[name]) < 1


@pytest.mark.parametrize("family", ["oil, in-line", "oil, no or off-line", "grease"])
def test_dirt_never_lengthens_the_life(family):
    """Each class of a family leaves no more than the one before it."""
    factors = [
        contamination_factor(0.5, PITCH, c) for name, c in CLEANLINESS.items() if name.startswith(family)
    ]
    assert len(factors) in (4, 5)
    assert all(cleaner > dirtier for cleaner, dirtier in pairwise(factors))


def test_film_factor_is_the_table_and_linear_between():
    printed = {0.6: 0.19, 0.8: 0.28, 1: 0.47, 1.1: 1, 1.5: 1.75, 2: 2.13, 3: 2.46, 4: 2.62, 6: 2.83, 8: 2.88}
    for ratio, factor in {**printed, 10: 3.03}.items():
        assert film_factor(ratio).value == approx(factor, rel=1e-12)
        assert film_factor(ratio).note == ""
    assert film_factor(np.array([0.7, 2.5])).value == approx([0.235, 2.295], rel=1e-12)
    assert len(FILM_RATIOS) == len(FILM_FACTORS) == 11


def test_film_factor_outside_the_table_is_held_and_said_so():
    thin, thick = film_factor(0.2), film_factor(np.array([1.0, 12.0]))
    assert thin.value == approx(0.19, rel=1e-12)
    assert "below 0.6" in thin.note
    assert thick.value[1] == approx(3.03, rel=1e-12)
    assert "above 10" in thick.note
    for ratio in (-0.1, float("nan")):
        with pytest.raises(OutOfRange, match="film ratio"):
            film_factor(ratio)


def test_material_factor_takes_the_rating_factor_out_again():
    """M50 2, VIM-VAR 6; capacities with b_m = 1.1 hold 1.1^4 of it."""
    assert material_factor("M50", "VIM-VAR").value == approx(12 / 1.1**4, rel=1e-12)
    assert material_factor("52100", "air", process=1.2, rating_factor=1.0).value == approx(3.6, rel=1e-12)
    assert material_factor("M50NiL", "VAR").value == approx(4 * 3 / 1.4641, rel=1e-12)
    assert "VIM-VAR 6" in material_factor("M50", "VIM-VAR").note
    with pytest.raises(OutOfRange, match="Did you mean M50NiL"):
        material_factor("M50-NiL", "VAR")
    with pytest.raises(OutOfRange, match="melting"):
        material_factor("M50", "vacuum")


@pytest.mark.parametrize(
    ("reliability", "factor"),
    [(0.90, 1), (0.95, 0.64), (0.96, 0.55), (0.97, 0.47), (0.98, 0.37), (0.99, 0.25), (0.995, 0.175)],
    ids=str,
)
def test_reliability_factor_is_the_table_of_iso281(reliability, factor):
    assert reliability_factor(reliability).value == approx(factor, abs=6e-3)


@pytest.mark.parametrize("reliability", [0.5, 0.9996, 1.0, 99.0, float("nan")])
def test_reliability_outside_the_table_is_refused(reliability):
    with pytest.raises(OutOfRange, match="probability"):
        reliability_factor(reliability)


@given(st.floats(1e-3, 1e6), st.floats(0.6, 10.0), st.floats(0.9, 0.9995))
def test_modified_life_is_the_product_of_all_it_names(basic, film, reliability):
    factors = (film_factor(film), material_factor("M50", "VAR"), reliability_factor(reliability))
    modified = ModifiedLife(basic, factors)
    expected = basic * factors[0].value * factors[1].value * factors[2].value
    assert modified.life == approx(expected, rel=1e-12)
    assert [factor.name for factor in modified.factors] == ["film", "material", "a_1"]


def test_life_without_factors_is_the_basic_one_and_cases_stack():
    assert ModifiedLife(1.5).life == 1.5
    stacked = ModifiedLife(np.array([1.0, np.inf]), (film_factor(np.array([1.1, 2.0])),)).life
    assert stacked == approx([1.0, np.inf], rel=1e-12)


def test_lubrication_is_not_counted_twice():
    with pytest.raises(OutOfRange, match="a_ISO, film account for the same lubrication"):
        ModifiedLife(1.0, (modification_factor(1.0, 0.1), film_factor(1.5)))


@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf")])
def test_impossible_factor_is_refused(value):
    with pytest.raises(OutOfRange, match="above zero"):
        LifeFactor("a", value, "material")


@pytest.mark.parametrize("elements", [ROLLERS, BALLS], ids=["rollers", "balls"])
@pytest.mark.parametrize("kappa", [0.2, 0.7, 2.0])
def test_slope_of_a_iso_is_its_derivative(elements, kappa):
    ratio, step = 0.2, 1e-5
    above, below = (
        modification_factor(kappa, ratio * np.exp(each), elements).value for each in (step, -step)
    )
    assert modification_slope(kappa, ratio, elements) == approx(np.log(above / below) / (2 * step), rel=1e-7)


def test_held_at_its_limit_a_iso_has_no_slope():
    assert modification_factor(4.0, 5.0).value == approx(50.0, rel=1e-12)
    assert modification_slope(np.array([4.0, 1.0]), np.array([5.0, 0.0])).tolist() == [0.0, 0.0]
