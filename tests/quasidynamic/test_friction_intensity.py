"""Sliding power per area of the contacts of rollers; that of balls is in `test_balls_in_oil`."""

from functools import partial

import numpy as np
import pytest
from pytest import approx

from quasidynamic import FourPointCurve, Logarithmic
from quasidynamic.contact.traction import in_any_contact
from tests.bearings import paper_bearing
from tests.quasidynamic.test_tapered_friction import ANGLES, friction

CURVE = FourPointCurve.through(at_rest=0.0, peak=0.06, peak_slip=0.02, far=0.05)


TILTED = {"profile": Logarithmic(amplitude=1e-6), "misalignment": 1e-3}


@pytest.mark.parametrize("changes", [{}, TILTED], ids=["aligned", "tilted"])
def test_the_most_loaded_slice_of_a_roller_has_it_by_friction_in_proportion_to_the_load(changes):
    """Coefficient times q u over the width of Hertz, which rises with the load of the slice."""
    state = paper_bearing(traction=partial(in_any_contact, CURVE), **changes).solve()
    load, raceways = state.slice_loads.max(-1), state.balance.roller.raceways
    width = np.sqrt(32 * load * raceways.radius[:, 0] / (np.pi * raceways.modulus[:, 0]))
    assert load.min() > 0
    coefficient = state.traction / state.loads
    assert state.friction_intensity == approx(coefficient * load * state.sliding / width, rel=1e-9)
    assert state.friction_intensity.max() > 1e5


def test_it_is_the_largest_of_the_slices_of_a_tapered_roller():
    found = friction(ANGLES["no apex"], axial=6.5e3, radial=20e3)
    loads, slices = found.loads, found.loads.slices
    largest = np.zeros_like(found.sliding_heat)
    for race, roller, k in np.ndindex(found.state.traction.shape):
        line_load = loads.slice_loads[race, roller, k]
        if line_load:
            stiffness = np.pi * loads.moduli[race] / (8 * loads.reduced_radius(race)[k])
            area = 2 * np.sqrt(line_load / stiffness) * slices.widths[k]
            heat = found.state.traction[race, roller, k] * found.state.sliding[race, roller, k]
            largest[race, roller] = max(largest[race, roller], heat / area)
    assert largest.max() > 1e6
    assert found.friction_intensity == approx(largest, rel=1e-9)
