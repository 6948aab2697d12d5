"""The cage of fast balls in oil."""

from math import pi
from typing import Literal

from flexbearing.case.cage_land import CageOnLand
from flexbearing.case.quantity import Length, impossible, key


class BallCage(CageOnLand):
    """The cage: concentric, with round pockets."""

    guidance: Literal["outer", "inner", "balls"] = key("what the cage runs on: a ring's land or the balls")
    pocket_clearance: Length = key(
        "from a centred ball to the wall of its pocket, half the difference of the diameters",
        example="0.15 mm",
        gt=0,
    )
    pocket_friction: float = key("Coulomb friction between ball and pocket", example=0.05, ge=0, le=1)

    def require_room(self, pitch: float, diameter: float, balls: int) -> None:
        """Raise where pockets are wider than the place between balls, or a land is not beside them [m]."""
        gap = pi * pitch / balls - diameter
        if 2 * self.pocket_clearance >= gap:
            allowed = f"below {5e2 * gap:.4g} mm, half the gap between balls"
            raise impossible("cage.pocket_clearance", allowed)
        if self.land_diameter is None or self.land_clearance is None:
            return
        if self.land_clearance >= diameter:
            most = f"below {1e3 * diameter:.4g} mm, bearing.ball.diameter; is the unit right?"
            raise impossible("cage.land_clearance", most)
        ends = {"outer": (pitch, pitch + diameter), "inner": (pitch - diameter, pitch)}[self.guidance]
        if not ends[0] <= self.land_diameter <= ends[1]:
            allowed = f"between {1e3 * ends[0]:.4g} and {1e3 * ends[1]:.4g} mm, beside the balls"
            raise impossible("cage.land_diameter", allowed)
