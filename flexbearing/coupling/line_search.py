"""How far to go to the balance with a tangent of a structure that is not linear."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexbearing.coupling.partners import LinearStructure, Structure
from flexbearing.coupling.raceway_pair import OUTWARD

FLAT = 0.3  # of the slope at the tangent, up to which a slope on the way is that of the least energy
MOST_TRIALS = 12  # on the way; 1 to 5 are usual


@dataclass(frozen=True)
class Tangent:
    """A structure near forces of the rolling elements, which balance between raceways of some deviations."""

    forces: NDArray  # (2, Z, M) [N]
    linear: LinearStructure
    balancing: NDArray | None  # (2, Z, M) these deviations [m], where they are known

    def slope(self, way: NDArray, balancing: NDArray) -> float:
        """What the structure does beyond these deviations on a way (2, Z, M) [N] of the forces [J]."""
        beyond = self.linear.deviation(self.forces) - balancing
        return float(np.vdot(OUTWARD[:, None, None] * way, beyond))


def next_tangent(structure: Structure, tangent: Tangent, balanced: Tangent) -> Tangent:
    r"""The tangent at a balance with the last one, or before it where the energy is least on the way there.

    .. math:: \frac{d\Psi}{ds} = d \cdot \left(w(F + s\,d) - (1 - s)\,w_0 - s\,w_1\right)

    The tangent at the balance may lead back to the one before, and so on in turns, as fits and supports open
    and close. Balances make the complementary energy of contacts and structure least, which is convex: each
    tangent that begins where it is least on the way has less of it than the one before.

    Parameters
    ----------
    structure : Structure
        w, outward deviations under forces [m]
    tangent : Tangent
        at F; forces balance between raceways of deviations w_0
    balanced : Tangent
        at F + d; forces balance between raceways of deviations w_1, those of the last tangent

    Returns
    -------
    Tangent
        at F + s d, 0 < s <= 1; at the balance where w_0 is not known, or of other axial modes

    Raises
    ------
    PartnerFailed
        where the structure cannot answer on the way

    Source
    ------
    Minimum of a convex function of which one part is linearised, with a line search (proximal Newton
    method); the slope of the contacts is interpolated. Derived here.

    Valid
    -----
    Contacts and structure without friction; with it nearly.
    """
    begin, end = tangent.balancing, balanced.balancing
    if begin is None or end is None or begin.shape != end.shape:  # that of a start with other axial modes
        return balanced
    way = balanced.forces - tangent.forces
    least, before = 0.0, tangent.slope(way, begin)
    most, after = 1.0, balanced.slope(way, end)
    if not before < 0.0 < after:
        return balanced
    flat, reached = FLAT * before, None
    for _ in range(MOST_TRIALS):
        # Illinois method: the slope at an end that stays counts half
        share = least + (most - least) * before / (before - after)
        between = (1 - share) * begin + share * end
        forces = tangent.forces + share * way
        trial = Tangent(forces, structure.linearised(forces), between)
        slope = trial.slope(way, between)
        if slope > 0.0:
            most, after, before = share, slope, before / 2
        else:
            least, before, after, reached = share, slope, after / 2, trial
            if slope >= flat:
                break
    return reached or trial
