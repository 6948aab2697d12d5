"""The sections [outer] and [inner]: what carries the raceways."""

from math import pi
from typing import ClassVar, Literal, Self

from pydantic import model_validator

from flexbearing.case.quantity import Length, Section, impossible, key, require

NARROWEST_SLOT = 0.3e-3  # [m] between bars: below it the mesh generator may give up


class Outer(Section):
    """What carries the outer raceway; keys of another kind are ignored."""

    kind: Literal["rigid", "ring", "squirrel_cage"] = key(
        "rigid; a ring clamped at one side; or a ring on bars whose flange is clamped"
    )
    thickness: Length | None = key("radial thickness of the ring", None, gt=0)
    width: Length | None = key("axial width of the ring", None, gt=0)
    bars: int | None = key("number of bars", None, example=24, ge=1, le=200)
    bar_width: Length | None = key("tangential width of a bar", None, gt=0)
    bar_thickness: Length | None = key("radial thickness of a bar", None, gt=0)
    bar_length: Length | None = key("axial length of the bars", None, gt=0)
    flange_length: Length | None = key("axial length of the flange behind the bars", None, gt=0)

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "rigid":
            return self
        thickness, _ = require(self, ("thickness", "width"), f'outer.kind = "{self.kind}"')
        if self.kind == "squirrel_cage":
            names = ("bars", "bar_width", "bar_thickness", "bar_length", "flange_length")
            _, _, bar_thickness, _, _ = require(self, names, 'outer.kind = "squirrel_cage"')
            if bar_thickness >= thickness:
                raise impossible("bar_thickness", "below outer.thickness: the raceway ends before the bars")
        return self

    def require_room(self, raceway_diameter: float, roller_length: float) -> None:
        """Raise unless the ring is as wide as the rollers and its bars do not touch."""
        if self.kind == "rigid":
            return
        width, thickness = require(self, ("width", "thickness"), self.kind)
        if width < roller_length:
            raise impossible("width", "at least bearing.roller.length")
        if self.kind == "squirrel_cage":
            bars, bar_width, bar_thickness = require(self, ("bars", "bar_width", "bar_thickness"), self.kind)
            most = pi * (raceway_diameter + thickness - bar_thickness) / bars - NARROWEST_SLOT
            if bar_width > most:
                raise impossible("bar_width", f"at most {most * 1e3:.4g} mm, or the bars touch")


class Inner(Section):
    """What carries the inner raceway; keys of another kind are ignored."""

    kind: Literal["rigid", "ring_on_shaft"] = key(
        "rigid; or a ring bonded on a hollow shaft with both ends clamped"
    )
    bore: Length | None = key("bore of the ring, outside of the shaft", None, example="60 mm", gt=0)
    thickness: Length | None = key("radial thickness of the ring over its ribs", None, gt=0)
    width: Length | None = key("axial width of the ring", None, gt=0)
    track_width: Length | None = key("axial width of the raceway between the ribs", None, gt=0)
    shaft_thickness: Length | None = key("radial thickness of the hollow shaft", None, gt=0)
    shaft_length: Length | None = key(
        "length of the shaft between its clamped ends", None, example="40 mm", gt=0
    )

    _dimensions: ClassVar = ("bore", "thickness", "width", "track_width", "shaft_thickness", "shaft_length")

    @model_validator(mode="after")
    def _complete(self) -> Self:
        if self.kind == "rigid":
            return self
        bore, _, width, track_width, shaft_thickness, shaft_length = require(
            self, self._dimensions, 'inner.kind = "ring_on_shaft"'
        )
        if shaft_thickness >= bore / 2:
            raise impossible("shaft_thickness", "below half of inner.bore: the shaft is hollow")
        if track_width >= width:
            raise impossible("track_width", "below inner.width: the ribs need room")
        if shaft_length < width:
            raise impossible("shaft_length", "at least inner.width")
        return self

    def require_room(self, raceway_diameter: float, roller_length: float) -> None:
        """Raise unless the raceway lies between bore and ribs, and the rollers between the ribs."""
        if self.kind == "rigid":
            return
        bore, thickness, _, track_width, _, _ = require(self, self._dimensions, self.kind)
        if track_width < roller_length:
            raise impossible("track_width", "at least bearing.roller.length")
        if raceway_diameter <= bore:
            raise impossible("bore", f"below the inner raceway diameter {raceway_diameter * 1e3:.4g} mm")
        if raceway_diameter >= bore + 2 * thickness:
            least = (raceway_diameter - bore) / 2
            raise impossible("thickness", f"more than {least * 1e3:.4g} mm: ribs stand above the raceway")
