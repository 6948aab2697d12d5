"""A raceway on a body of revolution, answered harmonic by harmonic on the axial section."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.parts.resolution import Resolution, neighbour
from fem.parts.rings import OuterRing, RingOnShaft
from fem.raceway.harmonics import Responses, support_error
from fem.section.raceway_shapes import raceway_modes, taper, without_axial_motion
from fem.section.revolved_body import edge_modes
from fem.section.rigid_body_modes import body_of, responses
from fem.stages import Stage


@threads(1)  # sections are small: a second thread would only wait
def section_responses(
    part: OuterRing | RingOnShaft, resolution: Resolution, last: int, stage: Stage, face_modes: int = 0
) -> Responses:
    r"""Answers of the raceway of a body of revolution to loads on it.

    .. math:: W_n = \frac{1}{2\pi}\,G^T K(n)^{-1} G, \quad g_m = \int a_m v_r\,dx

    Responses are to the modes of the raceway, then to `face_modes` axial modes of the outer surface, for a
    ring on springs there. The body is held across its axis; order 5 or 6 of the displacements pays.
    Raises `ImpossiblePart` if the part is not known as a body of revolution, `NotSolved` if a solve fails.

    Source
    ------
    Body of revolution in harmonics, virtual work per radian; derived here.

    Valid
    -----
    Small displacement, perfect bonds, rigid clamps; no load outside the band.
    """
    with stage("factor"):
        body = body_of(part, resolution)
    with stage("condense"):
        modes = raceway_modes(body, part, resolution)
        if face_modes:
            modes = np.hstack([modes, edge_modes(body, "foundation", face_modes)])
        W = responses(body, part.free_motions, modes, last) / (2 * np.pi)
        if part.groove is not None and part.free_motions.axial:
            W[0] = without_axial_motion(W[0], body, modes)
        estimated = not part.free_motions.across and resolution.nodes_of is None and part.groove is None
        error = _support_error(part, resolution, W) if estimated else None
    rows = len(resolution.rows)
    return Responses(
        W, body.stiffness.unknowns, body.space.mesh.ne, support_error=error, rows=rows, taper=taper(part),
        along=resolution.along,
    )  # fmt: skip


def _support_error(part: OuterRing | RingOnShaft, resolution: Resolution, response: NDArray) -> float:
    """Estimated error of the stiffness of the support, over it [-]."""
    mesh = resolution.mesh
    coarser = body_of(part, resolution, replace(mesh, order=neighbour(mesh.order)))
    mode = raceway_modes(coarser, part, resolution)[:, :1]
    answer = mode.T @ coarser.stiffness.solve(1, mode) / (2 * np.pi)
    return support_error(response, np.stack([answer, answer]))
