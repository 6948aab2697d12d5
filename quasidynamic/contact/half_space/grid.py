"""Regular grid of rectangular cells over a contact."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True)
class CellGrid:
    """Rectangular cells of one size, symmetric about the origin."""

    spacing: tuple[float, float]  # [m] sides of a cell along x and y
    shape: tuple[int, int]  # cells along x and y

    def __post_init__(self):
        for side in self.spacing:
            require_positive("grid.spacing", side)
        if min(self.shape) < 1:
            raise ImpossiblePart(f"grid.shape = {self.shape} must be at least one cell in each direction")

    @property
    def cell_area(self) -> float:
        """Area of one cell [m2]."""
        return self.spacing[0] * self.spacing[1]

    @property
    def centres(self) -> tuple[NDArray, NDArray]:
        """Centres of the cells, x (nx, 1) and y (1, ny) [m]."""
        x, y = (
            side * (np.arange(cells) - (cells - 1) / 2)
            for side, cells in zip(self.spacing, self.shape, strict=True)
        )
        return x[:, None], y[None, :]


def grid_over(half_lengths: tuple[float, float], shape: tuple[int, int]) -> CellGrid:
    """Grid whose cells cover a rectangle of two half lengths [m] about the origin exactly.

    Parameters
    ----------
    half_lengths : pair of float
        of the rectangle along x and y [m]
    shape : pair of int
        cells along x and y

    Returns
    -------
    CellGrid

    Source
    ------
    Geometry.
    """
    spacing = (2 * half_lengths[0] / shape[0], 2 * half_lengths[1] / shape[1])
    return CellGrid(spacing, shape)
