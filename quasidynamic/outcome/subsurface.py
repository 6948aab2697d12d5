"""Stresses below the most pressed contact of both raceways."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.section_stress import SectionStress

CELLS = (96, 160)  # of the field, down and along
DEEP, WIDE = 2.4, 2.0  # of the field, in half-widths of the contact: its depth, and to either side
SEARCHED = (40, 40)  # cells of grids on which the largest value is sought
FINER, ZOOMS = 4.0, 7  # of these grids, one after the other

Stress = Callable[[NDArray, NDArray], SectionStress]  # over the peak pressure, at places over the half-width


@dataclass(frozen=True)
class Subsurface:
    """Stress in the plane of rolling below a contact of the inner and of the outer raceway."""

    positions: NDArray  # (2, W) [m] middles of the cells along the rolling direction, from mid-contact
    depths: NDArray  # (2, D) [m] middles of the cells below the surface
    von_mises: NDArray  # (2, D, W) [Pa]
    shear: NDArray  # (2, D, W) [Pa] orthogonal shear stress
    largest: NDArray  # (2) [Pa] of the von Mises stress, between the cells
    largest_depth: NDArray  # (2) [m]
    friction: NDArray  # (2) [-] traction over load


def below(
    stresses: Sequence[Stress], pressure: NDArray, half_width: NDArray, friction: NDArray | None = None
) -> Subsurface:
    """Stress field below the inner and the outer contact, under the largest pressures (2) [Pa].

    b (2) is along the rolling direction [m]; `friction` (2) is the traction over load [-] that the stresses
    were computed with.

    Source
    ------
    `line_contact_stress` and `ellipse_stress`.
    """
    down, wide = CELLS
    depth = (np.arange(down) + 0.5) / down * DEEP
    along = ((np.arange(wide) + 0.5) / wide * 2 - 1) * WIDE
    fields = [stress(*np.meshgrid(along, depth)) for stress in stresses]
    most = np.array([largest_von_mises(stress) for stress in stresses])
    size = pressure[:, None, None]
    return Subsurface(
        positions=half_width[:, None] * along,
        depths=half_width[:, None] * depth,
        von_mises=size * np.array([field.von_mises for field in fields]),
        shear=size * np.array([field.shear for field in fields]),
        largest=pressure * most[:, 0],
        largest_depth=half_width * most[:, 1],
        friction=np.zeros(2) if friction is None else friction,
    )


def largest_von_mises(stress: Stress) -> tuple[float, float]:
    """Largest von Mises stress over the peak pressure and its depth over the half-width.

    Source
    ------
    Finer and finer grids over place and root of the depth, as friction may bring the largest stress to the
    surface; the last one has cells of 1e-5 of a half-width [-].
    """
    down, wide = SEARCHED
    middle, half = (np.sqrt(DEEP) / 2, 0.0), (np.sqrt(DEEP) / 2, WIDE)
    for _ in range(ZOOMS):
        lowest = max(middle[0] - half[0], 0.0)
        root = lowest + (np.arange(down) + 0.5) / down * (middle[0] + half[0] - lowest)
        along = middle[1] + ((np.arange(wide) + 0.5) / wide * 2 - 1) * half[1]
        values = stress(*np.meshgrid(along, root**2)).von_mises
        row, column = np.unravel_index(values.argmax(), values.shape)
        middle, half = (float(root[row]), float(along[column])), (half[0] / FINER, half[1] / FINER)
    return float(values[row, column]), middle[0] ** 2
