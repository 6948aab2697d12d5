r"""A plain ring bonded to a body that another program reduced to the nodes of the seat.

The nodes move with the outer surface of the ring, whose displacement along x, e_r and e_phi is given by
harmonics and Legendre polynomials, :math:`u = P \hat u`. So on the surface act the forces
:math:`-P^H S P \hat u`. The ring is condensed on springs K_0 far softer than the body, which are taken
away again; shorter waves keep them:

.. math:: \hat w = C_{rr} F - C_{rf} D (1 + C_{ff} D)^{-1} C_{fr} F, \quad D = P^H S P - K_0

Source
------
Flexibility method with a body tied at points; derived here.
"""

from dataclasses import replace

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.errors import NotSolved
from fem.parts.boundary_conditions import Foundation
from fem.parts.material import ImpossiblePart
from fem.parts.reduced_body import ReducedBody
from fem.parts.resolution import Resolution
from fem.parts.rings import OuterRing
from fem.raceway.harmonics import Responses
from fem.raceway.stations import GrooveCompliance
from fem.section.raceway_shapes import Raceway, raceway_compliance, raceway_modes
from fem.section.revolved_body import edge_modes
from fem.section.rigid_body_modes import body_of, responses
from fem.stages import Stage

ALONG = 4  # polynomials along the width
AROUND = 40  # harmonics around: more do not reach through usual rings
SHARE = 1e-3  # springs that are taken away again, over the mean stiffness of the body
NEAR = 0.02  # of the outer radius: how far nodes may stand from it, as on straight sides of elements
DIRECTIONS = 3  # x, e_r, e_phi


@threads(1)  # sections are small: a second thread would only wait
def ring_on_matrix(
    part: OuterRing, resolution: Resolution, last: int, stage: Stage, seconds: dict
) -> Raceway:
    """Condense a ring on a `ReducedBody`, harmonics 0 .. `last`.

    They couple, as the body need not be of revolution.
    Raises `ImpossiblePart` if nodes do not rest on the outer surface of the ring, `NotSolved` if a solve
    fails.

    Valid
    -----
    Small displacement, perfect bond; nodes that resolve what the ring presses on its seat.
    """
    support = part.support
    if not isinstance(support, ReducedBody):
        raise ImpossiblePart(f"{type(support).__name__} is impossible here; allowed is a ReducedBody")
    radius = part.raceway_diameter / 2 + part.thickness
    xi, azimuth = _on_surface(part, support, radius)
    around, along = min(AROUND, last, (support.azimuths - 1) // 2), min(ALONG, len(np.unique(xi.round(6))))
    held, unit = _held(support, xi, azimuth, around, along), 2 * np.pi * radius * part.width
    areas = unit / (2 * np.arange(along) + 1)  # springs per area resist a polynomial a with k_0 of these
    per_area = SHARE * np.real(np.diag(held)).reshape(-1, DIRECTIONS, along) / areas
    axial, radial, tangential = per_area.mean(axis=(0, 2))
    springs = replace(part, support=Foundation(axial=axial, radial=radial, tangential=tangential))
    with stage("factor"):
        body = body_of(springs, resolution)
    with stage("condense"):
        faces = [edge_modes(body, "foundation", along, direction) for direction in range(DIRECTIONS)]
        modes = np.hstack([raceway_modes(body, springs, resolution), *faces])
        W = responses(body, springs.free_motions, modes, last) / (2 * np.pi)
        own = np.outer((axial, radial, tangential), areas).ravel()
        D = held - np.diag(np.tile(own, 2 * around + 1))
        M = W.shape[1] - DIRECTIONS * along
        coupled = _coupled(W, D, M, around, along)
    answers = Responses(W[:, :M, :M], body.stiffness.unknowns, body.space.mesh.ne)
    raceway = raceway_compliance(part, resolution, answers, seconds)
    if isinstance(raceway, GrooveCompliance):
        return replace(raceway, coupled=coupled)
    every, inside = np.arange(2 * last + 1), slice(last - around, last + around + 1)
    whole = np.zeros((every.size, M, every.size, M), complex)
    whole[every, :, every] = raceway.response
    whole[inside, :, inside] += coupled
    return replace(raceway, response=whole)


def _on_surface(part: OuterRing, support: ReducedBody, radius: float) -> tuple[NDArray, NDArray]:
    """Places of the nodes along the width (K,), -1 to 1, and around (K,) [rad]."""
    x, y, z = support.places.T
    away = np.abs(np.hypot(y, z) - radius).max()
    xi = 2 * (x + part.offset) / part.width
    if away > NEAR * radius or np.abs(xi).max() > 1 + NEAR:
        raise ImpossiblePart(
            f"nodes stand up to {away:.3g} m away from the outer surface of the ring, radius {radius:.4g} m, "
            f"and at {np.abs(xi).max():.3g} of its half width; the seat of the matrix must be that surface"
        )
    return xi, np.arctan2(y, z)


def _held(support: ReducedBody, xi: NDArray, azimuth: NDArray, around: int, along: int) -> NDArray:
    """What the body resists the surface with (H, H) [N/m], H = (2 n + 1) 3 A.

    Harmonics -n .. n, then x, e_r, e_phi, then polynomials.
    """
    n = np.arange(-around, around + 1)
    zero, one = np.zeros_like(azimuth), np.ones_like(azimuth)
    sin, cos = np.sin(azimuth), np.cos(azimuth)
    frame = np.stack([[one, zero, zero], [zero, sin, cos], [zero, cos, -sin]])  # (direction, xyz, node)
    waves, shapes = np.exp(1j * np.outer(azimuth, n)), legendre.legvander(xi, along - 1)
    P = np.einsum("kn,dck,ka->kcnda", waves, frame, shapes).reshape(3 * len(xi), -1)
    return P.conj().T @ support.stiffness @ P


def _coupled(W: NDArray, D: NDArray, M: int, around: int, along: int) -> NDArray:
    """What the body adds to the answers W of the raceway (K, M, K, M), harmonics -n .. n; W are 0 .. N."""
    n = np.arange(-around, around + 1)
    turned = np.ones((n.size, W.shape[1]), dtype=complex)  # u_phi is like sin where u_r is like cos
    turned[:, M + 2 * along :] = (-1j * np.where(n == 0, 1j, np.sign(n)))[:, None]
    V = turned[:, :, None] * W[np.abs(n)] * turned.conj()[:, None, :]
    size = DIRECTIONS * along
    C_ff, C_fr = np.zeros((n.size, size, n.size, size), complex), np.zeros((n.size, size, n.size, M), complex)
    k = np.arange(n.size)
    C_ff[k, :, k], C_fr[k, :, k] = V[:, M:, M:], V[:, M:, :M]
    C_ff, C_fr = C_ff.reshape(len(D), len(D)), C_fr.reshape(len(D), -1)
    try:
        felt = D @ np.linalg.solve(np.eye(len(D)) + C_ff @ D, C_fr)
    except np.linalg.LinAlgError as problem:
        raise NotSolved(f"ring and matrix together are singular: {problem}") from problem
    return -(C_fr.conj().T @ felt).reshape(n.size, M, n.size, M)
