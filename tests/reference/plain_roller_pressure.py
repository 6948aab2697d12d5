"""A roller on a raceway, both elastic half-spaces, on one page: dense, on cells that are finer at the ends.

Written from Boussinesq's point load alone, without the program: displacements by Love's integral over each
rectangle, cells under pressure found by leaving out those that pull and taking in those that overlap.
"""

from dataclasses import dataclass

import numpy as np

ROUNDS = 60  # sets of cells
GROWTH, GROWING = 1.12, 28  # of the cells along the roller from one to the next, and how many grow


@dataclass(frozen=True)
class PlainPressure:
    """Pressure on the half x > 0 of a contact; y along the roller from its middle."""

    y: np.ndarray  # (n) middles of the cells along the roller [m]
    widths: np.ndarray  # (n) of them [m]
    pressure: np.ndarray  # (m, n) [Pa], the first row next to the axis
    line_load: np.ndarray  # (n) [N/m]
    moment: float  # [N m] about mid-roller

    @property
    def peak(self):
        """Largest pressure [Pa]."""
        return self.pressure.max()

    @property
    def place(self):
        """Where it stands along the roller [m]."""
        return self.y[self.pressure.max(axis=0).argmax()]

    @property
    def at_end(self):
        """Whether the last cell of either end is pressed."""
        return bool(self.line_load[0] > 0 or self.line_load[-1] > 0)


@dataclass(frozen=True)
class Cells:
    """Rectangles on the half x > 0, row by row."""

    x: np.ndarray  # middles [m]
    y: np.ndarray
    half_x: np.ndarray  # half widths [m]
    half_y: np.ndarray

    @classmethod
    def between(cls, across, along):
        """Cells between borders across and along [m]."""
        grid = (
            [(ends[1:] + ends[:-1]) / 2 for ends in (across, along)],
            [np.diff(e) / 2 for e in (across, along)],
        )
        (x, y), (half_x, half_y) = (np.meshgrid(*both, indexing="ij") for both in grid)
        return cls(*(each.ravel() for each in (x, y, half_x, half_y)))

    def influence(self, modulus):
        """Displacement of each cell by a unit pressure on each other one and its image at -x [m/Pa]."""
        along, halves = self.y[:, None] - self.y, (self.half_x, self.half_y)
        both = [integral(self.x[:, None] + side * self.x, along, *halves) for side in (-1, 1)]
        return (both[0] + both[1]) / (np.pi * modulus)


def integral(x, y, half_x, half_y):
    """Integral of 1/r over a rectangle around the origin, seen from x, y [m]."""

    def corner(x, y):
        with np.errstate(divide="ignore", invalid="ignore"):
            first = np.where(x == 0, 0.0, x * np.arcsinh(y / np.abs(x)))
            return first + np.where(y == 0, 0.0, y * np.arcsinh(x / np.abs(y)))

    right, left, far, near = x + half_x, x - half_x, y + half_y, y - half_y
    return corner(right, far) - corner(left, far) - corner(right, near) + corner(left, near)


def graded(length, count):
    """Borders of cells that grow from both ends towards the middle [m]."""
    growing = GROWTH ** np.minimum(np.arange(count // 2), GROWING)
    half = np.cumsum(np.r_[0.0, growing]) / growing.sum() * length / 2
    return np.r_[half - length / 2, length / 2 - half[-2::-1]]


def plain_pressure(*, force, tilt, radius, length, modulus, drop, cells=(12, 72)):
    """Pressure under a force [N] at a tilt [rad].

    `modulus` is E* with 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [Pa], `radius` the reduced one [m], `drop` the
    gap of the profile [m] at places y [m].
    """
    along, width = graded(length, cells[1]), 2.0 * np.sqrt(4 * force / length * radius / (np.pi * modulus))
    for _ in range(8):
        on = Cells.between(np.linspace(0, width, cells[0] + 1), along)
        gap = on.x**2 / (2 * radius) + drop(on.y) - tilt * on.y
        pressure = touching_pressure(on, gap, on.influence(modulus), force).reshape(cells)
        if not pressure[-1].any():
            line_load = 4 * on.half_x[0] * pressure.sum(axis=0)
            y, widths = on.y[: cells[1]], np.diff(along)
            return PlainPressure(y, widths, pressure, line_load, float(line_load @ (widths * y)))
        width *= 1.3
    raise RuntimeError("the contact remains wider than its cells")


def touching_pressure(on, gap, influence, force):
    """Pressure of the cells [Pa]: zero or more where surfaces meet, none where a gap is left."""
    area, touching = 8 * on.half_x * on.half_y, gap < gap.min() + 0.5 * np.ptp(gap)
    for _ in range(ROUNDS):
        inside = np.flatnonzero(touching)
        matrix = np.block(
            [[influence[np.ix_(inside, inside)], -np.ones((len(inside), 1))], [area[inside], 0.0]]
        )
        *found, approach = np.linalg.solve(matrix, np.r_[-gap[inside], force])
        pressure = np.zeros_like(gap)
        pressure[inside] = found
        pulls = pressure < 0
        overlaps = ~touching & (gap + influence @ pressure < approach)
        if not pulls.any() and not overlaps.any():
            return pressure
        # Cells that overlap join when none pulls, or sets would alternate.
        touching = touching & ~pulls if pulls.any() else touching | overlaps
    raise RuntimeError("no set of cells under pressure was found")
