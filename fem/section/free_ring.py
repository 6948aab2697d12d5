r"""A plain ring that nothing holds, as felt by elements on its raceway and by lines along its outer surface.

Its motion is that of a rigid ring, plus what loads do to it with the mean translation and the mean
tilt of the raceway kept at zero, :math:`R^T w_{\pm1} = 0` with what its shapes read of these motions, R: of
rollers :math:`w_{\pm1,0} = w_{\pm1,1} = 0`. Loads out of balance meet a pressure on the raceway like
:math:`R \cos\varphi`, which is zero as soon as all loads together are in balance. Shapes of a groove read an
axial motion, too, and its mean is zero: the ring is held along its axis evenly around its groove.
"""

from dataclasses import dataclass, replace

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.errors import TooFewHarmonics
from fem.parts.boundary_conditions import PlanetGear
from fem.parts.resolution import Resolution
from fem.parts.rings import OuterRing
from fem.raceway.harmonics import HarmonicCompliance, Responses, harmonic_compliance
from fem.section.raceway_shapes import Raceway, raceway_compliance, raceway_modes, referred
from fem.section.revolved_body import Body, edge_modes
from fem.section.rigid_body_modes import body_of, responses, rigid_motions
from fem.stages import Stage

REST = 1e-3  # allowed part of the answers through the ring that lies beyond the last harmonic
LINE_MODES = 2  # mean and moment of a line load


@dataclass(frozen=True, kw_only=True)
class FreeRing:
    """Answers of a free ring, its raceway neither translated nor tilted in the mean."""

    raceway: Raceway  # M axial modes, or stations of a groove
    lines: HarmonicCompliance  # radial loads on the outer surface, mean and moment over the full width
    radial: NDArray  # (N + 1, M, 2) [m/N] w_nm of the raceway per radial line load
    tangential: NDArray  # (N + 1, M) [m/N] per tangential load like sin, where w is like cos
    axial: NDArray | None = None  # (N + 1, M) [m/N] per axial line load; None where teeth have none
    reading: NDArray  # (M + 2, 2) what shapes of raceway and lines read of a translation [-], of a tilt [m]

    def under_radial(self, azimuths: NDArray, lines: NDArray) -> NDArray:
        r"""Raceway displacement by radial line loads on the outer surface.

        .. math:: C_{ik} = W_0 + 2 \sum_{n \ge 1} W_n \cos n(\varphi_i - \psi_k)

        An array (Z, M, K, 2) [m/N], outward per outward force; phi of the elements (Z,) and psi of the lines
        (K,) are in rad, here and in the methods below.

        Source
        ------
        Fourier series of the answer of a body of revolution; derived here.
        """
        n = np.arange(len(self.radial))
        waves = np.where(n > 0, 2, 1) * np.cos(np.multiply.outer(azimuths[:, None] - lines, n))
        return np.einsum("ikn,nms->imks", waves, self.radial)

    def under_tangential(self, azimuths: NDArray, lines: NDArray) -> NDArray:
        r"""Raceway displacement by tangential line loads on the outer surface.

        .. math:: C_{ik} = -2 \sum_n W_n \sin n(\varphi_i - \psi_k)

        An array (Z, M, K) [m/N], outward per force towards growing azimuth.

        Source
        ------
        Fourier series of the answer of a body of revolution; derived here.
        """
        n = np.arange(len(self.tangential))
        waves = -2 * np.sin(np.multiply.outer(azimuths[:, None] - lines, n))
        return np.einsum("ikn,nm->imk", waves, self.tangential)

    def under_couple(self, azimuths: NDArray, lines: NDArray) -> NDArray:
        r"""Raceway displacement by couples about the axis on lines of the outer surface, radius R.

        .. math:: C_{ik} = \frac{1}{R} \Big(T_{ik} - 2 \sum_n n W_n \sin n(\varphi_i - \psi_k)\Big)

        A couple is a pair of radial forces close together, with the tangential force that balances them; T is
        the answer of `under_tangential`, W_n that to radial forces.

        An array (Z, M, K) [1/N], outward per couple that turns towards growing azimuth.

        Source
        ------
        Statics of a pair of radial forces; Fourier series of the answer of a body of revolution;
        derived here.
        """
        n = np.arange(len(self.radial))
        waves = -2 * n * np.sin(np.multiply.outer(azimuths[:, None] - lines, n))
        pair = np.einsum("ikn,nm->imk", waves, self.radial[..., 0])
        return (self.under_tangential(azimuths, lines) + pair) / self.lines.radius

    def under_axial(self, azimuths: NDArray, lines: NDArray) -> NDArray:
        r"""Raceway displacement by axial line loads on the outer surface, towards +x; see `under_radial`.

        An array (Z, M, K) [m/N]; loads on all lines together are in balance along the axis.

        Source
        ------
        Fourier series of the answer of a body of revolution; derived here.
        """
        assert self.axial is not None  # of a ring with axial tooth forces
        n = np.arange(len(self.axial))
        waves = np.where(n > 0, 2, 1) * np.cos(np.multiply.outer(azimuths[:, None] - lines, n))
        return np.einsum("ikn,nm->imk", waves, self.axial)


def felt_motions(azimuths: NDArray, reading: NDArray) -> NDArray:
    """Displacements (Z, M, 4) of shapes at azimuths [rad] by rigid motions of a ring.

    These are translations along y and z [-], and tilts u_y = x, u_z = x [m]. `reading` (M, 2) is what each
    shape reads of a translation [-] and of a tilt [m] towards it.
    """
    normals = np.stack([np.sin(azimuths), np.cos(azimuths)], axis=-1)
    motions = reading[None, :, :, None] * normals[:, None, None, :]
    return motions.reshape(len(normals), len(reading), 4)


@threads(1)  # sections are small: a second thread would only wait
def free_ring(part: OuterRing, resolution: Resolution, last: int, stage: Stage, seconds: dict) -> FreeRing:
    """Condense a ring with loads on its raceway and on lines along its outer surface, harmonics 0 .. `last`.

    It is on `LineSupports` or a `PlanetGear`, whose lines may be anywhere; the raceway size of elements holds
    on the outer surface, too.
    Raises `NotSolved` if a solve fails; `TooFewHarmonics` where more are needed.
    """
    with stage("factor"):
        body = body_of(part, resolution)
    with stage("condense"):
        W, reading = _free_responses(body, part, resolution, last)
    axial = None
    if _is_helical(part):
        axial, W, reading = W[:, :-1, -1], W[:, :-1, :-1], reading[:-1]
    M = W.shape[1] - LINE_MODES - 1
    every_row = len(resolution.rows) * resolution.axial_modes
    raceway, lines = slice(M if part.groove else every_row), slice(-LINE_MODES - 1, -1)

    def answers(loads: slice) -> Responses:
        return Responses(W[:, loads, loads], body.stiffness.unknowns, body.space.mesh.ne)

    felt = raceway_compliance(part, resolution, answers(raceway), seconds)
    fade = felt.fade[..., None]
    ring = FreeRing(
        raceway=felt,
        lines=harmonic_compliance(
            answers(lines), radius=part.raceway_diameter / 2 + part.thickness, length=part.width,
            elastic=part.elastic, bars=None, seconds=seconds,
        ),
        radial=fade * W[:, raceway, lines],
        tangential=(fade * W[:, raceway, -1:])[..., 0],
        axial=None if axial is None else axial[:, raceway],
        reading=np.concatenate([reading[raceway], reading[lines]]),
    )  # fmt: skip
    _require_all_harmonics(ring, (part.raceway_diameter / 2 + part.thickness) / part.thickness)
    return ring


def _free_responses(
    body: Body, part: OuterRing, resolution: Resolution, last: int
) -> tuple[NDArray, NDArray]:
    """Answers (N + 1, L, L) [m/N] of raceway modes, two radial line modes and a tangential one.

    With axial tooth forces an axial one comes last. Then what they read of rigid motions like cos (L, 2): of
    a translation [-] and of a tilt [m].
    """
    v, section = body.space.TestFunction(), body.space.mesh
    where = section.Boundaries("lines")
    length = ngs.Integrate(ngs.CF(1), section, ngs.BND, definedon=where)
    directions = (2, 0) if _is_helical(part) else (2,)
    even = [body.load(v[direction] * ngs.ds(definedon=where)) / length for direction in directions]
    shapes = resolution if part.groove else replace(resolution, axial_modes=max(resolution.axial_modes, 2))
    G = np.column_stack([raceway_modes(body, part, shapes), edge_modes(body, "lines", LINE_MODES), *even])
    W = responses(body, part.free_motions, G, last) / (2 * np.pi)
    along_axis, across = (G.T @ motions for motions in rigid_motions(body))
    of_raceway = np.arange(len(across)) < len(across) - LINE_MODES - len(even)
    W[1] = referred(W[1], across, of_raceway)
    if part.groove:
        W[0] = referred(W[0], along_axis[:, :1], of_raceway)
    return W, across


def _is_helical(part: OuterRing) -> bool:
    return part.groove is None and isinstance(part.support, PlanetGear) and part.support.helical


def _require_all_harmonics(ring: FreeRing, slenderness: float) -> None:
    """Through the ring a harmonic fades like exp(-n/slenderness): the rest is slenderness times the last."""
    for answer in (ring.radial, ring.tangential):
        rest = slenderness * np.abs(answer[-1]).max() / np.abs(answer[2:]).sum(axis=0).max()
        if not rest <= REST:
            raise TooFewHarmonics(
                f"{rest:.2g} of the deflection of the ring lies beyond harmonic {len(answer) - 1}, "
                f"allowed {REST:g}: take more harmonics, on smaller elements of the raceway"
            )
