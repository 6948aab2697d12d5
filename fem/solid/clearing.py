"""Places whose stress is neither that of a contact nor that of a sharp edge."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from fem.mesh.notches import notches
from fem.parts.rings import Part, Patches, SquirrelCage
from fem.parts.step_solid import StepSolid

CONTACT = 4.0  # standard deviations of a load patch: within them its own stress rules, which is the contact's
UNLOADED = 1e-3  # of the largest roller force: below it there is no contact to keep away from


def clearing(
    part: Part | StepSolid, patches: Patches, forces: NDArray, radius: float
) -> Callable[[NDArray], NDArray]:
    """What tells whether stresses of a place count.

    Left out is what lies within `CONTACT` patch widths of a loaded roller's line, where the Gaussian patch
    rules, which is not the true contact; close to sharp edges (`fem.mesh.notches`), where a finer mesh gives
    ever more; and, within a fillet's radius, the tips where the fillets of a bar's four sides meet.

    Parameters
    ----------
    part : Part or StepSolid
        ring with its seat
    patches : Patches
        rollers, and how their forces are resolved
    forces : array (Z, M)
        generalised forces [N]
    radius : float
        of the raceway [m]

    Returns
    -------
    callable (places)
        from x, y, z (n, 3) [m] to bool (n,)
    """
    sharp, load = notches(part), np.abs(forces[:, 0])
    loaded = np.array(patches.azimuths)[load > UNLOADED * load.max()]
    tips = _tips(part) if isinstance(part, SquirrelCage) and part.fillet > 0 else None

    def clear(places: NDArray) -> NDArray:
        x, y, z = places.T
        far = sharp.clear(x, np.hypot(y, z))
        beyond = np.maximum(np.abs(x) - patches.length / 2, 0)
        for phi in loaded:
            across = np.hypot(y - radius * np.sin(phi), z - radius * np.cos(phi))
            far &= np.hypot(beyond, across) > CONTACT * patches.width
        return far if tips is None else far & _beyond_tips(part, tips, places)

    return clear


def _tips(cage: SquirrelCage) -> NDArray:
    """Where fillets of neighbouring sides of the bar at azimuth 0 meet (8, 3) [m]."""
    side, start = cage.bar_width / 2, cage.width / 2
    ends = start + cage.fillet, start + cage.bar_length - cage.fillet
    radii = (np.sqrt(r**2 - side**2) for r in cage.bar_radii)
    return np.array([(x, t, r) for r in radii for x in ends for t in (-side, side)])


def _beyond_tips(cage, tips: NDArray, places: NDArray) -> NDArray:
    """Whether places (n, 3) are further from tips of all bars than the radius of a fillet."""
    pitch, radius = 2 * np.pi / cage.bars, np.hypot(places[:, 1], places[:, 2])
    azimuth = np.arctan2(places[:, 1], places[:, 2])
    azimuth -= pitch * np.round(azimuth / pitch)
    turned = np.stack([places[:, 0], radius * np.sin(azimuth), radius * np.cos(azimuth)], axis=1)
    nearest = np.min([((turned - tip) ** 2).sum(axis=1) for tip in tips], axis=0)
    return nearest > cage.fillet**2
