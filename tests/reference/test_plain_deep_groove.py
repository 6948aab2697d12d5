"""Production and the one-page model are the same deep groove bearing."""

import numpy as np
import pytest
from pytest import approx

from tests.deep_groove import deep_groove, solved
from tests.reference import plain_deep_groove as plain

PLAIN = {"D": 12.7e-3, "dm": 65e-3, "fi": 6.6 / 12.7, "fo": 6.6 / 12.7, "Z": 9}
LOADS = {
    "radial": (0.0, 0.0, 8900.0, 0.0, 0.0),
    "axial": (-3000.0, 0.0, 0.0, 0.0, 0.0),
    "combined": (1500.0, 2000.0, 5000.0, 0.0, 0.0),
    "moment": (2500.0, 0.0, 2000.0, 20.0, -10.0),
}


@pytest.mark.parametrize("clearance", [15e-6, -8e-6], ids=["clearance", "interference"])
@pytest.mark.parametrize("speed", [0.0, 900.0])
@pytest.mark.parametrize("load", LOADS)
def test_balance_of_production_is_that_of_the_plain_model(load, speed, clearance):
    state = solved(deep_groove(clearance), LOADS[load], speed=speed)
    near = state.ring_displacement + 2e-7 * np.array([1, -1, 1, 20, -20])
    place, balls = plain.bearing(PLAIN | {"omega": speed, "Pd": clearance}, LOADS[load], near)
    assert place == approx(state.ring_displacement, rel=1e-6, abs=1e-11)
    assert [ball["Qi"] for ball in balls] == approx(state.loads[0], rel=1e-5, abs=1e-3)
    assert [ball["Qo"] for ball in balls] == approx(state.loads[1], rel=1e-5, abs=1e-3)
    for race, name in enumerate(("inner", "outer")):
        angles = np.where(state.on_inner, [ball[name] for ball in balls], 0.0)
        assert angles == approx(state.contact_angles[race] * state.on_inner, rel=1e-5, abs=1e-8)


def test_plain_model_sees_another_clearance():
    """The check above can fail: a micrometre more, and the ring stands elsewhere."""
    state = solved(deep_groove(15e-6), LOADS["radial"])
    place, _ = plain.bearing(PLAIN | {"omega": 0.0, "Pd": 16e-6}, LOADS["radial"], state.ring_displacement)
    assert place[2] - state.ring_displacement[2] > 4e-7
