"""Oils of the ADORE line: the printed formulas, entered a second time, at three temperatures.

Source: viscosity and its temperature coefficient as coded in a public program of that line, collected in this
project's notes on lubrication.
"""

from math import exp, log

import pytest
from pytest import approx

from quasidynamic.contact.traction.adore import ADORE_OILS

PRINTED = {  # alpha [1/Pa], viscosity [Pa s] and -d ln(viscosity)/dT [1/K] over the temperature [K]
    "MIL-L-7808": (5.2214e-9, lambda T: 0.11431 * exp(0.033723 * (313 - T)), (0.041745, 0.60873)),
    "MIL-L-23699": (5.8015e-9, lambda T: 0.26529 * exp(0.036358 * (313 - T)), (0.033398, 1.3075)),
    "MIL-L-27502": (5.8015e-9, lambda T: 0.21655 * exp(0.039221 * (313 - T)), (0.032577, 1.0723)),
    "Santotrac 30": (9.4275e-9, lambda T: 0.40063 * exp(0.050459 * (313 - T)), (0.034104, 1.093)),
    "Santotrac 50": (7.2519e-9, lambda T: 10.076 * exp(0.044097 * (313 - T)), (0.020794, 6.2743)),
    "Mobil DTE SAE 30": (7.2516e-9, lambda T: 0.28407 * exp(0.023743 * (313 - T)), (0.028939, 2.1402)),
}


def test_every_oil_is_checked():
    assert set(ADORE_OILS) == set(PRINTED)


@pytest.mark.parametrize("temperature", [313.0, 373.0, 420.0])
@pytest.mark.parametrize("name", PRINTED)
def test_viscosity_and_its_temperature_coefficient(name, temperature):
    alpha, viscosity, (at_313, power) = PRINTED[name]
    oil = ADORE_OILS[name]
    assert oil.pressure_viscosity == alpha
    assert oil.viscosity(temperature) == approx(viscosity(temperature), rel=1e-12)
    assert log(oil.temperature_viscosity(temperature) / at_313) == approx(
        power * log(temperature / 313), rel=1e-12, abs=1e-15
    )
