"""Film, traction and friction of tapered rollers, at speeds of rollers and cage in balance with them."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.rollers.inclined_motion import InclinedMotion, MotionState
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.traction.film_strip import friction_intensity
from quasidynamic.errors import ImpossiblePart
from quasidynamic.parts.roller_bearing import FREE_POCKETS, Cage
from quasidynamic.solve.rollers.inclined_speeds import balanced_motion
from quasidynamic.tapered import TaperedLoads


@dataclass(frozen=True)
class TaperedFriction:
    """What rollers, rib and cage resist motion with, and where it becomes heat. Z rollers; inner first.

    Its results raise `NotSolved` where no speeds are in balance.

    Source
    ------
    `InclinedMotion`; the laws of rollers for every slice.

    Valid
    -----
    Friction has no part in the loads, and slip none in the forces of inertia.
    """

    loads: TaperedLoads
    lubrication: Lubrication
    rib_friction: float  # [-] Coulomb
    cage: Cage = FREE_POCKETS  # of every row

    def __post_init__(self):
        if not self.loads.operation.relative_speed:
            raise ImpossiblePart("friction of rings that turn alike, or not at all: nothing rolls")

    # -- motion --------------------------------------------------------------------------------

    @cached_property
    def motion(self) -> InclinedMotion:
        """Equations of the speeds."""
        loads, operation = self.loads, self.loads.operation
        return InclinedMotion(
            bearing=loads.bearing,
            slices=loads.slices,
            ring_speeds=(operation.inner_speed, operation.outer_speed),
            pure_rolling=loads.speeds,
            slice_loads=loads.slice_loads,
            rib_loads=loads.rib_loads,
            radius=np.array([loads.reduced_radius(race) for race in (0, 1)])[:, None],
            modulus=loads.moduli[:, None, None],
            lubrication=self.lubrication,
            rib_friction=self.rib_friction,
            cage=self.cage,
        )

    @cached_property
    def state(self) -> MotionState:
        """Rollers and cages in balance."""
        return balanced_motion(self.motion)

    @property
    def cage_speed(self) -> NDArray:
        """Speed of the cage of each row [rad/s]."""
        return self.state.orbit[:: self.loads.bearing.rollers]

    @property
    def cage_slip(self) -> float | None:
        """Lag of the cage behind pure rolling [-], of two rows the larger one; None where that is at rest."""
        if not self.loads.speeds.orbit:
            return None
        slips = 1 - self.cage_speed / self.loads.speeds.orbit
        return float(slips[np.abs(slips).argmax()])

    @property
    def roller_slip(self) -> NDArray:
        """Lag of the spins behind pure rolling (Z) [-]; 1 of a roller that does not spin."""
        return 1 - self.state.spin / self.loads.speeds.spin

    @property
    def loaded_film(self) -> NDArray:
        """Film of every slice (2, Z, K) [m], zero without load."""
        return np.where(self.loads.slice_loads > self.motion.smallest_load, self.state.film, 0.0)

    @cached_property
    def traction(self) -> NDArray:
        """Of the raceways on the rollers (2, Z) [N], along the motion."""
        return self.state.traction.sum(-1)

    # -- power ---------------------------------------------------------------------------------

    @property
    def torque(self) -> NDArray:
        """Torque that keeps the inner and the outer ring turning (2) [N m], with that of the lands."""
        torque, guide = self.state.on_raceways.sum(1), self.cage.guidance == "outer"
        torque[int(guide)] += self.state.land.sum()
        return torque

    @property
    def power(self) -> float:
        """Power that both rings put in [W]: heat of all causes and what `transport` is."""
        return float(self.torque @ self.motion.ring_speeds)

    @cached_property
    def sliding_heat(self) -> NDArray:
        """Heat of the sliding of each roller on both raceways (2, Z) [W]."""
        return (self.state.traction * self.state.sliding).sum(-1)

    @property
    def friction_intensity(self) -> NDArray:
        """Largest heat of sliding per area (2, Z) [W/m2] of the slices of each contact."""
        motion, pull = self.motion, self.state.traction / self.loads.slices.widths
        contact = motion.slice_loads, motion.radius, motion.modulus
        return friction_intensity(pull, self.state.sliding, *contact).max(-1)

    @cached_property
    def rolling_heat(self) -> NDArray:
        r"""Heat of the inlets of each roller (2, Z) [W], 2 R |u| of both surfaces.

        Source
        ------
        Work of the shear on both surfaces, whose mean speed is u.
        """
        return (2 * self.state.shear * self.state.rolling).sum(-1)

    @property
    def rib_heat(self) -> NDArray:
        """Heat of each roller's end on the rib (Z) [W]."""
        return self.state.rib_force * self.state.rib_sliding

    @property
    def drag_heat(self) -> NDArray:
        """Heat of the drag on each roller (Z) [W]."""
        return self.state.drag * self.state.orbit * self.loads.bearing.pitch_diameter / 2

    @property
    def churning_heat(self) -> NDArray:
        """Heat of the churning around each roller (Z) [W]."""
        return self.state.churning * self.state.spin

    @property
    def pocket_heat(self) -> NDArray:
        """Heat of each roller in its pocket (Z) [W]."""
        return self.state.pocket_brake * self.loads.bearing.roller.diameter / 2 * self.state.spin

    @property
    def land_heat(self) -> NDArray:
        """Heat of the land of the cage of each row [W]."""
        guide = self.motion.ring_speeds[self.cage.guidance == "outer"]
        return self.state.land * (guide - self.cage_speed)

    @property
    def transport(self) -> NDArray:
        """What differences of spins from roller to roller leave of the power (Z) [W]: not heat."""
        return self.state.transport * self.state.spin
