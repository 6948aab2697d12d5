"""Growth of the raceway of an inner ring that is one piece with its shaft, by heat and rotation."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from fem.assembly.factorisation import threads
from fem.parts.boundary_conditions import FreeMotions
from fem.parts.resolution import Resolution
from fem.parts.rings import RingOnShaft
from fem.raceway.growth import BondedGrowth
from fem.section.expansion import heating, rotation
from fem.section.revolved_body import edge_modes
from fem.section.rigid_body_modes import body_of, held_on_points

FREE = FreeMotions(axial=True, turning=True, across=True)


def bonded_growth(part: RingOnShaft, resolution: Resolution) -> BondedGrowth:
    """Growth [m] of the raceway of a ring that is one piece with its shaft.

    It is per strain, and per density times speed squared.
    Raises `NotSolved` if a solve fails.

    Source
    ------
    Linear thermoelasticity of a body of revolution, harmonic 0.

    Valid
    -----
    Small displacement; the clamps of the shaft follow heat and rotation freely, as a shaft that goes on.
    """
    names = tuple(part.materials)  # ring, shaft

    def alone(name: str) -> Mapping[str, float]:
        return dict.fromkeys(names, 0.0) | {name: 1.0}

    with threads(1):
        body = body_of(part, resolution)
        clamped = np.zeros_like(body.stiffness.clamped)
        unclamped = replace(body, stiffness=replace(body.stiffness, clamped=clamped))
        loads = [heating(body, alone(name)) for name in names]
        loads += [rotation(body, alone(name), 1.0) for name in names]
        expanded = held_on_points(unclamped, FREE, 0).solve(0, np.stack(loads, axis=1))
        growth = np.ascontiguousarray((edge_modes(body, "raceway", resolution.axial_modes).T @ expanded).T)
    return BondedGrowth(growth[:2], growth[2:])
