"""Film formulas of line contact against their published coefficients, exponents and worked values.

Sources: h/R = c G^g U^s W^-w of Dowson and Higginson (1961, 1966), Dowson (1968), Dowson and Toyoda (1978),
Pan and Hamrock (1989), as collected in this project's notes on lubrication; those of Dowson and Higginson and
of Pan and Hamrock are recalled there. The worked values [um] were computed there too, for the raceways of a
roller of 5 mm in the bearing of Mao, Wang and Zhang (2016) at 38000 rpm with an inlet of 220 degC.
"""

from dataclasses import replace

import numpy as np
import pytest
from pytest import approx

from quasidynamic import FORMULAS, Lubricant
from quasidynamic.contact.film import FilmLaw

PUBLISHED = {  # c and the exponents of G, U and W
    "dowson_higginson": (1.6, 0.6, 0.7, -0.13),
    "dowson": (2.65, 0.54, 0.7, -0.13),
    "dowson_toyoda": (3.06, 0.56, 0.69, -0.10),
    "pan_hamrock": (1.714, 0.568, 0.694, -0.128),
    "pan_hamrock_central": (2.922, 0.470, 0.692, -0.166),
}
WORKED = {  # inner 3537 N, inner 1000 N, outer 3537 N, outer 92.15 N [um]
    "dowson_higginson": (0.1107, 0.1304, 0.1177, 0.1891),
    "dowson": (0.1163, 0.1370, 0.1237, 0.1987),
    "dowson_toyoda": (0.1607, 0.1824, 0.1704, 0.2455),
    "pan_hamrock": (0.1051, 0.1236, 0.1119, 0.1784),
    "pan_hamrock_central": (0.1146, 0.1413, 0.1227, 0.2247),
}
LOADS = np.array([3537.0, 1000.0, 3537.0, 92.15]) / 5e-3  # [N/m]
RADII = np.array([2.3213e-3, 2.3213e-3, 2.6786e-3, 2.6786e-3])  # [m]
MODULUS, SPEED = 2.2487e11, 69.26  # [Pa], [m/s]
OIL = Lubricant(
    temperature=493.15, viscosity=1.137e-3, pressure_viscosity=8.75e-9,
    temperature_viscosity=0.00726, conductivity=0.1205, density=880.0,
)  # fmt: skip


def film(name, load=LOADS, speed=SPEED, oil=OIL):
    law = FilmLaw(formula=FORMULAS[name], radius=RADII, modulus=MODULUS, oil=oil, inlet_heating=False)
    return law(load, np.zeros(4), np.full(4, speed)).thickness


def test_every_formula_is_checked():
    assert set(FORMULAS) == set(PUBLISHED) == set(WORKED)


@pytest.mark.parametrize("name", PUBLISHED)
def test_film_falls_with_the_load_and_rises_with_speed_and_piezoviscosity_by_the_published_powers(name):
    _, material, speed, load = PUBLISHED[name]
    thicker = replace(OIL, pressure_viscosity=2 * OIL.pressure_viscosity)
    ratios = film(name, load=2 * LOADS), film(name, speed=2 * SPEED), film(name, oil=thicker)
    for ratio, power in zip(ratios, (load, speed, material), strict=True):
        assert ratio / film(name) == approx(2.0**power, rel=1e-12)


@pytest.mark.parametrize("name", WORKED)
def test_worked_films(name):
    assert film(name) * 1e6 == approx(WORKED[name], abs=0.6e-4)


@pytest.mark.parametrize("name", PUBLISHED)
def test_formula_in_its_groups(name):
    factor, material, speed, load = PUBLISHED[name]
    elastic = MODULUS * RADII
    G, U, W = OIL.pressure_viscosity * MODULUS, OIL.viscosity * SPEED / elastic, LOADS / elastic
    assert film(name) == approx(factor * RADII * G**material * U**speed * W**load, rel=1e-12)
