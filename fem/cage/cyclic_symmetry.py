r"""A squirrel cage from half a pitch of it: mirror images and one phase for each class of harmonics.

The field of a harmonic n is :math:`u = a + ib` with a real, a its own mirror image in the middle plane
of a bar, b the negative of its own; both live on half a pitch. From pitch to pitch the field turns by
:math:`\theta = 2\pi n/\mathrm{bars}`, which at the middle of the slot ties the two together, with c =
cos(theta/2), s = sin(theta/2):

.. math:: a_{x,r} = c\,z_{x,r}, \quad b_{x,r} = s\,z_{x,r}, \quad a_t = -s\,z_t, \quad b_t = c\,z_t

So one mesh is reduced to its cut through the slot twice, symmetric and antisymmetric, and small real
symmetric systems for z answer every harmonic of every phase.

Source
------
Cyclic symmetry with a plane of symmetry in each sector; derived here.
"""

import logging
from dataclasses import replace
from math import pi

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_factor, cho_solve

from fem.assembly import roller_loads
from fem.assembly.factorisation import RESIDUAL, NotSolved, threads
from fem.cage.half_pitch_stiffness import (
    CutStiffness,
    HalfPitch,
    assembled_half_pitch,
    imbalance,
    reduced_to_cut,
)
from fem.mesh.half_pitch import half_pitch
from fem.parts.resolution import Resolution, neighbour
from fem.parts.rings import SquirrelCage
from fem.raceway.bar_response import MIRRORED, BarResponse, is_mirrored
from fem.raceway.harmonics import Responses, support_error
from fem.stages import Stage

_log = logging.getLogger(__name__)


def cage_responses(cage: SquirrelCage, resolution: Resolution, last: int, stage: Stage) -> Responses:
    r"""Answers of the raceway of a squirrel cage, with those harmonics that bars couple.

    .. math:: w_{n'} = 2\,\mathrm{bars}\,(g_{n'}^a \cdot a + g_{n'}^b \cdot b), \quad
              g_n^{a,b} = \frac{1}{2\pi R} \int a_m v_r\,(\cos n\varphi, \sin n\varphi)\,dA

    over half a pitch, for n' that differs from n by a multiple of the number of bars.

    Parameters
    ----------
    cage : SquirrelCage
        ring, bars and flange
    resolution : Resolution
        of band and mesh; order 3 pays
    last : int
        N, the highest harmonic
    stage : callable (name)
        around "mesh", "factor" and "condense"

    Returns
    -------
    Responses
        real, as azimuth 0 is a plane of symmetry

    Raises
    ------
    NotSolved
        if a residual is too large
    """
    mesh = resolution.mesh
    with threads(1):  # half a pitch is small: a second thread would only wait
        with stage("mesh"):
            elements = half_pitch(cage, resolution.length, mesh, nodes_of=resolution.nodes_of)
        with stage("factor"):
            half, cuts = _reduced(cage, elements, mesh.order, resolution, last)
    with stage("condense"):
        response, in_bars = _response(half, cuts, cage.bars, last)
        answers = Responses(
            response, half.space.ndof, elements.ne, bar_response=BarResponse(cage.bars, in_bars, None)
        )
        return answers if resolution.nodes_of else _with_errors(answers, cage, elements, resolution, last)


def _with_errors(
    answers: Responses, cage: SquirrelCage, elements: ngs.Mesh, resolution: Resolution, last: int
) -> Responses:
    """Answers with those of another order, which tell their error."""
    assert answers.bar_response
    coarser = _reduced(cage, elements, neighbour(resolution.mesh.order), resolution, last)
    other_response, other_in_bars = _response(*coarser, cage.bars, last)
    return answers._replace(
        support_error=support_error(answers.response, other_response),
        bar_response=replace(answers.bar_response, neighbour=other_in_bars),
    )


def _reduced(
    cage: SquirrelCage, elements: ngs.Mesh, order: int, resolution: Resolution, last: int
) -> tuple[HalfPitch, list[CutStiffness]]:
    """Half a pitch by displacements of some order, and its cut for both kinds of mirror images."""
    half = assembled_half_pitch(cage, elements, order)
    band = roller_loads.band(half.space, "raceway", roller_loads.HIGHEST_ORDER)
    modes = resolution.axial_modes
    return half, [
        reduced_to_cut(half, band, resolution.length, modes, last, symmetric) for symmetric in (True, False)
    ]


def _response(half: HalfPitch, cuts: list[CutStiffness], bars: int, highest: int) -> tuple[NDArray, NDArray]:
    """Answers of all harmonics to all (K, M, K, M) [m/N], and of bars to all (K, M, 6) [N/N, N m/N]."""
    harmonics = np.arange(-highest, highest + 1)
    m = np.arange(cuts[0].share.shape[2])
    response, probes = np.zeros((harmonics.size, m.size) * 2), []
    readings = half.readings.shape[1]
    bar_forces, turned = np.zeros((harmonics.size, m.size, readings)), ~is_mirrored(readings)
    for phase in range(bars // 2 + 1):
        same = harmonics[(harmonics - phase) % bars == 0]
        if same.size:
            answer, in_bar, probe = _phase(cuts, 2 * pi * phase / bars, same)
            probes.append(probe)
            for n, mirrored in ((-same, -1), (same, 1)):  # the first is the mirror image
                response[np.ix_(n + highest, m, n + highest, m)] = 2 * bars * answer
                bar_forces[n + highest] = in_bar * np.where(turned, mirrored, 1)
    _require_balance(half, cuts, probes)
    return response, bar_forces


def _phase(cuts: list[CutStiffness], theta: float, harmonics: NDArray):
    """Answers of one phase: (k, M, k, M) per half pitch, in its bar (k, M, 6), and a solution as a probe."""
    even, odd = cuts
    shares = even.share[:, np.abs(harmonics)], odd.share[:, np.abs(harmonics)] * np.sign(harmonics)[:, None]
    forces = [share.reshape(len(share), -1) for share in shares]
    # Factors of z in a and in b, for the displacements x, r and t of all places.
    c, s = np.cos(theta / 2), np.sin(theta / 2)
    ties = np.repeat([[c, c, -s], [s, s, c]], len(even.stiffness) // 3, axis=1)
    stiffness = np.sum([t[:, None] * f.stiffness * t for f, t in zip(cuts, ties, strict=True)], axis=0)
    pulls = [t[:, None] * (f.coupling @ q) for f, t, q in zip(cuts, ties, forces, strict=True)]
    pull = np.sum(pulls, axis=0)
    try:
        z = cho_solve(cho_factor(stiffness), pull)
    except LinAlgError as refusal:
        raise NotSolved(f"phase {theta:.3g} rad could not be solved: {refusal}") from refusal
    answer = pull.T @ z + sum(q.T @ f.compliance @ q for f, q in zip(cuts, forces, strict=True))
    shape = harmonics.size, even.share.shape[2]
    weights = np.random.default_rng(0).standard_normal(z.shape[1])
    probe = [(t * (z @ weights), q @ weights, t) for t, q in zip(ties, forces, strict=True)]
    in_bar = [
        f.bar_by_cut @ (t[:, None] * z) + f.bar_by_forces @ q
        for f, t, q in zip(cuts, ties, forces, strict=True)
    ]
    by_end = [part.reshape(-1, MIRRORED, part.shape[1]) for part in in_bar]
    in_bars = np.concatenate(by_end, axis=1).reshape(-1, z.shape[1])
    return answer.reshape(*shape, *shape), in_bars.T.reshape(*shape, -1), probe


def _require_balance(half: HalfPitch, cuts: list[CutStiffness], probes: list) -> None:
    """Raise if a phase leaves forces on the unknowns of half a pitch; each was probed with a random load."""
    left, size = np.zeros(len(probes)), np.zeros(len(probes))
    on_the_cut = np.zeros((half.cut.size, len(probes)))
    for number, f in enumerate(cuts):
        u, q, tie = (np.stack(columns, axis=1) for columns in zip(*(p[number] for p in probes), strict=True))
        rest = imbalance(half, f, u, q)
        on_the_cut += tie * rest[half.cut.ravel()]
        rest[half.cut] = 0.0
        left += (rest**2).sum(axis=0)
        size += ((f.patterns @ q) ** 2).sum(axis=0)
    residual = np.sqrt((left + (on_the_cut**2).sum(axis=0)) / size).max()
    _log.debug("relative residual %.1e", residual)
    if not residual <= RESIDUAL:
        raise NotSolved(f"relative residual {residual:.2g}, allowed {RESIDUAL:g}; is the cage held?")
