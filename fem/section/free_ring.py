r"""A plain ring that nothing holds, as felt by rollers on its raceway and by lines along its outer surface.

Its motion is that of a rigid ring, plus what loads do to it with the mean translation and the mean
tilt of the raceway kept at zero, :math:`w_{\pm1,0} = w_{\pm1,1} = 0`. Loads out of balance meet a
pressure on the raceway like :math:`\cos\varphi` and :math:`x\cos\varphi`, which is zero as soon as all
loads together are in balance.
"""

import time
from dataclasses import dataclass

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import NotSolved, threads
from fem.parts.rings import MeshSize, OuterRing, require_on_track
from fem.raceway.harmonics import FINENESS, HarmonicCompliance, highest_harmonic
from fem.section.revolved_body import Body, edge_modes
from fem.section.rigid_body_modes import body_of, responses

DEPTH = 10.0  # highest harmonic over R/thickness: through the ring less than exp(-10) of it is felt
MARGIN = 1.5  # highest harmonic over that of a band whose ends are far from the ends of its ring
REST = 1e-3  # allowed part of the answers through the ring that lies beyond the last harmonic
LINE_MODES = 2  # mean and moment of a line load


@dataclass(frozen=True, kw_only=True)
class FreeRing:
    """Answers of a free ring, its raceway neither translated nor tilted in the mean."""

    raceway: HarmonicCompliance  # M axial modes
    lines: HarmonicCompliance  # radial loads on the outer surface, 2 shapes over the full width
    radial: NDArray  # (N + 1, M, 2) [m/N] w_nm of the raceway per radial line load
    tangential: NDArray  # (N + 1, M) [m/N] per tangential load like sin, where w is like cos

    def under_radial(self, azimuths: NDArray, lines: NDArray) -> NDArray:
        r"""Raceway displacement by radial line loads on the outer surface.

        .. math:: C_{ik} = W_0 + 2 \sum_{n \ge 1} W_n \cos n(\varphi_i - \psi_k)

        Parameters
        ----------
        azimuths : array (Z,)
            phi of the rollers [rad]
        lines : array (K,)
            psi of the lines [rad]

        Returns
        -------
        array (Z, M, K, 2)
            [m/N] outward per outward force

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

        Parameters
        ----------
        azimuths, lines
            as for `under_radial`

        Returns
        -------
        array (Z, M, K)
            [m/N] outward per force towards growing azimuth

        Source
        ------
        Fourier series of the answer of a body of revolution; derived here.
        """
        n = np.arange(len(self.tangential))
        waves = -2 * np.sin(np.multiply.outer(azimuths[:, None] - lines, n))
        return np.einsum("ikn,nm->imk", waves, self.tangential)


def rigid_motions(azimuths: NDArray, length: float, axial_modes: int) -> NDArray:
    """Generalised radial displacement by rigid motions of a ring.

    Parameters
    ----------
    azimuths : array (Z,)
        of lines on it [rad]
    length : float
        l of the lines [m]
    axial_modes : int
        M

    Returns
    -------
    array (Z, M, 4)
        by translations along y and z [-], and by tilts u_y = x, u_z = x [m]
    """
    normals = np.stack([np.sin(azimuths), np.cos(azimuths)], axis=-1)
    motions = np.zeros((len(normals), axial_modes, 4))
    motions[:, 0, :2] = normals
    motions[:, 1:2, 2:] = normals[:, None] * length / 2
    return motions


def last_harmonic(part: OuterRing, detail: float, mesh: MeshSize, wish: int | None) -> int:
    """Choose the last harmonic: fine enough for bands up to the ends of a ring, also of a thin one.

    Parameters
    ----------
    part : OuterRing
        of any support
    detail, mesh, wish
        as for `fem.raceway.harmonics.highest_harmonic`

    Returns
    -------
    int
        N

    Raises
    ------
    NotSolved
        if the mesh is too coarse for what is asked for
    """
    finest = min(detail / MARGIN, FINENESS / DEPTH * part.thickness)
    return highest_harmonic(part.raceway_diameter / 2, finest, mesh, wish)


def condense(
    part: OuterRing, length: float, axial_modes: int, mesh: MeshSize, harmonics: int | None = None
) -> FreeRing:
    """Condense a ring with loads on its raceway and on lines along its outer surface.

    Parameters
    ----------
    part : OuterRing
        on `LineSupports` or as a `PlanetGear`, whose lines may be anywhere
    length : float
        l of the loaded band [m]
    axial_modes : int
        M, number of axial modes, 1 or more
    mesh : MeshSize
        wishes for the finite elements; the raceway size holds on the outer surface, too
    harmonics : int
        N, the highest; by default what the raceway and the thickness of the ring need

    Returns
    -------
    FreeRing

    Raises
    ------
    ImpossiblePart
        if the band is longer than the track
    NotSolved
        if a solve fails, or if there are too few harmonics
    """
    require_on_track(length, part.track)
    radius, outer = part.raceway_diameter / 2, part.raceway_diameter / 2 + part.thickness
    last = last_harmonic(part, length / axial_modes, mesh, harmonics)
    start = time.perf_counter()
    with threads(1):  # sections are small: a second thread would only wait
        body = body_of(part, length, mesh)
        ready = time.perf_counter()
        W = _free_responses(body, part, length, max(axial_modes, 2), last)
    figures = {
        "harmonics": np.arange(-last, last + 1),
        "elastic": part.elastic,
        "bars": None,
        "unknowns": body.stiffness.unknowns,
        "elements": body.space.mesh.ne,
        "seconds": {"factor": ready - start, "condense": time.perf_counter() - ready},
    }
    both_ways = np.concatenate([W[:0:-1], W])
    own = slice(axial_modes), slice(-LINE_MODES - 1, -1)
    ring = FreeRing(
        raceway=HarmonicCompliance(
            response=both_ways[:, own[0], own[0]], radius=radius, length=length, **figures
        ),
        lines=HarmonicCompliance(
            response=both_ways[:, own[1], own[1]], radius=outer, length=part.width, **figures
        ),
        radial=W[:, own[0], own[1]],
        tangential=W[:, own[0], -1],
    )
    _require_all_harmonics(ring, outer / part.thickness)
    return ring


def _free_responses(body: Body, part: OuterRing, length: float, axial_modes: int, last: int) -> NDArray:
    """Answers (N + 1, L, L) [m/N] of raceway modes, two radial line shapes and a tangential one."""
    v, section = body.space.TestFunction(), body.space.mesh
    where = section.Boundaries("lines")
    along = body.load(v[2] * ngs.ds(definedon=where)) / ngs.Integrate(
        ngs.CF(1), section, ngs.BND, definedon=where
    )
    G = np.column_stack(
        [edge_modes(body, "raceway", axial_modes), edge_modes(body, "lines", LINE_MODES), along]
    )
    W = responses(body, part.free_motions, G, last) / (2 * np.pi)
    # by the rigid motions (u_x, u_r, u_t) = (0, 1, -1) and (-r, x, -x)
    rigid = np.zeros((G.shape[1], 2))
    rigid[[0, axial_modes, -1], 0] = 1, 1, -1
    rigid[[1, axial_modes + 1], 1] = length / 2, part.width / 2
    W[1] = _referred(W[1], rigid)
    return W


def _referred(W: NDArray, rigid: NDArray) -> NDArray:
    r"""Answer with no rigid motion in the first two displacements, which react to loads out of balance.

    .. math:: \bar W = \Pi^T W \Pi, \quad \Pi = I - E (E^T R)^{-T} R^T

    Source
    ------
    Fourier series of the answer of a body of revolution; derived here.
    """
    projection = np.eye(len(W))
    projection[:2] -= np.linalg.solve(rigid[:2].T, rigid.T)
    return projection.T @ W @ projection


def _require_all_harmonics(ring: FreeRing, slenderness: float) -> None:
    """Through the ring a harmonic fades like exp(-n/slenderness): the rest is slenderness times the last."""
    for answer in (ring.radial, ring.tangential):
        rest = slenderness * np.abs(answer[-1]).max() / np.abs(answer[2:]).sum(axis=0).max()
        if not rest <= REST:
            raise NotSolved(
                f"{rest:.2g} of the answers through the ring lies beyond harmonic {len(answer) - 1}, "
                f"allowed {REST:g}: take more harmonics, on elements of a smaller raceway_size"
            )
