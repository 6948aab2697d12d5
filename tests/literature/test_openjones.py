"""Fast angular-contact bearings as in OpenJones (Sudhof, 2015; GPL), with outer-race control throughout.

The bearings are those of its `trullatest.m` (commit 81d4a4e), run in Octave 7.3 with its equations unchanged.
Not in its repository, and supplied: `engPower`, a power that keeps the sign, `ballsum`, a sum, and `precise`,
false. It finds the ellipses of Hertz by a formula of Harris, kappa = 1.0339 (R_x/R_y)^0.636: loads and
deflections differ a little.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from pytest import approx

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, Groove
from quasidynamic.parts.material import Material

RPM = np.pi / 30
RINGS = Material(youngs_modulus=199.948e9, poisson_ratio=0.25, density=7750.37)
ZENKER = Material(youngs_modulus=210.08e9, poisson_ratio=0.3, density=7750.37)


@dataclass(frozen=True)
class Row:
    """A bearing under load, and what the program finds for the balls (n), those of the load line first."""

    name: str
    sizes: tuple[float, float, float, float, float, int]  # D, d_m [m], angle [deg], radii [m], balls
    ball: Material
    rings: Material
    load: tuple[float, float]  # [N] axial, radial
    speed: float  # [rpm]
    angles: tuple[tuple[float, float], ...]  # [deg] at the inner and the outer race
    loads: tuple[tuple[float, float], ...]  # [N]
    moved: tuple[float, float]  # [um] axial, radial

    def solve(self):
        """The same bearing here."""
        diameter, pitch, angle, inner, outer, balls = self.sizes
        bearing = AngularContactBearing(
            ball=Ball(diameter=diameter, material=self.ball),
            inner=Groove(conformity=inner / diameter, material=self.rings),
            outer=Groove(conformity=outer / diameter, material=self.rings),
            balls=balls,
            pitch_diameter=pitch,
            contact_angle=np.radians(angle),
        )
        axial, radial = self.load
        operation = RingOperation(
            load=(axial, 0.0, radial, 0.0, 0.0),
            displacement=(None, None, None, 0.0, 0.0),
            inner_speed=self.speed * RPM,
        )
        return AngularContactBallBearing(bearing=bearing, control="outer").solve(operation)


LE7, MA = (7.938e-3, 38.5e-3, 20.0, 0.56 * 7.938e-3, 0.52 * 7.938e-3, 10), (
    6.35e-3, 31.031e-3, 25.0, 3.43e-3, 3.3e-3, 12,
)  # fmt: skip
NITRIDE = Material(
    youngs_modulus=310e9, poisson_ratio=0.27, density=7750.37
)  # heavy as steel, as in the file
ROWS = (
    Row("LE-7, steel", LE7, RINGS, RINGS, (2670.0, 0.0), 50000.0,
        ((26.232633, 18.605438),), ((604.049415, 768.816735),), (51.9283027, 0.0)),
    Row("LE-7, hybrid", LE7, Material(youngs_modulus=320e9, poisson_ratio=0.26, density=3160), RINGS,
        (2700.0, 0.0), 50000.0, ((24.762609, 21.470011),), ((644.607439, 710.781184),), (47.5150213, 0.0)),
    Row("Zenker", (12.7e-3, 90e-3, 25.0, 6.80e-3, 6.66e-3, 18), ZENKER, ZENKER, (4150.0, 0.0), 11111.111,
        ((29.555785, 22.972097),), ((467.401655, 554.619622),), (27.6560439, 0.0)),
    Row("Ma, thrust", MA, NITRIDE, RINGS, (500.0, 0.0), 30000.0,
        ((29.206575, 20.312921),), ((85.389542, 109.836509),), (9.35140326, 0.0)),
    Row("Ma, thrust and radial load", MA, NITRIDE, RINGS, (500.0, 200.0), 30000.0,
        ((28.131134, 21.831317), (28.260973, 21.629930), (28.647814, 21.014542), (29.247865, 20.028151),
         (29.911726, 18.911163), (30.420850, 18.045495), (30.609387, 17.723965)),
        ((127.529083, 151.710322), (120.264005, 144.475501), (102.097520, 126.409187),
         (81.374710, 105.871096), (65.201311, 89.943202), (55.883351, 80.842733), (52.928565, 77.974942)),
        (8.85808011, 2.3586963)),
)  # fmt: skip


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.name)
def test_angles_loads_and_places_are_those_of_openjones(row):
    state, balls = row.solve(), len(row.angles)
    assert np.degrees(state.contact_angles[:, :balls]).T == approx(np.array(row.angles), abs=5e-3)
    assert state.loads[:, :balls].T == approx(np.array(row.loads), rel=2e-4)
    assert 1e6 * state.ring_displacement[[0, 2]] == approx(np.array(row.moved), rel=2e-3, abs=1e-9)
