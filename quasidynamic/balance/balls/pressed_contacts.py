"""Pressure over the contacts of a ball: that of Hertz, or one computed on the true arcs."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.ellipse.full_sliding import Ellipse
from quasidynamic.contact.half_space import CellGrid, grid_over
from quasidynamic.contact.pressure import PressedGroove
from quasidynamic.contact.rolling.full_sliding import hertz_pressure
from quasidynamic.motion.ball_slip import DIAGONAL


@dataclass(frozen=True)
class PressedContacts:
    """C contacts on cells."""

    grids: tuple[CellGrid, ...]
    pressure: NDArray  # (C, nx, ny) [Pa]
    position: NDArray  # (C, ny) [m] of the cells across, from the contact normal
    cut: NDArray  # (C) whether a shoulder cuts the contact


def hertz_contacts(ellipse: Ellipse, load: NDArray, cells: tuple[int, int]) -> PressedContacts:
    """Ellipses of C contacts by Hertz under loads [N]; places across are distances from the contact normal.

    Source
    ------
    Jones (1959), J. Basic Eng. 81, 1-12: slip on the chord of the pressed arc.
    """
    semi_axes = [(float(a), float(b)) for a, b in zip(ellipse.along, ellipse.across, strict=True)]
    grids = tuple(grid_over(each, cells) for each in semi_axes)
    pressure = np.stack([hertz_pressure(*each) for each in zip(grids, semi_axes, load, strict=True)])
    position = np.stack([grid.centres[1][0] for grid in grids])
    return PressedContacts(grids, pressure, position, np.zeros(len(grids), dtype=bool))


def groove_contacts(
    grooves: tuple[PressedGroove, ...], diagonal: NDArray, cells: tuple[int, int]
) -> PressedContacts:
    r"""Contacts on the true arcs, whose places across are arc lengths.

    .. math:: x = R \sin(y/R)

    Shoulders lie towards negative places across on the first diagonal.

    Source
    ------
    Geometry of an arc.
    """
    grids, pressures = zip(*(groove.on(cells) for groove in grooves), strict=True)
    towards = [slice(None, None, -int(DIAGONAL[each])) for each in diagonal]
    pressure = [each[:, order] for each, order in zip(pressures, towards, strict=True)]
    radius = np.array([[each.groove.section_radius] for each in grooves])
    arcs = np.stack([grid.centres[1][0] for grid in grids])
    cut = np.array([each.groove.cut(each.contact) for each in grooves])
    return PressedContacts(grids, np.stack(pressure), radius * np.sin(arcs / radius), cut)
