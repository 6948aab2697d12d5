"""Cage slip in closed form: every roller carries the same load Q_i, a constant torque M brakes the cage.

Traction mu = m S at both raceways (S sliding over mean rolling speed), pockets without friction, nothing
brakes the rollers. Each roller is pulled by f = M/(Z d_m/2), half of it at either raceway, so that
S = f/(2 m Q) with Q_o = Q_i + F_c, and to first order slip = f (1 + gamma)/(4 m) (1/Q_i + 1/Q_o).

Source: constructed; the printed digits were computed independently from these equations. The model here
also counts the weight of a roller at its outer raceway, 8 mN in the first two cases and 231 mN in the third,
which changes their slips by 1e-5 and 1e-3; the exact answer with that weight is required to nine digits.

Realised as: rollers preloaded by a negative clearance, without any load; cages as thick as the rollers, out
of the oil-air mixture; and a laminar land whose torque at the solved speed is M.
"""

from dataclasses import dataclass, replace
from functools import partial

import numpy as np
import pytest
from pytest import approx
from scipy.optimize import brentq, root

from quasidynamic import (
    Cage,
    CylindricalRollerBearing,
    Lubricant,
    Lubrication,
    Material,
    Operation,
    Roller,
    RollerBearing,
)
from quasidynamic.contact.cage import land_drag
from quasidynamic.contact.traction import RollingShear, Traction
from quasidynamic.motion.roller_speeds import rolling_cage_speed, rolling_roller_speed
from tests.bearings import RPM

OIL = Lubricant(  # thin: its film must not fill the gaps
    temperature=373.15,
    viscosity=1e-4,
    pressure_viscosity=1e-8,
    temperature_viscosity=0.02,
    conductivity=0.13,
    density=900.0,
)


@dataclass(frozen=True)
class LinearTraction:
    """mu = limit tanh(m S / limit); mu = m S without a limit."""

    slope: float  # m [-]
    limit: float = np.inf

    def __call__(self, line_load, sliding, entrainment, film):
        slip = sliding / entrainment
        if np.isinf(self.limit):
            value, by_slip = self.slope * slip, np.full_like(slip, self.slope)
        else:
            share = np.tanh(self.slope * slip / self.limit)
            value, by_slip = self.limit * share, self.slope * (1 - share**2)
        return Traction(
            force=line_load * value,
            by_load=value,
            by_sliding=line_load * by_slip / entrainment,
            by_entrainment=-line_load * by_slip * slip / entrainment,
            by_film=np.zeros_like(line_load * slip),
        )


def no_rolling_shear(load, *_):
    return RollingShear(*np.zeros((3, *load.shape)))


@dataclass(frozen=True)
class Case:
    pitch: float  # [m]
    diameter: float  # [m]
    length: float  # [m]
    rollers: int
    speed: float  # [rpm]
    density: float  # [kg/m3]
    load: float  # Q_i [N]
    torque: float  # M [N m]
    slope: float = 2.0  # m [-]

    @property
    def ratio(self):
        return self.diameter / self.pitch

    @property
    def mass(self):
        return self.density * np.pi / 4 * self.diameter**2 * self.length

    def model(self, cage_speed, limit=np.inf, clearance=-5e-6):
        """Bearing whose land brakes with M when the cage turns at `cage_speed` [rpm]."""
        steel = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=self.density)
        cage = Cage(
            guidance="outer" if self.torque else "rollers",
            pocket_friction=0.0,
            thickness=self.diameter,
            mass=0.1,
            land_diameter=self.pitch,
            land_width=1e-3,
            land_clearance=1e-3,
        )
        if self.torque:
            width = self.torque / (cage_speed * RPM) / land_drag(replace(cage, land_width=1.0), OIL)
            cage = replace(cage, land_width=width)
        return RollerBearing(
            bearing=CylindricalRollerBearing(
                rollers=self.rollers,
                outer_raceway_diameter=self.pitch + self.diameter,
                clearance=clearance,
                roller=Roller(diameter=self.diameter, length=self.length, material=steel),
                cage=cage,
                inner_ring=steel,
                outer_ring=steel,
            ),
            operation=Operation(radial_load=0.0, inner_speed=self.speed * RPM, gravity=0.0),
            lubrication=Lubrication(
                oil=OIL,
                oil_fraction=0.0,
                traction=lambda **_: LinearTraction(self.slope, limit),
                rolling=no_rolling_shear,
                inlet_heating=False,
            ),
        )

    def solved(self, cage_speed, limit=np.inf):
        """State whose preload gives every roller Q_i."""

        def state(clearance):
            return self.model(cage_speed, limit, clearance).solve()

        def excess(clearance):
            return state(clearance).loads[0].mean() - self.load

        return state(brentq(excess, -20e-6, -0.1e-6, xtol=1e-16, rtol=1e-13))

    @property
    def rolling(self):
        """Cage and roller speed in pure rolling [rad/s]."""
        speed = self.speed * RPM
        return rolling_cage_speed(speed, 0.0, self.ratio), rolling_roller_speed(speed, 0.0, self.ratio)

    def exact(self):
        """Slip from S = f/(2 m Q) at both raceways; the drifts from rolling are the unknowns."""
        cage, spin = self.rolling
        r_w, r_i, r_o = self.diameter / 2, (self.pitch - self.diameter) / 2, (self.pitch + self.diameter) / 2
        pull = self.torque / (self.rollers * self.pitch / 2) / (2 * self.slope)

        def excess(drifts):
            lag, spin_lag = drifts * cage
            outer_load = self.load + self.mass * self.pitch / 2 * (cage - lag) ** 2
            inner, outer = r_i * lag + r_w * spin_lag, r_o * lag - r_w * spin_lag
            surface = (self.speed * RPM - cage + lag) * r_i, (cage - lag) * r_o
            roller = (spin - spin_lag) * r_w
            return [
                inner / ((surface[0] + roller) / 2) * self.load / pull - 1,
                outer / ((surface[1] + roller) / 2) * outer_load / pull - 1,
            ]

        return root(excess, [1e-3, 1e-3], tol=1e-12).x[0]


@dataclass(frozen=True)
class Printed:
    slip: float
    first_order: float
    cage: float  # [rpm]
    rolling_cage: float  # [rpm]
    spin: float | None  # [rpm]
    centrifugal: float  # [N]
    digits: float  # relative size of the weight of a roller in the slip


SMALL = partial(Case, 70e-3, 5e-3, 5e-3, 30, 38000, 7860, 100.0)
CASES = {
    "a": (
        SMALL(0.5),
        Printed(9.698362e-4, 9.695902e-4, 17625.7465, 17642.8571, 264550.168, 92.0116, 1.5e-5),
    ),
    "b": (
        SMALL(5.0),
        Printed(9.720501e-3, 9.695902e-3, 17471.3597, 17642.8571, 263714.071, 90.4068, 1.5e-5),
    ),
    "c": (
        Case(103.5e-3, 15e-3, 17e-3, 18, 3600, 7850, 50.0, 0.5),
        Printed(2.477661e-3, 2.476632e-3, 1535.3170, 1539.1304, 12148.980, 31.5468, 1.2e-3),
    ),
}


@pytest.fixture(scope="module", params=CASES.values(), ids=CASES.keys())
def solved(request):
    case, printed = request.param
    return case, printed, case.solved(printed.cage)


def test_case_is_the_constructed_one(solved):
    case, _, state = solved
    assert state.loads[0] == approx(np.full(case.rollers, case.load), rel=1e-9)
    assert state.land_torque == approx(-case.torque, rel=5e-6)


def test_cage_slip(solved):
    case, printed, state = solved
    assert case.exact() == approx(printed.slip, rel=1e-6)
    assert state.cage_slip == approx(printed.slip, rel=printed.digits)
    braked = replace(case, torque=-state.land_torque)
    assert state.cage_slip == approx(braked.exact(), rel=1e-9)


def test_first_order_slip(solved):
    case, printed, state = solved
    f = case.torque / (case.rollers * case.pitch / 2)
    loads = 1 / case.load + 1 / (case.load + case.mass * case.pitch / 2 * case.rolling[0] ** 2)
    assert f * (1 + case.ratio) / (4 * case.slope) * loads == approx(printed.first_order, rel=1e-6)
    assert state.cage_slip == approx(printed.first_order, rel=4e-3)


def test_speeds(solved):
    case, printed, state = solved
    lag = printed.digits * printed.slip
    assert state.cage_speed / RPM == approx(printed.cage, rel=max(lag, 1e-8))
    assert state.balance.rolling_cage[0, 0] / RPM == approx(printed.rolling_cage, abs=6e-5)
    assert state.roller_speed / RPM == approx(np.full(case.rollers, printed.spin), rel=max(lag, 1e-8))


def test_sliding_adds_up_to_the_lag_of_the_cage(solved):
    """u_i + u_o = d_m (w_c0 - w_c)."""
    case, _, state = solved
    lag = case.rolling[0] - state.cage_speed
    assert state.sliding.sum(0) == approx(np.full(case.rollers, case.pitch * lag), rel=1e-9)
    assert state.traction[0] == approx(state.traction[1], rel=1e-9)


def test_centrifugal_force(solved):
    case, printed, state = solved
    outward = state.loads[1] - state.loads[0]
    assert outward == approx(np.full(case.rollers, printed.centrifugal), abs=2e-4)


@pytest.mark.parametrize("case", [case for case, _ in CASES.values()], ids=CASES.keys())
def test_free_cage_turns_at_epicyclic_speed(case):
    """n/2 (1 - gamma) and n d_m/(2 D) (1 - gamma^2); M = 0 gives no slip at all."""
    state = replace(case, torque=0.0).model(0.0).solve()
    assert state.cage_slip == approx(0.0, abs=1e-12)
    assert state.cage_speed / RPM == approx(case.speed / 2 * (1 - case.ratio), rel=1e-12)
    spin = case.speed * case.pitch / (2 * case.diameter) * (1 - case.ratio**2)
    assert state.roller_speed / RPM == approx(np.full(case.rollers, spin), rel=1e-12)


@pytest.mark.parametrize(("share", "slips"), [(0.9, False), (1.5, True)], ids=["below", "above"])
def test_gross_slip_begins_where_coulomb_friction_is_used_up(share, slips):
    """M = Z d_m mu min(Q_i, Q_o): a stronger land slows the cage until it brakes with that torque."""
    case, limit = SMALL(0.5), 0.02
    most = case.rollers * case.pitch * limit * case.load
    braked = replace(case, torque=share * most)
    state = braked.solved(case.rolling[0] / RPM, limit)
    if slips:
        assert state.cage_slip == approx(1 - 1 / share, rel=1e-6)
        assert state.land_torque == approx(-most, rel=1e-6)
    else:
        assert state.cage_slip < 0.02
