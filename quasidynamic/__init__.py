"""The bearing: rollers, raceways, film, traction and cage, with NumPy and SciPy alone."""

from quasidynamic.contact.adore import AdoreType
from quasidynamic.contact.curve import FourPointCurve
from quasidynamic.contact.film import FORMULAS
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.mixed import Mixed
from quasidynamic.contact.rheology import BairWiner, Eyring
from quasidynamic.contact.traction import Regression4109
from quasidynamic.errors import ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.model import Equilibria, Equilibrium, RollerBearing
from quasidynamic.parts.bearing import CylindricalRollerBearing
from quasidynamic.parts.cage import Cage
from quasidynamic.parts.lubricant import Lubricant
from quasidynamic.parts.material import Material
from quasidynamic.parts.oils import oil_at
from quasidynamic.parts.operation import Operation
from quasidynamic.parts.roller import Crowned, Logarithmic, Profile, Roller, Straight
from quasidynamic.solve.endings import Ending
from quasidynamic.static import static_loads

__all__ = [
    "FORMULAS",
    "AdoreType",
    "BairWiner",
    "Cage",
    "Crowned",
    "CylindricalRollerBearing",
    "Ending",
    "Equilibria",
    "Equilibrium",
    "Eyring",
    "FourPointCurve",
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
    "Roller",
    "RollerBearing",
    "Straight",
    "oil_at",
    "static_loads",
]
