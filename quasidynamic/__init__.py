"""Bearings: rollers or balls, raceways, film, traction and cage, with NumPy and SciPy alone.

What others may use is listed here and loaded when it is requested: a roller bearing loads no ball code, a
ball bearing no roller solver.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from quasidynamic.angular_contact import AngularContactBallBearing as AngularContactBallBearing
    from quasidynamic.contact.film.thickness import FORMULAS as FORMULAS
    from quasidynamic.contact.lubrication import Lubrication as Lubrication
    from quasidynamic.contact.traction.adore import AdoreType as AdoreType
    from quasidynamic.contact.traction.measured_curve import FourPointCurve as FourPointCurve
    from quasidynamic.contact.traction.mixed import Mixed as Mixed
    from quasidynamic.contact.traction.rheology import BairWiner as BairWiner, Eyring as Eyring
    from quasidynamic.contact.traction.traction_law import Regression4109 as Regression4109
    from quasidynamic.errors import (
        ImpossiblePart as ImpossiblePart,
        NotSolved as NotSolved,
        OutOfRange as OutOfRange,
    )
    from quasidynamic.four_point import (
        FourPointBallBearing as FourPointBallBearing,
        RingLoad as RingLoad,
    )
    from quasidynamic.many_elastic import solve_many_elastic as solve_many_elastic
    from quasidynamic.outcome.angular_contact_state import AngularContactState as AngularContactState
    from quasidynamic.outcome.fast_balls import FastRollingBalls as FastRollingBalls
    from quasidynamic.outcome.slow_balls import RollingBalls as RollingBalls, SlidingBalls as SlidingBalls
    from quasidynamic.parts.angular_contact_bearing import (
        AngularContactBearing as AngularContactBearing,
        RingOperation as RingOperation,
    )
    from quasidynamic.parts.ball import (
        Ball as Ball,
        FourPointBearing as FourPointBearing,
        FrictionCurve as FrictionCurve,
        Groove as Groove,
        constant_friction as constant_friction,
    )
    from quasidynamic.parts.material import Material as Material
    from quasidynamic.parts.oil_properties import Lubricant as Lubricant, oil_at as oil_at
    from quasidynamic.parts.profile import (
        Crowned as Crowned,
        Logarithmic as Logarithmic,
        LogarithmicCrown as LogarithmicCrown,
        PointsProfile as PointsProfile,
        Profile as Profile,
        Straight as Straight,
        TangentCrowned as TangentCrowned,
    )
    from quasidynamic.parts.roller_bearing import (
        Cage as Cage,
        CylindricalRollerBearing as CylindricalRollerBearing,
        Operation as Operation,
        Ribs as Ribs,
        Roller as Roller,
        RollerRow as RollerRow,
    )
    from quasidynamic.parts.tapered_bearing import (
        Rib as Rib,
        TaperedRollerBearing as TaperedRollerBearing,
    )
    from quasidynamic.roller import (
        Equilibria as Equilibria,
        Equilibrium as Equilibrium,
        RollerBearing as RollerBearing,
        solve_many as solve_many,
    )
    from quasidynamic.solve.balls.preloaded_place import (
        preloaded_place as preloaded_place,
        unloading_force as unloading_force,
    )
    from quasidynamic.solve.step_length import SolverOutcome as SolverOutcome
    from quasidynamic.static import static_loads as static_loads
    from quasidynamic.tapered import TaperedLoads as TaperedLoads, tapered_loads as tapered_loads

EXPORTS = {
    "angular_contact": ("AngularContactBallBearing",),
    "contact.film.thickness": ("FORMULAS",),
    "contact.lubrication": ("Lubrication",),
    "contact.traction.adore": ("AdoreType",),
    "contact.traction.measured_curve": ("FourPointCurve",),
    "contact.traction.mixed": ("Mixed",),
    "contact.traction.rheology": ("BairWiner", "Eyring"),
    "contact.traction.traction_law": ("Regression4109",),
    "errors": ("ImpossiblePart", "NotSolved", "OutOfRange"),
    "four_point": ("FourPointBallBearing", "RingLoad"),
    "many_elastic": ("solve_many_elastic",),
    "outcome.angular_contact_state": ("AngularContactState",),
    "outcome.fast_balls": ("FastRollingBalls",),
    "outcome.slow_balls": ("RollingBalls", "SlidingBalls"),
    "parts.angular_contact_bearing": ("AngularContactBearing", "RingOperation"),
    "parts.ball": ("Ball", "FourPointBearing", "FrictionCurve", "Groove", "constant_friction"),
    "parts.material": ("Material",),
    "parts.oil_properties": ("Lubricant", "oil_at"),
    "parts.profile": (
        "Crowned",
        "Logarithmic",
        "LogarithmicCrown",
        "PointsProfile",
        "Profile",
        "Straight",
        "TangentCrowned",
    ),
    "parts.roller_bearing": ("Cage", "CylindricalRollerBearing", "Operation", "Ribs", "Roller", "RollerRow"),
    "parts.tapered_bearing": ("Rib", "TaperedRollerBearing"),
    "roller": ("Equilibria", "Equilibrium", "RollerBearing", "solve_many"),
    "solve.balls.preloaded_place": ("preloaded_place", "unloading_force"),
    "solve.step_length": ("SolverOutcome",),
    "static": ("static_loads",),
    "tapered": ("TaperedLoads", "tapered_loads"),
}


def __getattr__(name: str) -> Any:
    """Load a public name with its module."""
    for module, names in EXPORTS.items():
        if name in names:
            value = globals()[name] = getattr(import_module(f"{__name__}.{module}"), name)
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(name for names in EXPORTS.values() for name in names)
