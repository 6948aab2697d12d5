"""Contact laws: what holds for any load, speed and slip."""

import numpy as np
import pytest
from hypothesis import given, strategies as st
from pytest import approx

from quasidynamic import Crowned, Logarithmic, Material, OutOfRange, Straight, oil_at
from quasidynamic.contact.film.thickness import FORMULAS, FilmLaw, inlet_heating_factor
from quasidynamic.contact.line import half_width, peak_pressure, reduced_radius
from quasidynamic.contact.line.load_law import LoadLaw, iso16281, palmgren, smooth_positive
from quasidynamic.contact.traction import Regression4109, biboulet_houpert
from quasidynamic.contact.traction.rheology import Eyring
from quasidynamic.parts.oil_properties import Lubricant

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
OIL = oil_at("MIL-PRF-23699", 493.15)
PAIR = {"radius": 2.32e-3, "modulus": 2.2487e11, "length": 5e-3, "oil": OIL}
ROLLING_LAWS = [Regression4109(**PAIR), Eyring(**PAIR, limiting_ratio=0.05, eyring_stress=11.4e6)]

loads = st.floats(1.0, 2e6)  # [N/m]
slides = st.floats(-30.0, 30.0).filter(lambda u: abs(u) > 1e-6)  # [m/s]
speeds = st.floats(0.1, 200.0)  # [m/s]


@given(st.floats(-1e-3, 1e-3))
def test_rounded_gap_is_positive_and_close_to_the_sharp_one(gap):
    positive, root = smooth_positive(np.array(gap), 1e-9)
    assert 0.0 < positive <= max(gap, 0.0) + 0.51e-9
    assert 0.0 <= positive / root <= 1.0


@given(st.floats(1e-7, 1e-3))
def test_load_law_and_its_inverse(approach):
    law = LoadLaw(palmgren(STEEL, STEEL, 10e-3), 1e-9)
    load, slope = law(np.array(approach))
    assert law.approach(load) == approx(approach, rel=1e-3)
    assert slope == approx(10 / 9 * load / approach, rel=1e-2)


def test_palmgren_of_steel_is_the_handbook_form():
    """delta = 3.84e-5 Q^0.9 / l^0.8 (N, mm) for both bodies of steel."""
    load = palmgren(STEEL, STEEL, 10e-3) * 10e-6 ** (10 / 9)
    assert load * 10e-3 == approx((10e-3 * 10**0.8 / 3.84e-5) ** (1 / 0.9), rel=0.01)


def test_iso_law_shares_the_approach_between_both_raceways():
    """Q = 35948 l^(8/9) delta^(10/9) (N, mm) for the two approaches together."""
    load = iso16281(8e-3) * 15e-6 ** (10 / 9)
    assert load * 8e-3 == approx(35948 * 8 ** (8 / 9) * 0.030 ** (10 / 9), rel=1e-3)


@pytest.mark.parametrize("law", ROLLING_LAWS, ids=["regression", "eyring"])
@given(load=loads, slide=slides, speed=speeds)
def test_traction_follows_the_sliding_and_is_odd(law, load, slide, speed):
    film = np.array(0.12e-6)
    forward, backward = (law(np.array(load), np.array(u), np.array(speed), film) for u in (slide, -slide))
    assert np.sign(forward.force) == np.sign(slide)
    assert forward.force == approx(-backward.force, rel=1e-12)
    assert forward.by_sliding == approx(backward.by_sliding, rel=1e-12)


@given(load=loads, slide=slides, speed=speeds)
def test_eyring_traction_stays_below_the_limiting_stress(load, slide, speed):
    force = ROLLING_LAWS[1](np.array(load), np.array(slide), np.array(speed), np.array(0.12e-6)).force
    assert abs(force) <= 0.05 * load * (1 + 1e-12)


def test_regression_at_the_published_point():
    """60 degC, 50 N, 20 m/s, 7.5 mPa s, R 10 mm, k 0.0966: mu at S = 0.005 ... 0.2."""
    oil = Lubricant(
        temperature=333.15, viscosity=7.5e-3, pressure_viscosity=1.28e-8, temperature_viscosity=0.0215,
        conductivity=0.0966, density=970,
    )  # fmt: skip
    law = Regression4109(radius=10e-3, modulus=2.28e11, length=1.0, oil=oil, smallest_load=1e-20)
    slip = np.array([0.005, 0.01, 0.02, 0.05, 0.1, 0.2])
    force = law(np.array(50.0), slip * 20.0, np.array(20.0), np.array(1e-6)).force
    assert force / 50.0 == approx([0.0025, 0.0047, 0.0083, 0.0143, 0.0170, 0.0167], abs=2e-4)


def test_inlet_shear_tends_to_its_two_limits():
    """F/(l E' R) = 1.47 U2^0.75 in the elastic and 1.42 U2^0.5 W^0.5 in the rigid limit."""
    geometry = (2.32e-3, 2.2487e11, 5e-3)
    unit = 5e-3 * 2.2487e11 * 2.32e-3
    u2 = 2 * OIL.viscosity * 50.0 / (2.2487e11 * 2.32e-3)
    heavy = biboulet_houpert(np.array(1e5), np.array(50.0), geometry, OIL).force
    assert heavy / unit == approx(1.47 * u2**0.75, rel=5e-3)
    load = 0.1 * np.sqrt(u2) * unit
    light = biboulet_houpert(np.array(load), np.array(50.0), geometry, OIL).force
    assert light / unit == approx(1.42 * u2**0.5 * (load / unit) ** 0.5, rel=1e-2)


def test_film_of_a_textbook_contact():
    """Hamrock's roller: 4800 N, 16 mm, R 6.4 mm, u 10.0608 m/s: 0.39254 um."""
    oil = Lubricant(
        temperature=313.0, viscosity=0.01, pressure_viscosity=2.2e-8, temperature_viscosity=0.0,
        conductivity=0.14, density=870,
    )  # fmt: skip
    modulus = 207.5e9 / (1 - 0.3**2)
    law = FilmLaw(formula=FORMULAS["dowson"], radius=6.4e-3, modulus=modulus, oil=oil, inlet_heating=False)
    film = law(np.array(4800 / 16e-3), np.array(0.0), np.array(10.0608)).thickness
    assert film == approx(0.39254e-6, rel=1e-4)
    assert peak_pressure(4800 / 16e-3, 6.4e-3, modulus) == approx(1.3043e9, rel=1e-4)
    assert half_width(4800 / 16e-3, 6.4e-3, modulus) == approx(146.43e-6, rel=1e-4)


@given(speed=speeds, slide=slides)
def test_inlet_heating_only_thins_the_film(speed, slide):
    factor, *_ = inlet_heating_factor(np.array(speed), np.array(slide), OIL)
    assert 0.0 < factor <= 1.0


@pytest.mark.parametrize("formula", FORMULAS.values(), ids=FORMULAS.keys())
@given(load=loads, slide=slides, speed=speeds)
def test_film_derivatives_against_differences(formula, load, slide, speed):
    law = FilmLaw(formula=formula, radius=2.32e-3, modulus=2.2487e11, oil=OIL)
    here = law(np.array(load), np.array(slide), np.array(speed))
    point = np.array([load, slide, speed])
    for which, slope in enumerate(here[1:]):
        step = np.zeros(3)
        step[which] = 1e-5 * point[which]
        ahead, behind = (law(*(point + s * step)).thickness for s in (1, -1))
        assert slope * step[which] == approx((ahead - behind) / 2, rel=1e-5, abs=1e-9 * here.thickness * 1e-5)


def test_regression_derivatives_against_differences():
    law, film = ROLLING_LAWS[0], np.array(1e-7)
    rng = np.random.default_rng(4109)
    for _ in range(200):
        point = np.array(
            [
                10 ** rng.uniform(0, 6),
                rng.choice([-1, 1]) * 10 ** rng.uniform(-4, 1.5),
                10 ** rng.uniform(-1, 2),
            ]
        )
        here = law(*point, film)
        for which, slope in enumerate((here.by_load, here.by_sliding, here.by_entrainment)):
            step = np.zeros(3)
            step[which] = 1e-5 * abs(point[which])
            ahead, behind = (law(*(point + s * step), film).force for s in (1, -1))
            scale = np.abs(here.force) * 1e-5
            assert slope * step[which] == approx((ahead - behind) / 2, rel=1e-4, abs=1e-4 * scale)


def test_reduced_radius_of_convex_and_concave_raceways():
    assert reduced_radius(2.5, 32.475) == approx(2.3213, rel=1e-4)
    assert reduced_radius(2.5, -37.5) == approx(2.6786, rel=1e-4)


@pytest.mark.parametrize(
    "profile", [Straight(), Crowned(straight_length=3e-3, crown_radius=0.4), Logarithmic(amplitude=2e-6)]
)
def test_profile_drops_towards_the_ends_only(profile):
    x = np.linspace(-2.4e-3, 2.4e-3, 49)
    drop = profile.drop(x, 5e-3)
    assert drop == approx(drop[::-1], abs=1e-12)
    assert np.all(np.diff(drop[24:]) >= 0)
    assert drop[24] == approx(0.0, abs=1e-12)


def test_crown_drop_is_that_of_a_circle():
    """Far from the straight part: (x^2 - ls^2/4)/(2 R)."""
    drop = Crowned(straight_length=3e-3, crown_radius=0.25).drop(np.array([2.5e-3]), 5e-3)
    assert drop[0] == approx((2.5e-3**2 - 1.5e-3**2) / 0.5, rel=1e-4)


def test_oil_at_engine_temperature():
    """MIL-PRF-23699 on the ASTM D341 line: 1.388 mm2/s at 200 degC; alpha and k of the fits at 220 degC."""
    oil = oil_at("MIL-PRF-23699", 473.15)
    assert oil.viscosity / oil.density * 1e6 == approx(1.388, rel=2e-3)
    assert oil.notes == ()
    hot = oil_at("MIL-PRF-23699", 493.15)
    assert hot.pressure_viscosity == approx(8.751e-9, rel=1e-3)
    assert hot.conductivity == approx(0.1205, rel=1e-3)
    assert "extrapolated" in hot.notes[0].text


def test_oil_outside_its_range_is_refused():
    with pytest.raises(OutOfRange, match="outside"):
        oil_at("MIL-PRF-23699", 600.0)
    with pytest.raises(OutOfRange, match="known are"):
        oil_at("olive", 300.0)
