"""Fluid rheology: printed numbers, limits, and derivatives that are the derivatives."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given, strategies as st
from pytest import approx

from quasidynamic.contact.traction import Traction
from quasidynamic.contact.traction.adore import ADORE_OILS, AdoreType
from quasidynamic.contact.traction.rheology import BairWiner, Eyring
from quasidynamic.contact.traction.thermal_shear import WallProperties, roelands
from quasidynamic.errors import ImpossiblePart
from quasidynamic.parts.oil_properties import Lubricant


def ester(temperature, viscosity, pressure_viscosity, thinning=0.00726, conductivity=0.1205):
    return Lubricant(
        temperature=temperature, viscosity=viscosity, pressure_viscosity=pressure_viscosity,
        temperature_viscosity=thinning, conductivity=conductivity, density=835,
    )  # fmt: skip


# MIL-L-23699 fits at 220 degC: 1.137 mPa s, 8.751/GPa, 0.00726/K, 0.1205 W/(m K)
HOT = ester(493.15, 1.137e-3, 8.751e-9)
COOL = ester(373.15, 5.006e-3, 11.03e-9, 0.0200, 0.1472)
PAIR: dict[str, Any] = {"radius": 2.32e-3, "modulus": 2.2487e11, "length": 5e-3, "limiting_ratio": 0.05}
TAU_E = 2 * 0.05 / 8.751e-9
RHEOLOGY = ADORE_OILS["MIL-L-23699"]

LAWS = {
    "eyring": Eyring(**PAIR, oil=HOT, eyring_stress=TAU_E),
    "eyring heated": Eyring(**PAIR, oil=COOL, eyring_stress=5e6, film_heating=True),
    "bair-winer": BairWiner(**PAIR, oil=HOT),
    "bair-winer heated": BairWiner(**PAIR, oil=COOL, film_heating=True),
    "adore": AdoreType(**PAIR, oil=COOL, rheology=RHEOLOGY),
}
every_law = pytest.mark.parametrize("law", LAWS.values(), ids=list(LAWS))

loads = st.one_of(st.just(0.0), st.floats(0.1, 2e6), st.floats(-1, 6.3).map(lambda n: 10.0**n))  # [N/m]
slides = st.tuples(st.sampled_from([-1.0, 1.0]), st.floats(-7, np.log10(60))).map(lambda v: v[0] * 10 ** v[1])
speeds = st.floats(-4, np.log10(200)).map(lambda n: 10.0**n)  # [m/s]
films = st.floats(np.log10(5e-9), np.log10(2e-6)).map(lambda n: 10.0**n)  # [m]


def line_load(mean_pressure):
    """Load per length that gives a mean pressure: p0 = 4/pi p, q = 2 pi R p0^2/E'."""
    return 2 * np.pi * PAIR["radius"] * (4 / np.pi * mean_pressure) ** 2 / PAIR["modulus"]


def coefficient(law, pressure, slide, film, speed=69.0):
    q = np.array(line_load(pressure))
    return law(q, np.asarray(slide), np.array(speed), np.array(film)).force / q


def differences(law, point, index, step):
    """Central difference of fourth order of the force."""
    moved = []
    for n in (-2, -1, 1, 2):
        values = [np.array(value) for value in point]
        values[index] = values[index] + n * step
        moved.append(law(*values).force)
    return (moved[0] - 8 * moved[1] + 8 * moved[2] - moved[3]) / (12 * step)


@pytest.mark.parametrize(
    ("oil", "viscosity"),
    [
        (ester(311.0, 0.0276 * np.exp(3609.6 * 1.149e-6), 14.38e-9), 82.0),
        (ester(373.0, 5.03e-3, 11.03e-9), 2.79),
        (HOT, 0.298),
    ],
    ids=["311 K", "373 K", "493 K"],
)
def test_roelands_viscosity_at_one_gigapascal(oil, viscosity):
    """MIL-L-23699: 82, 2.79, 0.298 Pa s; the inputs are rounded, and so are the results."""
    assert roelands(np.array(1e9), oil)[0] == approx(viscosity, rel=0.02)


@given(st.floats(0, 4e9))
def test_roelands_slope(pressure):
    step = 1e4
    up, down = (roelands(np.array(pressure + s), COOL)[0] for s in (step, -step))
    assert roelands(np.array(pressure), COOL)[1] == approx((up - down) / (2 * step), rel=1e-6)


@pytest.mark.parametrize(
    ("pressure", "weak", "strong", "exponential"),
    [
        (1.000e9, (0.0001, 0.0013, 0.0084), (0.0001, 0.0013, 0.0110), (0.0001, 0.0013, 0.0113)),
        (1.379e9, (0.0004, 0.0036, 0.0114), (0.0004, 0.0040, 0.0192), (0.0004, 0.0040, 0.0283)),
        (2.600e9, (0.0050, 0.0094, 0.0138), (0.0078, 0.0178, 0.0279), (0.0112, 0.0460, 0.0500)),
    ],
    ids=["1.0 GPa", "1.38 GPa", "2.6 GPa"],
)
def test_isothermal_traction_at_220_degrees(pressure, weak, strong, exponential):
    """Table for MIL-L-23699, h = 0.16 um, Lambda = 0.05, slide-to-roll 0.1, 1 and 10 % of 69 m/s.

    Computed independently from Roelands and each law at the mean pressure; rounded to 1e-4.
    """
    slide = np.array([0.069, 0.69, 6.9])
    laws = replace(LAWS["eyring"], eyring_stress=5e6), LAWS["eyring"], LAWS["bair-winer"]
    for law, printed in zip(laws, (weak, strong, exponential), strict=True):
        assert coefficient(law, pressure, slide, 0.16e-6) == approx(np.array(printed), rel=5e-3, abs=0.6e-4)


def test_newtonian_film_with_its_own_heat():
    """MIL-L-23699 at 373 K, 1 GPa, 0.3 um: mu 0.00165, 0.01560, 0.03207 at 0.05, 0.5, 5 m/s; 9.905 Pa s."""
    law = AdoreType(**PAIR, oil=ester(373.0, 5e-3, 11e-9, conductivity=0.14727), rheology=RHEOLOGY)
    assert RHEOLOGY.viscosity(373.0) * np.exp(5.8015) == approx(9.905, rel=1e-3)
    mu = coefficient(law, 1e9, [0.05, 0.5, 5.0], 0.3e-6)
    assert mu == approx(np.array([0.00165, 0.01560, 0.03207]), rel=2e-3)


def test_adore_oil_far_above_its_range_says_so():
    """220 degC: eta* = 3.79e-4 Pa s and beta* = 0.0605 1/K are extrapolations."""
    assert RHEOLOGY.viscosity(493.15) == approx(3.79e-4, rel=2e-3)
    assert RHEOLOGY.temperature_viscosity(493.15) == approx(0.0605, rel=2e-3)
    hot, pressed = RHEOLOGY.notes(493.15, [1e9, 3.3e9])
    assert "493" in hot.text
    assert "3.3 GPa" in pressed.text
    assert RHEOLOGY.notes([300.0, 425.0], [0.7e9, 2e9]) == ()


@pytest.mark.sampled(2)
@every_law
@given(load=loads, slide=slides, speed=speeds, film=films)
def test_traction_is_odd_and_below_the_limiting_stress(law, load, slide, speed, film):
    rest = np.array(speed), np.array(film)
    forward, backward = (law(np.array(load), np.array(u), *rest) for u in (slide, -slide))
    for name, parity in zip(Traction._fields, (-1, -1, 1, -1, -1), strict=True):
        assert getattr(forward, name) == approx(parity * getattr(backward, name), rel=1e-12, abs=0)
    assert forward.force * slide >= 0
    assert abs(forward.force) <= 0.05 * load * (1 + 1e-12)


@pytest.mark.sampled(2)
@every_law
@given(load=loads, slide=slides, speed=speeds, film=films)
def test_every_derivative_is_the_slope_of_the_force(law, load, slide, speed, film):
    point = load, slide, speed, film
    steps = np.array([1e-4 * (load + 200.0), 1e-4 * slide, 1e-4 * speed, 1e-4 * film])
    here = law(*map(np.array, point))
    assume(not straddles_the_cap(law, point, steps))
    # a slope is compared with the size it has where the force changes by a few percent
    for index, step in enumerate(steps):
        size = max(abs(float(here.force)), 0.05 * load, 1e-6) / (abs(step) / 1e-4)
        assert here[1 + index] == approx(differences(law, point, index, step), rel=1e-6, abs=1e-8 * size)


def straddles_the_cap(law, point, steps):
    """Whether the limiting stress begins or ends within the steps of a difference."""

    def capped(values):
        q = values[0]
        return abs(abs(float(law(*map(np.array, values)).force)) - 0.05 * q) <= 1e-12 * q

    if isinstance(law, BairWiner) or point[0] == 0.0:
        return False
    moved = [np.array(point) + n * np.eye(4)[i] * steps[i] for i in range(4) for n in (-2, 2)]
    return len({capped(values) for values in [np.array(point), *moved]}) > 1


@every_law
def test_everything_stays_finite_at_the_corners(law):
    corners = np.meshgrid([0.0, 1e-3, 2e6, 8e6], [-60.0, 0.0, 1e-9, 60.0], [1e-6, 200.0], [5e-9, 2e-6])
    for value in law(*corners):
        assert value.shape == corners[0].shape
        assert np.all(np.isfinite(value))


@every_law
def test_no_sliding_is_no_force_but_a_viscous_slope(law):
    """d tau/d u_s = eta/h at rest, whatever happens at speed."""
    q = np.array(line_load(0.5e9))
    at_rest = replace(law, smallest_load=1e-14)(q, np.array(0.0), np.array(20.0), np.array(0.2e-6))
    assert [at_rest.force, at_rest.by_load, at_rest.by_entrainment, at_rest.by_film] == [0, 0, 0, 0]
    viscosity = roelands(np.array(0.5e9), law.oil)[0]
    if isinstance(law, AdoreType):
        viscosity = RHEOLOGY.viscosity(law.oil.temperature) * np.exp(RHEOLOGY.pressure_viscosity * 0.5e9)
    assert at_rest.by_sliding == approx(q / 0.5e9 * viscosity / 0.2e-6, rel=1e-6)


@pytest.mark.parametrize("name", ["eyring heated", "bair-winer heated"])
def test_heating_vanishes_between_perfect_conductors(name):
    hot = LAWS[name]
    perfect = replace(hot, oil=replace(hot.oil, conductivity=1e15), walls=WallProperties(conductivity=1e18))
    cold = replace(hot, film_heating=False)
    point = np.array(line_load(1e9)), np.geomspace(1e-3, 60, 9), np.array(50.0), np.array(0.2e-6)
    for warm_value, cold_value in zip(perfect(*point), cold(*point), strict=True):
        assert warm_value == approx(cold_value, rel=1e-6, abs=1e-9)
    assert np.all(hot(*point).force < cold(*point).force)


def test_heated_film_obeys_its_own_equation():
    """The stress found, its heat, the temperatures of textbook conduction, and the stress again."""
    law, slide, speed, film = replace(LAWS["eyring heated"], smallest_load=1e-14), 5.0, 50.0, 0.3e-6
    stress = coefficient(law, 1e9, slide, film, speed) * 1e9
    flux = stress * slide
    half = 2 * line_load(1e9) / (np.pi * (4 / np.pi * 1e9))
    chi = 46.0 / (7850.0 * 460.0)
    film_rise = flux * film / (8 * 0.1472)
    # half of the heat into a half-space for the time t: T = 2 (flux/2)/k sqrt(chi t/pi), mean over the strip
    passage = 2 * half / (speed + chi / half)
    wall_rise = 2 / 3 * 2 * (flux / 2) / 46.0 * np.sqrt(chi * passage / np.pi)
    viscosity = roelands(np.array(1e9), COOL)[0] * np.exp(-0.02 * (film_rise + wall_rise))
    assert stress == approx(5e6 * np.arcsinh(viscosity * slide / (5e6 * film)), rel=1e-9)
    assert 10.0 < film_rise + wall_rise < 300.0


def test_first_heating_is_that_of_the_exact_newtonian_film():
    """Walls that stay cold: tau/(eta u_s/h) = 1 - 2/3 psi; the middle plane alone loses psi."""
    oil = ester(373.0, 5e-3, 11e-9, conductivity=0.14727)
    perfect = WallProperties(conductivity=1e18)
    law = replace(LAWS["eyring heated"], oil=oil, walls=perfect, eyring_stress=1e15, limiting_ratio=1e9)
    slide, film, pressure = 0.01, 0.3e-6, 0.3e9
    viscosity = roelands(np.array(pressure), oil)[0]
    psi = viscosity * oil.temperature_viscosity * slide**2 / (8 * oil.conductivity)
    law = replace(law, smallest_load=1e-17)
    newtonian = viscosity * slide / (film * pressure)
    assert 1 - coefficient(law, pressure, slide, film) / newtonian == approx(psi, rel=1e-3)


def test_heating_makes_a_falling_branch():
    slide = np.geomspace(1e-3, 60.0, 60)
    force = LAWS["eyring heated"](np.array(line_load(1e9)), slide, np.array(50.0), np.array(0.3e-6))
    peak = int(np.argmax(force.force))
    assert 0 < peak < 59
    assert np.all(force.by_sliding[peak + 1 :] < 0)


def test_two_raceways_in_one_call():
    radius = np.array([2.32e-3, 2.68e-3]).reshape(2, 1, 1)
    q = np.linspace(0.0, 1e6, 2 * 2 * 3 * 4).reshape(2, 2, 3, 4)
    rest = np.full((2, 2, 3, 1), 0.5), np.full((2, 2, 3, 1), 60.0), np.full((2, 2, 3, 1), 0.1e-6)
    law = LAWS["eyring heated"]
    both = replace(law, radius=radius)(q, *rest)
    for raceway in (0, 1):
        alone = replace(law, radius=float(radius[raceway, 0, 0]))(
            q[:, raceway], *(r[:, raceway] for r in rest)
        )
        for joint, single in zip(both, alone, strict=True):
            assert joint.shape == q.shape
            assert joint[:, raceway] == approx(single, rel=1e-12, abs=1e-300)


def test_walls_of_no_material_are_refused():
    with pytest.raises(ImpossiblePart, match=r"walls\.density"):
        WallProperties(density=0.0)
