"""The parts of a ball bearing of any kind."""

from math import asin, pi
from typing import Annotated, Literal, Self

from pydantic import Strict, model_validator

from flexbearing.case.quantity import (
    Force,
    Length,
    Moment,
    Section,
    impossible,
    in_mm,
    key,
    require_one,
)

AXES_CHANGED = 'axes changed: x axial, z along the load, azimuth from z to y, see "Axes and signs"'
LOAD = {  # former keys, and what has taken their place
    "operation.load.radial_x": f"operation.load.radial_z; {AXES_CHANGED}",
    "operation.load.moment_x": f"operation.load.moment_z, with the opposite sign; {AXES_CHANGED}",
}
ONE_FRICTION = {
    "operation.friction": "friction.coefficient, one for every use",
    "rolling_lines.coefficient": "friction.coefficient, one for every use",
}
DISPLACEMENT = {
    "operation.displacement.radial_x": f"operation.displacement.radial_z; {AXES_CHANGED}",
    "operation.displacement.tilt_x": f"operation.displacement.tilt_z, with the opposite sign; {AXES_CHANGED}",
}
AS_CLEARANCE = {
    f"bearing.{name}": "An interference of balls and races is a negative bearing.clearance."
    for name in ("preload", "interference")
}
PLACES = {  # what people look for in [bearing], and where it is
    "bearing.preload": "A preload is in [operation.preload]: force or displacement; that of springs is "
    "operation.load.axial. An interference of balls and races is a negative bearing.clearance.",
    "bearing.interference": "An interference of balls and races is a negative bearing.clearance, of deep "
    "groove and four-point bearings.",
}
NO_CLASSES = {  # what people look for, and what to do instead
    "bearing.clearance_class": 'Classes of clearance are offered for kind = "cylindrical_roller" and '
    '"deep_groove_ball": for other ball bearings there is no printed table here.',
}
RIGHT_ANGLE = pi / 2  # [rad]
CLOSEST = 0.5001  # conformity: closer grooves touch the ball all around, usual are 0.505 and more
Number = Annotated[float, Strict()]  # of a list, which is not strict itself: TOML's lists are no tuples
Whole = Annotated[int, Strict()]
SPIN = (
    "spin that makes slip across in the contacts, with every friction.model: centre, that of their middle "
    "everywhere, as Jones; local, at each point that about the normal there, as of rigid bodies"
)


FrictionModel = Literal["full_sliding", "fastsim", "kalker"]
MODEL = (
    "full_sliding: contacts slide everywhere; kalker: they stick and slip on half-spaces; fastsim: "
    "the same on springs, quicker and less exact"
)
CELLS = (
    "cells over each contact along and across the rolling direction, multiples of 4; the error is estimated "
    "from coarser grids"
)
USUAL_CELLS = [40, 80]
STICKING = {"model": ("fastsim", "kalker")}  # where cells count
INTERFACE = (
    "compliance of the interface between the surfaces: its elastic slip where the traction is friction times "
    "pressure, less below in proportion; none without the key"
)
MOST_CELLS = 400  # along or across a contact


def require_quarters(cells: tuple[int, ...]) -> None:
    """Require two numbers of cells that can be halved twice; raises `ValueError` otherwise."""
    if len(cells) != 2 or any(number % 4 or not 12 <= number <= MOST_CELLS for number in cells):
        raise impossible("cells", f"two multiples of four from 12 to {MOST_CELLS}")


class Ball(Section):
    """One ball."""

    diameter: Length = key("diameter of the balls", example="30 mm", ge=1e-4, le=10)


class Groove(Section):
    """A groove: its conformity or its radius."""

    conformity: float | None = key(
        "groove radius over ball diameter; half of a figure such as 1.05 that counts from the ball radius",
        None,
        example=0.52,
        ge=CLOSEST,
        le=10,
    )
    radius: Length | None = key("groove radius, instead of the conformity", None, example="15.75 mm", gt=0)

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        require_one(self, "conformity", "radius", "a groove without radius")
        return self

    def over(self, ball_diameter: float) -> float:
        """Groove radius over ball diameter [-]."""
        if self.conformity is not None:
            return self.conformity
        assert self.radius is not None  # checked on reading
        return self.radius / ball_diameter


class EndingGroove(Groove):
    """A groove that may end on a shoulder."""

    shoulder: Length | None = key(
        "height of the shoulder above the bottom of the groove, where arches meet if there are two; of both "
        "shoulders where there are two; contacts that reach over it are cut off there",
        None,
        example="4.5 mm",
        gt=0,
    )

    @property
    def shoulders(self) -> tuple[float | None, float | None]:
        """Heights of the shoulder that thrust presses and of the other one [m]; None of a groove without."""
        return self.shoulder, self.shoulder


class RingLoad(Section):
    """Load on the inner ring."""

    axial: Force = key("axial force along x", "0 N")
    radial_y: Force = key("radial force along y", "0 N")
    radial_z: Force = key("radial force along z, where azimuths begin", "0 N")
    moment_y: Moment = key("moment about y, by the right hand", "0 N m")
    moment_z: Moment = key("moment about z, by the right hand", "0 N m")

    @property
    def values(self) -> tuple[float, float, float, float, float]:
        """Fx, Fy, Fz [N], My, Mz [N m]."""
        return self.axial, self.radial_y, self.radial_z, self.moment_y, self.moment_z


class BallBearing(Section):
    """What ball bearings of every kind have."""

    pitch_diameter: Length = key(
        "diameter of the circle of the ball centres", example="500 mm", ge=1e-3, le=100
    )
    ball: Ball = key("the balls")
    inner: Groove = key("groove of the inner ring; of both its arches where there are two")
    outer: Groove = key("groove of the outer ring; of both its arches where there are two")

    @model_validator(mode="after")
    def _grooves_are_wider_than_balls(self) -> Self:
        if self.ball.diameter >= self.pitch_diameter:
            raise impossible("ball.diameter", f"below {in_mm(self.pitch_diameter)}, bearing.pitch_diameter")
        for name in ("inner", "outer"):
            if getattr(self, name).over(self.ball.diameter) < CLOSEST:
                raise impossible(
                    f"{name}.radius",
                    f"at least {in_mm(CLOSEST * self.ball.diameter)}, {CLOSEST:g} of bearing.ball.diameter",
                )
        return self

    def require_room(self, balls: int) -> None:
        """Raise when so many balls touch each other on the pitch circle."""
        # a hair less, as balls that just touch do not turn
        most = int(pi / asin(self.ball.diameter / self.pitch_diameter) * (1 - 1e-12))
        if balls > most:
            raise impossible("balls", f"at most {most}, or they touch on the pitch circle")
