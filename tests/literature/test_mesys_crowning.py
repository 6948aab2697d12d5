"""Profiles in the manual of the bearing software of MESYS, www.mesys.ag/manual/crowning.html, read in 2026.

"The default relief of 0.00035*Dw for short cylindrical roller bearings corresponds to a contact stress of
3000MPa"; its modified logarithmic profile, after Fujiwara et al. (2010), with that stress and no bound
at the end, is the profile of ISO/TS 16281. Material data are those of the contact of roller and inner race.
"""

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Material
from quasidynamic.contact.line import fujiwara_kawase, lundberg, peak_pressure
from quasidynamic.parts.material import contact_modulus

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
MODULUS, STRESS, RELIEF = contact_modulus(STEEL, STEEL), 3000e6, 0.00035


@pytest.mark.parametrize("diameter", [5e-3, 20e-3])
@pytest.mark.parametrize("slenderness", [1.0, 1.7])
def test_relief_of_iso16281_is_that_of_lundberg_for_3000_mpa(diameter, slenderness):
    """On a flat raceway, as a relief by the diameter of the roller alone supposes."""
    length, radius = slenderness * diameter, diameter / 2
    load = 2 * np.pi * radius * STRESS**2 / MODULUS * length
    assert float(peak_pressure(load / length, radius, MODULUS)) == approx(STRESS, rel=1e-12)
    assert lundberg(load, length, MODULUS).amplitude == approx(RELIEF * diameter, rel=0.005)


def test_three_parameters_without_bound_at_the_end_are_the_profile_of_iso16281():
    diameter, length = 10e-3, 12e-3
    load = np.pi * diameter * STRESS**2 / MODULUS * length
    deep = fujiwara_kawase(load, length, MODULUS, load_factor=1.0, crowned_share=1.0, end_drop=1e-3)
    x = np.linspace(-0.99, 0.99, 21) * length / 2
    iso = RELIEF * diameter * np.log(1 / (1 - (2 * x / length) ** 2))
    assert deep.drop(x, length) == approx(iso, rel=0.005, abs=1e-12)
