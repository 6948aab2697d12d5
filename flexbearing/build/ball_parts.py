"""Balls and grooves of a case, as the bearing physics takes them."""

import quasidynamic as qd
from flexbearing.case.balls.parts import BallBearing
from flexbearing.case.materials import Elastic, HeavyElastic

_UNFELT = 7850.0  # [kg/m3] stands where no inertia is felt: any density gives the same


def ball(bearing: BallBearing, material: Elastic) -> qd.Ball:
    """The balls."""
    return qd.Ball(diameter=bearing.ball.diameter, material=solid(material))


def groove(bearing: BallBearing, ring: str, material: Elastic) -> qd.Groove:
    """Groove of a ring, "inner" or "outer"."""
    conformity = getattr(bearing, ring).over(bearing.ball.diameter)
    return qd.Groove(conformity=conformity, material=solid(material))


def solid(material: Elastic) -> qd.Material:
    """The material; rings and slow balls have no density of their own."""
    density = material.density if isinstance(material, HeavyElastic) else _UNFELT
    return qd.Material(
        youngs_modulus=material.youngs_modulus, poisson_ratio=material.poisson_ratio, density=density
    )
