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
from collections.abc import Callable, Sequence
from dataclasses import replace
from math import pi

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError, cho_factor, cho_solve

from fem.assembly import roller_loads
from fem.assembly.factorisation import RESIDUAL, NotSolved, threads
from fem.mesh.half_pitch import half_pitch
from fem.parts.resolution import Resolution, neighbour
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.bar_response import MIRRORED, BarResponse, is_mirrored
from fem.raceway.harmonics import Responses, support_error
from fem.squirrel_cage.cut_stiffness import (
    CutStiffness,
    HalfPitch,
    ReducedHalfPitch,
    assembled_half_pitch,
    imbalance,
    reduced_to_cut,
)
from fem.stages import Stage

_log = logging.getLogger(__name__)


def cage_responses(cage: SquirrelCage, resolution: Resolution, last: int, stage: Stage) -> Responses:
    r"""Answers of the raceway of a squirrel cage, with those harmonics that bars couple.

    .. math:: w_{n'} = 2\,\mathrm{bars}\,(g_{n'}^a \cdot a + g_{n'}^b \cdot b), \quad
              g_n^{a,b} = \frac{1}{2\pi R} \int a_m v_r\,(\cos n\varphi, \sin n\varphi)\,dA

    over half a pitch, for n' that differs from n by a multiple of the number of bars.

    Responses are real, as azimuth 0 is a plane of symmetry. Order 3 of the displacements pays.
    Raises `NotSolved` if a residual is too large.
    """
    mesh = resolution.mesh
    with threads(1):  # half a pitch is small: a second thread would only wait
        with stage("mesh"):
            elements = half_pitch(cage, resolution.length, mesh, nodes_of=resolution.nodes_of)
        with stage("factor"):
            half, halves = reduced(cage, elements, mesh.order, resolution, last)
    with stage("condense"):
        response, in_bars = _in_balance(half, halves, cage.bars, last)
        answers = Responses(
            response, half.space.ndof, elements.ne, bar_response=BarResponse(cage.bars, in_bars, None)
        )
        return answers if resolution.nodes_of else _with_errors(answers, cage, elements, resolution, last)


def _with_errors(
    answers: Responses, cage: SquirrelCage, elements: ngs.Mesh, resolution: Resolution, last: int
) -> Responses:
    """Answers with those of another order, which tell their error."""
    assert answers.bar_response
    coarser = reduced(cage, elements, neighbour(resolution.mesh.order), resolution, last)
    other_response, other_in_bars = _in_balance(*coarser, cage.bars, last)
    return answers._replace(
        support_error=support_error(answers.response, other_response),
        bar_response=replace(answers.bar_response, neighbour=other_in_bars),
    )


def reduced(
    cage: SquirrelCage, elements: ngs.Mesh, order: int, resolution: Resolution, last: int
) -> tuple[HalfPitch, list[ReducedHalfPitch]]:
    """Half a pitch by displacements of some order, and its cut for both kinds of mirror images."""
    half = assembled_half_pitch(cage, elements, order)
    band = roller_loads.band(half.space, "raceway", roller_loads.HIGHEST_ORDER)
    modes = resolution.axial_modes
    return half, [
        reduced_to_cut(half, band, resolution.length, modes, last, symmetric) for symmetric in (True, False)
    ]


def _in_balance(
    half: HalfPitch, halves: list[ReducedHalfPitch], bars: int, highest: int
) -> tuple[NDArray, NDArray]:
    """Answers of raceway and bars of displacements that leave no forces unbalanced."""
    cuts, probes = [each.cut for each in halves], []

    angles = [theta for theta, _ in phases(bars, highest)]

    def answered(phase: int, harmonics: NDArray) -> NDArray:
        theta = angles[phase]
        forces, z = phase_solution(cuts, theta, harmonics, with_readings=False)
        answer = _answer(cuts, theta, forces, z)
        weights = np.random.default_rng(0).standard_normal(z.shape[1])
        probes.append(
            [(t * (z @ weights), q @ weights, t) for t, q in zip(ties(cuts, theta), forces, strict=True)]
        )
        return answer

    found = all_phases(answered, bars, (highest, cuts[0].share.shape[2]), half.readings.shape[1])
    _require_balance(half, halves, probes)
    return found


def all_phases(
    answered: Callable[[int, NDArray], NDArray], bars: int, highest_and_shapes: tuple[int, int], readings: int
) -> tuple[NDArray, NDArray]:
    """Answers of all harmonics -N .. N to all, (K, M, K, M) [m/N], from those of every phase.

    Bar forces come with them, (K, M, readings) [N/N, N m/N]. `answered` gives for a phase, by its number and
    its k harmonics, the answers (k M + readings, k M) of half a pitch: of the raceway [m/N], then of the
    bars, those of fields that are their own mirror image first. N and M are `highest_and_shapes`.
    """
    highest, shapes = highest_and_shapes
    count, m = 2 * highest + 1, np.arange(shapes)
    response = np.zeros((count, shapes) * 2)
    bar_forces, turned = np.zeros((count, shapes, readings)), ~is_mirrored(readings)
    for number, (_, same) in enumerate(phases(bars, highest)):
        loads, answer = same.size * shapes, answered(number, same)
        by_end = answer[loads:].reshape(2, -1, MIRRORED, loads)  # by kind of mirror image and by end
        in_bar = by_end.swapaxes(0, 1).reshape(readings, loads).T.reshape(same.size, shapes, readings)
        square = answer[:loads].reshape((same.size, shapes) * 2)
        for n, mirrored in ((-same, -1), (same, 1)):  # the first is the mirror image
            response[np.ix_(n + highest, m, n + highest, m)] = 2 * bars * square
            bar_forces[n + highest] = in_bar * np.where(turned, mirrored, 1)
    return response, bar_forces


def phases(bars: int, highest: int) -> list[tuple[float, NDArray]]:
    """Angles from pitch to pitch [rad] of all phases that some harmonic up to the last has, with these."""
    harmonics = np.arange(-highest, highest + 1)
    same = (harmonics[(harmonics - phase) % bars == 0] for phase in range(bars // 2 + 1))
    return [(2 * pi * phase / bars, each) for phase, each in enumerate(same) if each.size]


def ties(cuts: Sequence[CutStiffness], theta: float) -> NDArray:
    """Factors (2, 3 places) of z in a and in b, for the displacements x, r and t of all places."""
    c, s = np.cos(theta / 2), np.sin(theta / 2)
    return np.repeat([[c, c, -s], [s, s, c]], len(cuts[0].stiffness) // 3, axis=1)


def phase_solution(
    cuts: Sequence[CutStiffness], theta: float, harmonics: NDArray, *, with_readings: bool
) -> tuple[list[NDArray], NDArray]:
    """Forces of both kinds (patterns, k M), and displacements of the cut (3 places, k M) [m/N], in one phase.

    Loads are the harmonics n (k) of the phase, whose angle from pitch to pitch is `theta` [rad]. With
    readings, unit readings of the bars load the half pitch, too, those of either kind one after the other, as
    further columns.
    Raises `NotSolved` if the cage is not held.
    """
    even, odd = cuts
    shares = even.share[:, np.abs(harmonics)], odd.share[:, np.abs(harmonics)] * np.sign(harmonics)[:, None]
    forces, tied = [share.reshape(len(share), -1) for share in shares], ties(cuts, theta)
    stiffness = np.sum([t[:, None] * f.stiffness * t for f, t in zip(cuts, tied, strict=True)], axis=0)
    pull = np.sum([t[:, None] * (f.coupling @ q) for f, t, q in zip(cuts, tied, forces, strict=True)], axis=0)
    if with_readings:
        pull = np.hstack([pull, *(t[:, None] * f.bar_by_cut.T for f, t in zip(cuts, tied, strict=True))])
    try:
        return forces, cho_solve(cho_factor(stiffness), pull)
    except LinAlgError as refusal:
        raise NotSolved(f"phase {theta:.3g} rad could not be solved: {refusal}") from refusal


def _answer(cuts: Sequence[CutStiffness], theta: float, forces: list[NDArray], z: NDArray) -> NDArray:
    """Answers of a phase, as `all_phases` takes them, from displacements z of the cut."""
    answer, in_bars = np.zeros((z.shape[1],) * 2), []
    for f, t, q in zip(cuts, ties(cuts, theta), forces, strict=True):
        u = t[:, None] * z
        answer += (f.coupling @ q).T @ u + q.T @ f.compliance @ q
        in_bars.append(f.bar_by_cut @ u + f.bar_by_forces @ q)
    return np.vstack([answer, *in_bars])


def _require_balance(half: HalfPitch, halves: list[ReducedHalfPitch], probes: list) -> None:
    """Raise if a phase leaves forces on the unknowns of half a pitch; each was probed with a random load."""
    left, size = np.zeros(len(probes)), np.zeros(len(probes))
    on_the_cut = np.zeros((half.cut.size, len(probes)))
    for number, f in enumerate(halves):
        u, q, tie = (np.stack(columns, axis=1) for columns in zip(*(p[number] for p in probes), strict=True))
        inside, on_face = imbalance(half, f, u, q)
        on_the_cut += tie * on_face
        left += (inside**2).sum(axis=0)
        size += ((f.patterns @ q) ** 2).sum(axis=0)
    residual = np.sqrt((left + (on_the_cut**2).sum(axis=0)) / size).max()
    _log.debug("relative residual %.1e", residual)
    if not residual <= RESIDUAL:
        raise NotSolved(f"relative residual {residual:.2g}, allowed {RESIDUAL:g}; is the cage held?")
