"""Rolling contacts as the program CONTACT solves them, from the outputs that its author ships with it.

Source: E.A.H. Vollebregt, CONTACT, open source version, revision 2707 of 2025-07-23, reference outputs
of testbank/test_table (3220 steady cases, which src/test_table.f90 defines), examples/fastsim.inp (case 1),
catt_to_cart.inp and conformal.inp. Lengths and forces are in mm and N there.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from pytest import approx
from scipy.special import ellipe, ellipk

from quasidynamic.contact.half_space import CellGrid, ElasticPair, grid_over
from quasidynamic.contact.pressure.normal_contact import (
    NormalCompliance,
    RigidMotions,
    contact_pressure,
)
from quasidynamic.contact.rolling.kalker import kalker
from quasidynamic.contact.rolling.rolling_contact import MID_STEP, RollingContacts
from tests.reference.rolling_steps import RollingSteps

ALLOWED = 2e-3  # of mu N, and of mu N sqrt(a b)


def steel():
    return ElasticPair(shear=1 / 82e9, poisson=0.28 / 82e9)


def pressed(grid, curvatures, load, pair, ahead=0.0):
    """A paraboloid on a plane under a load."""
    x, y = grid.centres
    gap = curvatures[0] * (x + ahead) ** 2 + curvatures[1] * y**2
    approach = RigidMotions(np.ones((1, *grid.shape)), np.array([load]))
    return contact_pressure(NormalCompliance.of(pair, grid), gap, approach)


@dataclass(frozen=True)
class Ellipse:
    """A contact of Hertz in steady rolling, its creep and what CONTACT gives for it, in SI units."""

    semi_axes: tuple[float, float]
    curvatures: tuple[float, float]  # [1/m] distance is their sum with x^2 and y^2
    load: float
    friction: float
    creep: tuple[float, float, float]  # along, across [-], spin [1/m]
    force: tuple[float, float]
    moment: float = 0.0
    cells: tuple[int, int] = (44, 44)
    around: float = 1.1  # the grid over the ellipse

    @property
    def limit(self):
        return self.friction * self.load

    @property
    def length(self):
        return np.sqrt(np.prod(self.semi_axes))

    def solved(self, finer=1):
        """Forces along and across, and the spin moment."""
        half = tuple(self.around * side for side in self.semi_axes)
        grid = grid_over(half, (finer * self.cells[0], finer * self.cells[1]))
        pressure = pressed(grid, self.curvatures, self.load, steel()).pressure
        contacts = RollingContacts((grid,), (steel(),), self.friction * pressure[None])
        x, y = contacts.places(MID_STEP)
        along, across, spin = self.creep
        rolled = kalker(contacts, np.stack([along - spin * y + 0 * x, across + spin * x + 0 * y], 1))
        return *rolled.force[0], rolled.moment[0]


def curvatures(a, b, load):
    """Of a paraboloid whose contact with steel has some semi-axes [1/m]; Johnson (1985), eq. (4.26)."""
    large, small = max(a, b), min(a, b)
    share = 3 * load / (2 * np.pi * a * b) * (1 - 0.28) / 82e9
    if large == small:
        return (np.pi * share / (4 * a),) * 2
    m = 1 - (small / large) ** 2
    first, second = ellipk(m), ellipe(m)
    scale = share * small / (large**2 * m)
    along_large, along_small = scale * (first - second), scale * ((large / small) ** 2 * second - first)
    return (along_large, along_small) if a == large else (along_small, along_large)


# a [mm], a/b, spin, angle [deg] and size of the creep as shares of what slides; forces over mu N, moment over
# mu N sqrt(ab): four rows of each ellipse, drawn from 3220 of testbank/test_table_mx11.ref_fx (11 x 11 cells)
TABLE = (
    (4, 0.2, 0, 0, 0.1, -0.147035, 0, 0),
    (4, 0.2, 0.5, -90, 0.4, 0, 0.241868, -0.589685),
    (4, 0.2, 0.5, -60, 0.5, -0.219055, 0.266655, -0.567485),
    (4, 0.2, 2, -30, 0.4, -0.110514, -0.144223, -0.825331),
    (6, 0.5, 0, -30, 1.1, -0.750594, 0.361142, -0.026036),
    (6, 0.5, 0.5, -30, 0.5, -0.37702, 0.066664, -0.237727),
    (6, 0.5, 1, -30, 1.7, -0.822, 0.281856, -0.157136),
    (6, 0.5, 2, -60, 2, -0.40264, 0.505709, -0.409157),
    (9, 1, 0, -60, 0.9, -0.395315, 0.60953, -0.092224),
    (9, 1, 0.5, -90, 1.7, 0, 0.886425, -0.144943),
    (9, 1, 1, -60, 1.1, -0.405707, 0.358725, -0.306266),
    (9, 1, 2, 0, 0.7, -0.377751, -0.547523, -0.332481),
    (12, 2, 0, 30, 0.3, -0.366583, -0.204201, 0.067787),
    (12, 2, 0.5, -90, 0.4, 0, 0.13677, -0.30487),
    (12, 2, 1, -60, 1.1, -0.512272, 0.28517, -0.363327),
    (12, 2, 1, 90, 3, 0, -0.996054, -0.028001),
    (20, 5, 0, 90, 0.2, 0, -0.5875, 0.225498),
    (20, 5, 0.5, 30, 2, -0.818512, -0.5436, -0.156993),
    (20, 5, 1, 0, 1.7, -0.882582, -0.189238, -0.41323),
    (20, 5, 2, 60, 0.4, -0.136085, -0.474189, -0.688759),
)
TABLE_ALLOWED = 1e-6  # six decimals are printed


def of_table(a, ratio, spin, angle, size, *known):
    """A row of the table: creep is made dimensionless by friction, sqrt(ab) and an effective radius."""
    axes, load, friction = (1e-3 * a, 1e-3 * a / ratio), 82e3, 0.3
    curved = curvatures(*axes, load)
    by_radius, length = friction * sum(curved) / 2, np.sqrt(axes[0] * axes[1])
    creep = size * length * by_radius
    along, across, moment = friction * load * np.array(known)
    direction = np.radians(angle)
    return Ellipse(
        semi_axes=axes,
        curvatures=curved,
        load=load,
        friction=friction,
        creep=(creep * np.cos(direction), creep * np.sin(direction), spin * by_radius),
        force=(along, across),
        moment=moment * length,
        cells=(11, 11),
        around=11 / 7,
    )


STEADY = {
    f"a/b {row[1]:g}, spin {row[2]:g}, creep {row[4]:g} at {row[3]:g} deg": of_table(*row) for row in TABLE
}


@pytest.mark.parametrize("ellipse", STEADY.values(), ids=STEADY.keys())
def test_steady_rolling_to_the_printed_digits(ellipse):
    along, across, moment = ellipse.solved()
    limit = TABLE_ALLOWED * ellipse.limit
    assert (along, across) == approx(ellipse.force, rel=0, abs=limit)
    assert moment == approx(ellipse.moment, rel=0, abs=limit * ellipse.length)


FINE = Ellipse(  # examples/fastsim.inp, case 1
    semi_axes=(8e-3, 4e-3),
    curvatures=curvatures(8e-3, 4e-3, 82e3),
    load=82e3,
    friction=0.3,
    creep=(0.0, -6.25e-4, 0.625),
    force=(0.0, -14940.0),
    moment=-48.21,
)


def test_steady_rolling_on_finer_cells():
    along, across, moment = FINE.solved()
    assert (along, across) == approx(FINE.force, rel=0, abs=ALLOWED * FINE.limit)
    assert moment == approx(FINE.moment, rel=0, abs=ALLOWED * FINE.limit * FINE.length)


ONSET = {0: 1.774e-2, 1: 1.824e-3, 5: 2.140e-3, 10: 2.676e-3, 56: 3.101e-3}  # cells rolled: creep
SHIFT_IN_CELLS = 0.25  # [mm] side of a cell: the first number is a shift in mm


def onset_of_rolling(steps=ONSET):
    """Shift [mm], then creep in each step, of a sphere that is shifted and rolls under one force.

    Contact of 7 mm of diameter in units of CONTACT: mm, G = 1 N/mm2; 34 x 33 cells about half a cell ahead.
    """
    pair = ElasticPair(shear=1.0, poisson=0.28)
    grid = CellGrid((0.25, 0.25), (34, 33))
    contact = pressed(grid, (0.002963, 0.002963), 0.4705, pair, ahead=0.125)
    limit, force = 0.4013 * contact.pressure, -0.657 * 0.4013 * 0.4705
    traction, found = np.zeros((2, *grid.shape)), {}
    for step in range(max(steps) + 1):
        rolling = RollingSteps(grid, pair, cells=min(step, 1))
        creep, traction = _under(force, rolling, traction, limit)
        found[step] = creep / (SHIFT_IN_CELLS if step else 1.0)
    return {step: found[step] for step in steps}


def _under(force, rolling, traction, limit):
    """Shift of a step that ends with a force, and the tractions then; by secants."""
    shape = np.zeros_like(traction)
    shape[0] = 1.0

    def after(shift):
        state = rolling.after(traction, shift * shape, limit)
        return state.traction, state.traction[0].sum() * rolling.grid.cell_area - force

    one, other = 5e-4, 8e-4
    error = after(one)[1]
    for _ in range(40):
        state, next_error = after(other)
        if abs(next_error) < 1e-9 * abs(force):
            return other, state
        one, other, error = other, other - next_error * (other - one) / (next_error - error), next_error
    raise AssertionError("no shift found")


def test_onset_of_rolling_from_a_shift():
    found = onset_of_rolling({step: ONSET[step] for step in (0, 1, 5)})
    for step, creep in found.items():
        assert creep == approx(ONSET[step], rel=2e-3)


RAIL = np.array([  # [mm] distance across, from an edge to the middle: rail of 10 mm in a wheel of 10.2 mm
    -0.01060019, -0.01864015, -0.02628477, -0.03352765, -0.04036271, -0.0467842, -0.05278672, -0.05836522,
    -0.06351499, -0.06823168, -0.07251131, -0.07635024, -0.07974523, -0.08269341, -0.08519227, -0.08723969,
    -0.08883393, -0.08997365, -0.09065786, -0.090886,
])  # fmt: skip
WHEEL, MEAN, ANGLE, YAW = 460e-3, 10.1e-3, np.pi / 4, -0.014  # radii [m]; of the contact, of the wheel [rad]
CONFORMAL = {  # distance, creep: normal force [N], forces over mu N, moment [N m]
    ("parabola", "even"): (1.000e5, 0.3048, 0.8639, 38.60),
    ("true", "even"): (9.184e4, 8959 / (0.3 * 9.184e4), 2.417e4 / (0.3 * 9.184e4), 26.76),
    ("true", "of the surfaces"): (9.184e4, 1.050e4 / (0.3 * 9.184e4), 2.251e4 / (0.3 * 9.184e4), 32.27),
}


def conformal(distance, creep):
    """Normal force, forces and moment of a wheel's fillet on a rail, half-spaces on 51 x 39 cells."""
    grid = CellGrid((0.4e-3, 0.4e-3), (51, 39))
    x, y = grid.centres
    if distance == "true":
        gap = 0.768594 * x**2 + 1e-3 * np.concatenate([RAIL, RAIL[-2::-1]])
    else:
        gap = 0.76859 * x**2 + 0.98039 * y**2 - 0.09089e-3
    held = RigidMotions(np.zeros((0, *grid.shape)), np.zeros(0))
    contact = contact_pressure(NormalCompliance.of(steel(), grid), gap, held)
    contacts = RollingContacts((grid,), (steel(),), 0.3 * contact.pressure[None])
    x, y = contacts.places(MID_STEP)
    along, across = -4e-3 + 1.5372 * y + 0 * x, -9.8995e-3 - 1.5372 * x + 0 * y
    if creep != "even":
        x, y = contacts.places()
        place = ANGLE + y / MEAN
        along = MEAN / WHEEL * (np.sin(place) - np.sin(ANGLE)) - 4e-3 + 0 * x
        across = YAW * np.sin(place) - x * np.cos(place) / WHEEL
    rolled = kalker(contacts, np.stack([along, across], 1))
    return contact.force, *rolled.force[0], rolled.moment[0]


@pytest.mark.parametrize(("case", "known"), CONFORMAL.items(), ids=[", ".join(case) for case in CONFORMAL])
def test_conforming_contact_of_a_wheel_on_a_rail(case, known):
    force, along, across, moment = conformal(*case)
    limit = 0.3 * known[0]
    assert force == approx(known[0], rel=ALLOWED)
    assert (along / limit, across / limit) == approx(known[1:3], rel=0, abs=ALLOWED)
    assert moment == approx(known[3], rel=0, abs=ALLOWED * limit * 8e-3)
