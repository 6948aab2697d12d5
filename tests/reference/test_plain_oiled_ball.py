"""Production and the one-page model are the same bearing in oil."""

from functools import partial

import numpy as np
import pytest
from pytest import approx

from quasidynamic import Eyring, Lubricant
from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.contact.lubrication import BallLubrication
from quasidynamic.parts.angular_contact_bearing import RingOperation
from quasidynamic.parts.material import Material
from tests.ball_bearings import fast_bearing
from tests.reference import plain_coulomb_ball as dry, plain_oiled_ball as plain

STEEL = Material(youngs_modulus=dry.E, poisson_ratio=dry.NU, density=dry.DENSITY)
BEARING = {"D": 7.938e-3, "dm": 54e-3, "fi": 0.52, "fo": 0.525, "alpha": 0.44, "Z": 18, "omega": 1500.0}
OIL = {"eta": 0.01, "thick": 18e-9, "eyring": 5e6, "limit": 0.05, "rho": 30.0, "Cd": 0.5, "mu": 0.05}


def production(thrust):
    bearing = fast_bearing(*(BEARING[name] for name in ("D", "dm", "Z", "alpha", "fi", "fo")), STEEL)
    oil = Lubricant(
        temperature=340.0, viscosity=OIL["eta"], pressure_viscosity=OIL["thick"], temperature_viscosity=0.03,
        conductivity=0.14, density=OIL["rho"],
    )  # fmt: skip
    lubrication = BallLubrication(
        oil=oil, oil_fraction=1.0, drag_coefficient=OIL["Cd"], inlet_heating=False,
        traction=partial(Eyring, limiting_ratio=OIL["limit"], eyring_stress=OIL["eyring"]),
    )  # fmt: skip
    operation = RingOperation(
        load=(thrust, 0.0, 0.0, 0.0, 0.0),
        displacement=(None, None, None, 0.0, 0.0),
        inner_speed=BEARING["omega"],
    )
    model = AngularContactBallBearing(bearing=bearing, control="oil", lubrication=lubrication)
    return model.solve(operation)


@pytest.mark.slow
def test_balls_in_oil_of_production_are_those_of_the_plain_model():
    state = production(1500.0)
    known = dry.thrust_bearing(BEARING | OIL, 1500.0, plain.contact, plain.drag)
    assert state.contact_angles[:, 0] == approx(known["angles"], rel=1e-5)
    assert state.loads[:, 0] == approx(known["loads"], rel=1e-5)
    assert state.orbital_speed[0] == approx(known["orbit"], rel=1e-6)
    axial, radial, turn = known["spin"]
    assert state.attitude[0] == approx(np.arctan2(radial, -axial), rel=1e-4)
    assert state.yaw[0] == approx(np.arcsin(turn / state.ball_speed[0]), rel=2e-3)
    assert state.oil.ring_torque[0].sum() == approx(known["torque"], rel=1e-4)
