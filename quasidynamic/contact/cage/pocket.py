"""Force between a roller or a ball and its pocket in the cage."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import EXPONENT
from quasidynamic.errors import NotSolved

ITERATION_LIMIT = 60  # about ten are needed
TOLERANCE = 1e-12  # of the clearance
FILM_LOAD = 11 / 3  # [N] carried by the film when the roller has crossed the whole clearance
BALL_FILM_LOAD = 11.0  # [N] the same of a ball
BALL_EXPONENT = 1.5  # of the approach of ball and wall


class PocketForce(NamedTuple):
    """Force of a roller or ball on its pocket; the opposite acts on what is in it."""

    force: NDArray  # [N] signed like the displacement
    by_displacement: NDArray  # [N/m] > 0


def roller_on_pocket_force(displacement: NDArray, clearance: float, stop: NDArray | float) -> PocketForce:
    r"""Force of a roller on its pocket: a linear film, then also the elastic wall.

    .. math:: F = \frac{11}{3 C_p} z + \operatorname{sign}(z)\, K \max(|z| - C_p,\, 0)^{10/9}

    Parameters
    ----------
    displacement : array (...)
        z, roller centre from the pocket centre along the motion [m]
    clearance : float
        C_p, distance to either wall from the centre [m], > 0
    stop : array (...)
        K of one wall [N/m^(10/9)], > 0; by `palmgren(roller, cage, length)` times the length

    Returns
    -------
    PocketForce
        odd; the stiffness is continuous, but leaves its film value infinitely steeply at |z| = C_p

    Source
    ------
    Film: linear stiffness of quasi-dynamic roller bearing programs. Wall: Palmgren (1959), line contact.

    Valid
    -----
    The film carries 11 N / 3 at the wall with any oil, speed and size: a number to calibrate.
    """
    return _pocket_force(displacement, clearance, stop, (FILM_LOAD, EXPONENT))


def ball_on_pocket_force(displacement: NDArray, clearance: float, stop: NDArray | float) -> PocketForce:
    r"""Force of a ball on its round pocket: a linear film, then also the elastic wall.

    .. math:: F = \frac{11}{C_p} z + \operatorname{sign}(z)\, K \max(|z| - C_p,\, 0)^{3/2}

    Parameters
    ----------
    displacement : array (...)
        z, ball centre from the pocket centre along the orbit [m]
    clearance : float
        C_p, distance to the wall from the centre, half the difference of the diameters [m], > 0
    stop : array (...)
        K of the wall [N/m^1.5], > 0

    Returns
    -------
    PocketForce
        odd; the stiffness is continuous

    Source
    ------
    Linear film and Hertz wall of quasi-dynamic ball bearing programs, in which the film stays at 11 N beyond
    the clearance; here it goes on, so that the stiffness has no leap.

    Valid
    -----
    The film carries 11 N at the wall with any oil, speed and size: a number to calibrate.
    """
    return _pocket_force(displacement, clearance, stop, (BALL_FILM_LOAD, BALL_EXPONENT))


def _pocket_force(
    displacement: NDArray, clearance: float, stop: NDArray | float, law: tuple[float, float]
) -> PocketForce:
    """Force by the load of the film at the wall [N] and the exponent of the wall."""
    film_load, exponent = law
    depth = np.maximum(np.abs(displacement) - clearance, 0.0)
    power = stop * depth ** (exponent - 1)
    film = film_load / clearance
    return PocketForce(
        force=film * displacement + np.sign(displacement) * power * depth,
        by_displacement=film + exponent * power,
    )


def displacement_in_pocket(force: NDArray, clearance: float, stop: NDArray | float) -> NDArray:
    """Displacement z [m] of a roller that presses its pocket with a force [N].

    The inverse of `roller_on_pocket_force`. It has the sign of the force; found by Newton's method on a
    convex law from above.
    Raises `NotSolved` if a force is not finite.

    Source
    ------
    `roller_on_pocket_force`.

    Valid
    -----
    As the law.
    """
    size = np.abs(force)
    # The film alone, or the wall alone, would have to go further.
    depth = np.minimum(size * clearance / FILM_LOAD, clearance + (size / stop) ** (1 / EXPONENT))
    for _ in range(ITERATION_LIMIT):
        law = roller_on_pocket_force(depth, clearance, stop)
        change = (law.force - size) / law.by_displacement
        depth = depth - change
        if (np.abs(change) <= TOLERANCE * clearance).all():
            return np.sign(force) * depth
    raise NotSolved(f"no displacement in the pocket for forces up to {size.max()!r} N", "not finite")
