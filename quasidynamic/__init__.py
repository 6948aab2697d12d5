"""The bearing: rollers, raceways, film, traction and cage, with NumPy and SciPy alone."""

from quasidynamic.errors import ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.model import Equilibrium, RollerBearing
from quasidynamic.parts.bearing import CylindricalRollerBearing
from quasidynamic.parts.cage import Cage
from quasidynamic.parts.lubricant import Lubricant
from quasidynamic.parts.material import Material
from quasidynamic.parts.oils import oil_at
from quasidynamic.parts.operation import Operation
from quasidynamic.parts.roller import Crowned, Logarithmic, Profile, Roller, Straight

__all__ = [
    "Cage",
    "Crowned",
    "CylindricalRollerBearing",
    "Equilibrium",
    "ImpossiblePart",
    "Logarithmic",
    "Lubricant",
    "Material",
    "NotSolved",
    "Operation",
    "OutOfRange",
    "Profile",
    "Roller",
    "RollerBearing",
    "Straight",
    "oil_at",
]
