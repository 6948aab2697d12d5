"""Bearings: rollers or balls, raceways, film, traction and cage, with NumPy and SciPy alone."""

from quasidynamic.angular_contact import AngularContactBallBearing
from quasidynamic.contact.film.thickness import FORMULAS
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.traction.adore import AdoreType
from quasidynamic.contact.traction.measured_curve import FourPointCurve
from quasidynamic.contact.traction.mixed import Mixed
from quasidynamic.contact.traction.rheology import BairWiner, Eyring
from quasidynamic.contact.traction.traction_law import Regression4109
from quasidynamic.errors import ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.four_point import FourPointBallBearing, RingLoad, SlidingBalls
from quasidynamic.outcome.angular_contact_state import AngularContactState
from quasidynamic.parts.angular_contact_bearing import AngularContactBearing, RingOperation
from quasidynamic.parts.ball import Ball, FourPointBearing, Groove
from quasidynamic.parts.ball_friction import FrictionCurve, constant_friction
from quasidynamic.parts.cage import Cage
from quasidynamic.parts.lubricant import Lubricant
from quasidynamic.parts.material import Material
from quasidynamic.parts.oil_properties import oil_at
from quasidynamic.parts.operation import Operation
from quasidynamic.parts.roller import Crowned, Logarithmic, Profile, Roller, Straight
from quasidynamic.parts.roller_bearing import CylindricalRollerBearing
from quasidynamic.roller import Equilibria, Equilibrium, RollerBearing
from quasidynamic.solve.outcome import Ending
from quasidynamic.static import static_loads

__all__ = [
    "FORMULAS",
    "AdoreType",
    "AngularContactBallBearing",
    "AngularContactBearing",
    "AngularContactState",
    "BairWiner",
    "Ball",
    "Cage",
    "Crowned",
    "CylindricalRollerBearing",
    "Ending",
    "Equilibria",
    "Equilibrium",
    "Eyring",
    "FourPointBallBearing",
    "FourPointBearing",
    "FourPointCurve",
    "FrictionCurve",
    "Groove",
    "ImpossiblePart",
    "Logarithmic",
    "Lubricant",
    "Lubrication",
    "Material",
    "Mixed",
    "NotSolved",
    "Operation",
    "OutOfRange",
    "Profile",
    "Regression4109",
    "RingLoad",
    "RingOperation",
    "Roller",
    "RollerBearing",
    "SlidingBalls",
    "Straight",
    "constant_friction",
    "oil_at",
    "static_loads",
]
