r"""How the arches of a bolted ring yield to balls at equal pitches.

A ball presses with a force (F_r, F_x) [N] on a short line across the arch, evenly along it, at the
contact angle without load; the groove centre follows the mean displacement (u_r, u_x) of that line.
What a half-space would yield to the ball's own force is left out (`fem.half_space.groove_line`), as the law
of the contact has it. The body is one of revolution: harmonics of the force move it in the same harmonics,

.. math:: W_n = \frac{1}{2\pi}\,G^T K(n)^{-1} G

and equal pitches leave one matrix for each distance between balls.

Source
------
Body of revolution in harmonics; derived here.
"""

import logging
import time
from dataclasses import dataclass, field

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.errors import NotSolved
from fem.half_space.groove_line import line_answers, line_harmonics
from fem.half_space.line_load import cubic_tail, curvature_tail
from fem.mesh.bolted_ring_section import section
from fem.mesh.solid import MILLIMETRES
from fem.parts.bolted_ring import BoltedGrooveRing
from fem.parts.boundary_conditions import FreeMotions
from fem.parts.rings import MeshSize
from fem.raceway.harmonics import TRUNCATED, highest_harmonic
from fem.section.revolved_body import Body, Springs, assembled
from fem.section.rigid_body_modes import responses

_log = logging.getLogger(__name__)


@dataclass(frozen=True, kw_only=True)
class GrooveCompliance:
    """What the arches of a ring yield to the balls, the ball's own half-space left out."""

    row: NDArray  # (Z, 2, 2, 2, 2) [m/N] arch and component by those of the force, so many pitches apart
    beyond: float  # [-] part of the own terms that comes from beyond the last harmonic
    harmonics: int  # the highest one
    unknowns: int
    seconds: dict[str, float] = field(compare=False)  # by stage: factor, condense


def condense(
    ring: BoltedGrooveRing, balls: int, length: float, mesh: MeshSize, harmonics: int | None = None
) -> GrooveCompliance:  # fmt: skip
    r"""Compliance of both arches under balls at equal pitches.

    .. math:: C(d) = \sum_{|n| \le N} (W_n - h_n) \cos n\varphi_d + T_N(\varphi_d)
              + [d \ne 0]\,H(\varphi_d), \quad \varphi_d = 2\pi d/Z

    with H the answer of a half-space at the chord between two balls, h its harmonics and T_N the rest
    of the series, as it falls at its end.

    Parameters
    ----------
    ring : BoltedGrooveRing
        the part
    balls : int
        Z, 3 or more
    length : float
        l of the loaded lines [m]; a fifth of the ball is near a heavily loaded contact
    mesh : MeshSize
        wishes for the finite elements; order 5 or 6 pays
    harmonics : int
        N, the highest; by default 6 R/l or what the mesh resolves

    Returns
    -------
    GrooveCompliance
        arches in the order (+x, -x), components (outward, +x); symmetric

    Raises
    ------
    ImpossiblePart
        if the lines leave the arches
    NotSolved
        if a solve fails, or if the harmonics end too early

    Source
    ------
    The groove centre that follows its elastic arch is that of Daidie, Chaib and Ghosn (2008), J. Mech.
    Des. 130, 082601; the half-space is left out as docs/decisions/0001 says.

    Valid
    -----
    Small displacement; the turn of an arch, which would move its groove centre aside, is left out.
    """
    last = highest_harmonic(ring.contact_radius, length, mesh, harmonics)
    start = time.perf_counter()
    with threads(1):  # sections are small: a second thread would only wait
        body = body_of(ring, length, mesh)
        ready = time.perf_counter()
        W = responses(body, FreeMotions(), line_forces(body, length), last) / (2 * np.pi)
    done = time.perf_counter()
    _log.info("%s gothic ring: %d unknowns, %.1f s", ring.race, body.stiffness.unknowns, done - start)
    row, beyond = _row(ring, length, W, balls)
    if not beyond <= TRUNCATED:
        raise NotSolved(
            f"{beyond:.2g} of the own compliance lies beyond harmonic {last}, allowed {TRUNCATED:g}: "
            "take more harmonics or a finer mesh of the lines"
        )
    return GrooveCompliance(
        row=row.reshape(balls, 2, 2, 2, 2),
        beyond=beyond,
        harmonics=last,
        unknowns=body.stiffness.unknowns,
        seconds={"factor": ready - start, "condense": done - ready},
    )


def body_of(ring: BoltedGrooveRing, length: float, mesh: MeshSize) -> Body:
    """Assemble the section of a ring on its bolted face."""
    polygon = section(ring, length)
    named = {name for *_, name in polygon.corners}
    springs = Springs(ring.normal_stiffness, ring.shear_stiffness, ring.shear_stiffness)
    return assembled(
        [polygon], {"ring": ring.elastic}, mesh, {"foundation": springs} if "foundation" in named else {}
    )


def line_forces(body: Body, length: float) -> NDArray:
    """Load vectors (unknowns, 4) of unit forces on the lines: arch at +x outward, +x; arch at -x likewise.

    They also read the mean displacement of the lines.
    """
    v, lines = body.space.TestFunction(), body.space.mesh.Boundaries("raceway")
    even = 1 / (length * MILLIMETRES)
    return np.stack(
        [
            body.load(ngs.IfPos(side * ngs.x, even, 0.0) * v[component] * ngs.ds(definedon=lines))
            for side in (1, -1)
            for component in (1, 0)
        ],
        axis=1,
    )


def _row(ring: BoltedGrooveRing, length: float, W: NDArray, balls: int) -> tuple[NDArray, float]:
    """Compliance so many pitches apart (Z, 4, 4) [m/N], and the part of the own one that is extrapolated."""
    last = len(W) - 1
    place = ring.contact_radius, length, ring.elastic
    own = _turned(ring, line_harmonics(np.arange(last + 1), *place))
    rest = W - own
    phi = 2 * np.pi * np.arange(balls) / balls
    twice = np.where(np.arange(last + 1) > 0, 2.0, 1.0)
    series = np.tensordot(np.cos(np.outer(phi, np.arange(last + 1))) * twice, rest, axes=1)
    beyond = _tail(rest, phi)
    row = series + beyond
    row[1:] += _turned(ring, line_answers(phi[1:], *place))
    size = np.abs(np.diag(row[0])) + np.diag(np.tensordot(twice, own, axes=1))
    return (row + row.swapaxes(1, 2)) / 2, float(np.abs(beyond[0]).max() / size.max())


def _turned(ring: BoltedGrooveRing, answers: NDArray) -> NDArray:
    """Answers normal and along the lines (..., 2) as those to outward and axial forces (..., 4, 4)."""
    cosine, sine = np.cos(ring.contact_angle), np.sin(ring.contact_angle)
    both = np.zeros((*answers.shape[:-1], 4, 4))
    for arch, side in enumerate((ring.outward, -ring.outward)):
        axes = np.array([[cosine, side * sine], [-sine, side * cosine]])  # normal, along; signs cancel
        own = slice(2 * arch, 2 * arch + 2)
        both[..., own, own] = np.einsum("...k,ki,kj->...ij", answers, axes, axes)
    return both


def _tail(rest: NDArray, azimuth: NDArray) -> NDArray:
    r"""Sum of the harmonics beyond the last one (Z, 4, 4) [m/N], as the last quarter falls.

    .. math:: S_n = \frac{c}{n^2-1} + \frac{d}{n^3}
    """
    last = len(rest) - 1
    n = np.arange(last - last // 4, last + 1)
    weight = n[:, None] ** 2.0
    law = np.stack([1 / (n**2 - 1.0), 1.0 / n**3], axis=1)
    fitted = np.linalg.lstsq(weight * law, weight * rest[n].reshape(n.size, -1), rcond=None)[0]
    tails = np.stack([curvature_tail(azimuth, last), cubic_tail(azimuth, last)], axis=-1)
    return (tails @ fitted).reshape(azimuth.size, *rest.shape[1:])
