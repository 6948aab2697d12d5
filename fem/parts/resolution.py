"""How a part is discretised, and how finely, as frozen data."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from fem.parts.groove import BallPatches, Stations
from fem.parts.material import ImpossiblePart, require, require_positive
from fem.parts.rings import MIDDLE, MeshSize, Patches


def neighbour(order: int) -> int:
    """Order whose answers tell the error of those of another: one less, above 2; else one more."""
    return order - 1 if order > 2 else order + 1


def row_places(distance: float) -> tuple[float, ...]:
    """Axial places of two rows of rollers at a distance [m]; of one, where that is zero."""
    return (-distance / 2, distance / 2) if distance else MIDDLE


class Discretisation(StrEnum):
    """Which numbers stand for a part and for the loads on its raceway."""

    HARMONICS = "harmonics"  # azimuthal harmonics: on an axial section, or on half a pitch of a squirrel cage
    SMEARED = "smeared"  # the same of a squirrel cage, its bars spread evenly over an axial section
    BEAM = "beam"  # harmonics of a curved beam on springs, without a mesh
    SOLID = "solid"  # the whole solid, for rollers or balls at given azimuths


@dataclass(frozen=True, kw_only=True)
class Shape:
    """A part, perhaps one in a fit, with the band that rollers load."""

    part: Any
    length: float  # l of the band [m]
    row_distance: float = 0.0  # [m] between the middles of the bands of two rows of rollers; 0: one row

    @property
    def rows(self) -> tuple[float, ...]:
        """Axial places of the middles of the bands [m]."""
        return row_places(self.row_distance)


@dataclass(frozen=True, kw_only=True)
class Resolution:
    """How finely a raceway and its part are resolved; a beam needs no mesh, a solid needs azimuths."""

    length: float  # l of a loaded band, or width of a groove [m]
    axial_modes: int = 1  # M, Legendre polynomials along a band that carry forces and displacements
    mesh_size: MeshSize | None = None
    harmonics: int | None = None  # N, the highest; None: what part and band need, or the mesh resolves
    azimuths: Sequence[float] | None = None  # (Z,) [rad] of the rollers or balls on a solid
    patch_width: float | None = None  # [m] of a loaded patch, standard deviation along the arc
    threads: int = field(default=2, compare=False)  # of NGSolve, for a solid
    stations: Stations | None = None  # on the arcs of a groove, in place of a band and its axial modes
    nodes_of: Shape | None = None  # of the same kind: its mesh is taken, with its nodes moved; None: no other
    row_distance: float = 0.0  # [m] between the middles of the bands of two rows of rollers; 0: one row
    along: bool = False  # whether a uniform force along the raceway is a shape, after the axial modes
    first_order: bool = False  # for derivatives: of a cage in space right to first order of what moves alone

    def __post_init__(self):
        require_positive(self, "length")
        least = 2 if self.row_distance else 1
        require(self.axial_modes >= least, "axial_modes", self.axial_modes, f"{least} or more")
        require(
            self.nodes_of is not None or not self.first_order, "first_order", True, "False without nodes_of"
        )
        if self.azimuths is not None:
            object.__setattr__(self, "azimuths", tuple(float(phi) for phi in self.azimuths))

    @property
    def rows(self) -> tuple[float, ...]:
        """Axial places of the middles of the loaded bands [m]."""
        return row_places(self.row_distance)

    @property
    def mesh(self) -> MeshSize:
        """Element sizes.

        Raises `ImpossiblePart` if none are given.
        """
        if self.mesh_size is None:
            raise ImpossiblePart("mesh_size = None is impossible; allowed is a MeshSize, but for a beam")
        return self.mesh_size

    @property
    def patches(self) -> Patches | BallPatches:
        """Loaded patches on a solid; of balls where there are stations.

        Raises `ImpossiblePart` if the rollers have no azimuths, or the patches no width.
        """
        if self.azimuths is not None and self.stations is not None:
            return BallPatches(azimuths=self.azimuths, length=self.length, stations=self.stations)
        if self.azimuths is None or self.patch_width is None:
            raise ImpossiblePart(
                f"azimuths = {self.azimuths}, patch_width = {self.patch_width} are impossible for a solid; "
                "allowed are the azimuths of all rollers, and the width of the patches they load"
            )
        return Patches(
            azimuths=self.azimuths,
            length=self.length,
            axial_modes=self.axial_modes,
            width=self.patch_width,
        )
