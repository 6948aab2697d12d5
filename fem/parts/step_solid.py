"""A ring with its seat as the user drew it, from a STEP file, as frozen data.

The drawing has coordinates of its own; lengths here are in metres all the same. The bearing's x runs
along its axis from the middle of the loaded band, z points to azimuth 0 and y completes the frame.
"""

from dataclasses import dataclass, field
from math import inf
from typing import ClassVar

import numpy as np

from fem.parts.groove import Groove
from fem.parts.material import Elastic, ImpossiblePart, require, require_positive
from fem.parts.quoted import shortened

BEGINNING = b"ISO-10303-21"  # of every STEP file
SQUARE = 1e-9  # allowed cosine between axis and zenith

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class Named:
    """All faces of one name, as the drawing program wrote it into the file."""

    name: str

    def __post_init__(self):
        require(bool(self.name), "name", self.name, "one that a face has")

    def __str__(self) -> str:
        return f'named "{shortened(self.name)}"'


@dataclass(frozen=True)
class Coloured:
    """All faces of one colour, as a screen shows it."""

    red: int  # 0 to 255
    green: int
    blue: int

    def __post_init__(self):
        for name in ("red", "green", "blue"):
            require(0 <= getattr(self, name) <= 255, name, getattr(self, name), "0 to 255")

    def __str__(self) -> str:
        return f"of colour #{self.red:02x}{self.green:02x}{self.blue:02x}"


@dataclass(frozen=True)
class Near:
    """The one face that a point lies on or close to."""

    x: float  # [m] in the coordinates of the drawing
    y: float
    z: float

    def __str__(self) -> str:
        return f"near ({self.x * 1e3:.6g}, {self.y * 1e3:.6g}, {self.z * 1e3:.6g}) mm"


Pick = Named | Coloured | Near


@dataclass(frozen=True, kw_only=True)
class StepSolid:
    """One solid of a STEP file that carries a raceway and is clamped somewhere.

    The raceway is a cylinder about the axis, on which the loaded band fits; it is cut out exactly. Or it is a
    groove of one arc around balls, drawn at least as far as its lands.
    """

    outward: ClassVar[int] = 1  # sign of the radial direction from rollers or balls into the part

    drawing: bytes = field(repr=False)  # content of the file; any length unit, it knows its own
    raceway_diameter: float  # [m] of the bearing; the drawn one may differ a little and is used; of lands
    clamps: tuple[Pick, ...]  # faces that do not move
    elastic: Elastic
    raceway: Pick | None = None  # None: the one cylinder of this diameter about the axis
    centre: Vector = (0.0, 0.0, 0.0)  # [m] middle of the loaded band in the drawing
    axis: Vector = (1.0, 0.0, 0.0)  # direction of the bearing's x in the drawing
    zenith: Vector = (0.0, 0.0, 1.0)  # direction of azimuth 0 in the drawing, at right angles to the axis
    scale: float = 1.0  # [-] size over drawn size, for a hot part
    groove: Groove | None = None  # for balls; None: a raceway for rollers
    low_land: float | None = None  # [m] radius of the land at -x where it is another one
    source: str = field(default="STEP drawing", compare=False)  # how messages call it

    def __post_init__(self):
        if not self.drawing.lstrip().startswith(BEGINNING):
            raise ImpossiblePart(f'{self.source} is no STEP file: it does not begin with "ISO-10303-21"')
        require_positive(self, "raceway_diameter", "scale")
        require(len(self.clamps) > 0, "clamps", self.clamps,
                "one face or more: nothing holds the structure against any load")  # fmt: skip
        self._require_frame()

    def _require_frame(self):
        directions = [np.array(v, dtype=float) for v in (self.axis, self.zenith)]
        for name, direction in zip(("axis", "zenith"), directions, strict=True):
            size = np.linalg.norm(direction)
            require(0 < float(size) < inf, name, getattr(self, name), "a finite direction longer than zero")
        require(bool(np.isfinite(self.centre).all()), "centre", self.centre, "a finite point")
        axis, zenith = (direction / np.linalg.norm(direction) for direction in directions)
        require(
            float(abs(axis @ zenith)) < SQUARE,
            "zenith",
            self.zenith,
            f"at right angles to axis = {self.axis}",
        )

    def arc(self, groove: Groove) -> tuple[float, float]:
        """Contact angles [rad] between which the lands leave a groove."""
        land = self.raceway_diameter / 2
        return -groove.end(self.low_land or land, 1), groove.end(land, 1)

    @property
    def track(self) -> float:
        """Axial length on which rollers can run [m]; infinite, as only the opened drawing can tell."""
        return inf

    @property
    def materials(self) -> dict[str, Elastic]:
        """Material of every named body; "ring" carries the raceway."""
        return {"ring": self.elastic}
