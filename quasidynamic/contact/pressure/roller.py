"""A whole roller on a raceway: its pressure with both ends."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space import CellGrid, ElasticPair
from quasidynamic.contact.line import half_width
from quasidynamic.contact.pressure.normal_contact import (
    TOLERANCE,
    NormalCompliance,
    NormalContact,
    RigidMotions,
    contact_pressure,
)
from quasidynamic.errors import NotSolved, OutOfRange, require_positive

CELLS = (32, 512)  # across and along: 0.2 % of the peak pressure of profiled rollers, also near their ends
MARGIN = 1.5  # width of the grid over that of the contact under the mean load, and its growth where too small
OUTERMOST = 4  # cells along the roller too few for a pressure that rises to its end and falls again
WIDEST = 12  # times that the grid may grow


@dataclass(frozen=True)
class RollerPressure:
    """Pressure of a whole roller; y along its axis from mid-roller."""

    contact: NormalContact  # x along the rolling direction, y along the axis
    moment: float  # [N m] of the pressure about mid-roller, positive: more of it at +y
    approach: float  # [m] of distant points at mid-roller
    tilt: float  # [rad] positive: +y end pressed further in

    @property
    def positions(self) -> NDArray:
        """Middles of the cells along the axis (ny) [m]."""
        return self.contact.grid.centres[1][0]

    @property
    def line_load(self) -> NDArray:
        """Load per length along the axis (ny) [N/m]."""
        return self.contact.pressure.sum(axis=0) * self.contact.grid.spacing[0]

    @property
    def largest_along(self) -> NDArray:
        """Largest pressure across the contact, along the axis (ny) [Pa]."""
        return self.contact.pressure.max(axis=0)

    @property
    def peak_pressure(self) -> float:
        """Largest pressure [Pa]; at a sharp end that of a cell, see `at_ends`."""
        return self.contact.peak_pressure

    @property
    def at_ends(self) -> tuple[bool, bool]:
        """Whether the contact reaches the -y and the +y end of the roller, where pressure has no bound."""
        return self.contact.cut[1]

    @property
    def peak_at_ends(self) -> bool:
        """Whether the largest pressure is in the outermost cells of an end that the contact reaches.

        It then is that of cells at an end, not of the contact, and grows as they become smaller.
        """
        along = self.largest_along
        place = int(along.argmax())
        return (self.at_ends[0] and place < OUTERMOST) or (
            self.at_ends[1] and place >= len(along) - OUTERMOST
        )

    def slice_loads(self, count: int) -> NDArray:
        """Mean load per length (K) [N/m] of equal slices, from the cells that they share."""
        cells = len(self.line_load)
        summed = np.concatenate([[0.0], np.cumsum(self.line_load)]) / cells
        at_borders = np.interp(np.linspace(0, 1, count + 1), np.linspace(0, 1, cells + 1), summed)
        return np.diff(at_borders) * count

    def slice_pressure(self, count: int) -> NDArray:
        """Largest pressure (K) [Pa] on the cells that equal slices share, also in part."""
        along = self.largest_along
        ends = np.arange(count + 1) * len(along)
        first, last = ends[:-1] // count, -(-ends[1:] // count)
        return np.array([along[a:b].max() for a, b in zip(first, last, strict=True)])


@dataclass(frozen=True, kw_only=True)
class RollerOnRaceway:
    r"""A roller of given profile on a raceway, both elastic half-spaces.

    .. math:: h(x, y) = x^2/(2R) + C(y) - \delta - t\, y

    Source
    ------
    Geometry of two cylinders; elasticity and ends as in `contact_pressure`.

    Valid
    -----
    Half-width far below R. Roller and raceway are half-spaces, also below the ends of the roller, unless
    `free_ends` mirrors a share of the pressure there: that of the roller in the compliance of both makes its
    end faces free of shear, not of normal stress, the first step of Hetenyi, J. Appl. Mech. 37 (1970), 70-76.
    A sharp end, which the contact reaches, has the pressure of a rigid punch, without bound: its value is
    that of a cell, only loads per length converge.
    """

    pair: ElasticPair
    radius: float  # [m] R, reduced
    length: float  # [m] of the roller
    drop: Callable[[NDArray], NDArray]  # [m] C at places y [m] from mid-roller, profile and raceway together
    cells: tuple[int, int] = CELLS  # across and along
    tolerance: float = TOLERANCE  # of the pressure, see `contact_pressure`
    free_ends: float = 0.0  # [-] share of the pressure that is mirrored at the ends of the roller

    def __post_init__(self):
        for name in ("radius", "length"):
            require_positive(f"roller_on_raceway.{name}", getattr(self, name))

    def tilted(self, force: float, tilt: float) -> RollerPressure:
        """Pressure under a force [N] at a given tilt [rad]; its moment follows.

        Raises `OutOfRange`, `NotSolved` see `under`.
        """
        return self._widened(force, lambda grid: self._solved(grid, force, tilt=tilt))

    def under(self, force: float, moment: float) -> RollerPressure:
        """Pressure under a force [N] and its moment about mid-roller [N m]; approach and tilt follow.

        Raises `OutOfRange` for a force that is not above zero, or acts outside the length of the roller;
        `NotSolved` see `contact_pressure`; also where the contact remains wider than the grid.
        """
        half = self.length / 2 * (1 - 2 / self.cells[1])
        if not abs(moment) < force * half:
            raise OutOfRange(
                f"roller of {self.length:.4g} m: a force of {force:.4g} N with a moment of {moment:.4g} N m "
                f"acts outside its length; allowed are moments below {force * half:.4g} N m"
            )
        return self._widened(force, lambda grid: self._solved(grid, force, moment=moment))

    def _widened(self, force: float, solved: Callable[[CellGrid], RollerPressure]) -> RollerPressure:
        """Solve on grids that grow until the contact is narrower than the grid."""
        if not force > 0:
            raise OutOfRange(f"roller on a raceway: force = {force:.4g} N must be above zero")
        modulus = 2 / self.pair.plane_compliance
        width = 2 * MARGIN * float(half_width(force / self.length, self.radius, modulus))
        across, along = self.cells
        for _ in range(WIDEST):
            pressure = solved(CellGrid((width / across, self.length / along), self.cells))
            if not any(pressure.contact.cut[0]):
                return pressure
            width *= MARGIN
        raise NotSolved(f"roller on a raceway: the contact remains wider than a grid of {width:.3g} m")

    def _solved(
        self, grid: CellGrid, force: float, *, moment: float | None = None, tilt: float = 0.0
    ) -> RollerPressure:
        x, y = grid.centres
        gap = x**2 / (2 * self.radius) + self.drop(y) - tilt * y
        shapes = [np.ones(grid.shape)] + [np.broadcast_to(y, grid.shape)] * (moment is not None)
        loads = [force] + [moment] * (moment is not None)
        motions = RigidMotions(np.stack(shapes), np.array(loads))
        start = _strip(x / x[-1], y / y[:, -1:], (moment or 0.0) / (force * self.length / 2))
        compliance = NormalCompliance.of(self.pair, grid, self.free_ends)
        contact = contact_pressure(compliance, gap, motions, start, self.tolerance)
        approach, *turned = contact.motions
        carried = float((contact.pressure * y).sum() * grid.cell_area)
        return RollerPressure(contact, carried, float(approach), float(turned[0]) if turned else tilt)


def _strip(x: NDArray, y: NDArray, lever: float) -> NDArray:
    """Pressure (nx, ny) of a straight roller under a force at a lever, over the largest at mid-roller.

    Places and lever are over half of the grid; a load far from the middle is that of a triangle, as below an
    eccentric footing.
    """
    loaded = 3 * (1 - abs(lever))  # length of the triangle
    along = 1 + 3 * lever * y if loaded >= 2 else np.maximum(np.sign(lever) * y - 1 + loaded, 0)
    return np.sqrt(np.maximum(1 - (MARGIN * x) ** 2, 0)) * along
