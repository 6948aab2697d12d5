r"""How the raceway arcs of a bolted ring deflect under balls at equal pitches.

A ball presses with a force (F_r, F_x) [N] on a short line across the arc, evenly along it, at the
contact angle without load; the groove centre follows the mean displacement (u_r, u_x) of that line.
The deflection of a half-space under the ball's own force is left out (`fem.half_space.groove_line`), as
the law of the contact has it. The body is one of revolution: harmonics of the force move it in the same
harmonics,

.. math:: W_n = \frac{1}{2\pi}\,G^T K(n)^{-1} G

and equal pitches leave one matrix for each distance between balls.

Source
------
Body of revolution in harmonics; derived here.
"""

from dataclasses import dataclass, field
from functools import cached_property

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.factorisation import threads
from fem.errors import NotSolved
from fem.half_space.groove_line import line_answers, line_harmonics
from fem.mesh.bolted_ring_section import section
from fem.mesh.solid import MILLIMETRES
from fem.parts.bolted_ring import BoltedGrooveRing
from fem.parts.boundary_conditions import FreeMotions
from fem.parts.resolution import Resolution
from fem.parts.rings import MeshSize
from fem.raceway.harmonics import TRUNCATED, highest_harmonic, sum_beyond
from fem.section.revolved_body import Body, Springs, assembled
from fem.section.rigid_body_modes import responses
from fem.stages import Stage


@dataclass(frozen=True, kw_only=True)
class ArchCompliance:
    r"""How the raceway arcs of a groove deflect under balls at equal pitches, their half-space left out.

    .. math:: C(d) = \sum_{|n| \le N} (W_n - h_n) \cos n\varphi_d + T_N(\varphi_d)
              + [d \ne 0]\,H(\varphi_d), \quad \varphi_d = 2\pi d/Z

    with H the answer of a half-space at the chord between two balls, h its harmonics and T_N the rest
    of the series, as it falls at its end.

    Source
    ------
    The groove centre that follows its elastic arc is that of Daidie, Chaib and Ghosn (2008), J. Mech.
    Des. 130, 082601; the half-space is left out as docs/theory/rings.md says.

    Valid
    -----
    Small displacement; the turn of an arc, which would move its groove centre aside, is left out.
    """

    ring: BoltedGrooveRing
    length: float  # l of the loaded lines [m]
    response: NDArray  # (N + 1, 4, 4) [m/N] W_n: at +x outward, +x; at -x likewise; by forces in that order
    unknowns: int
    seconds: dict[str, float] = field(compare=False)  # by stage: factor, condense

    @property
    def harmonics(self) -> int:
        """N, the highest harmonic."""
        return len(self.response) - 1

    def at(self, balls: int) -> NDArray:
        """Compliance of both arcs.

        Parameters
        ----------
        balls : int
            Z, 3 or more

        Returns
        -------
        array (Z, 2, 2, 2, 2)
            C(d) [m/N]: arc (+x, -x) and component (outward, +x) by those of the force, d pitches apart;
            symmetric

        Raises
        ------
        NotSolved
            if the harmonics end too early
        """
        if not self.truncation <= TRUNCATED:
            raise NotSolved(
                f"{self.truncation:.2g} of the own compliance lies beyond harmonic {self.harmonics}, allowed "
                f"{TRUNCATED:g}: take more harmonics or a finer mesh of the lines"
            )
        phi = 2 * np.pi * np.arange(balls) / balls
        waves = np.cos(np.outer(phi, np.arange(self.harmonics + 1))) * self._weights
        row = np.tensordot(waves, self._remainder, axes=1) + sum_beyond(self._remainder, phi)
        place = self.ring.contact_radius, self.length, self.ring.elastic
        row[1:] += _turned(self.ring, line_answers(phi[1:], *place))
        return ((row + row.swapaxes(1, 2)) / 2).reshape(balls, 2, 2, 2, 2)

    @property
    def truncation(self) -> float:
        """Part of the own terms that is extrapolated beyond the last harmonic [-]."""
        beyond = sum_beyond(self._remainder, np.zeros(1))[0]
        own_terms = np.tensordot(self._weights, self._remainder, axes=1) + beyond
        size = np.abs(np.diag(own_terms)) + np.diag(np.tensordot(self._weights, self._half_space, axes=1))
        return float(np.abs(beyond).max() / size.max())

    @property
    def _weights(self) -> NDArray:
        """How often each harmonic is in the sum over n of both signs (N + 1,) [-]."""
        return np.where(np.arange(self.harmonics + 1) > 0, 2.0, 1.0)

    @cached_property
    def _half_space(self) -> NDArray:
        """Harmonics of the half-space (N + 1, 4, 4) [m/N]."""
        place = self.ring.contact_radius, self.length, self.ring.elastic
        return _turned(self.ring, line_harmonics(np.arange(self.harmonics + 1), *place))

    @cached_property
    def _remainder(self) -> NDArray:
        """What every harmonic answers beside the half-space (N + 1, 4, 4) [m/N]."""
        return self.response - self._half_space


@threads(1)  # sections are small: a second thread would only wait
def condense_groove(
    ring: BoltedGrooveRing, resolution: Resolution, stage: Stage, seconds: dict
) -> ArchCompliance:
    """Compliance of both arcs of a ring on its bolted face.

    Parameters
    ----------
    ring : BoltedGrooveRing
        the part
    resolution : Resolution
        l of the loaded lines, a fifth of the ball is near a heavily loaded contact; of mesh order 5 or 6
        pays; harmonics by default 6 R/l or what the mesh resolves
    stage : callable (name)
        around "factor" and "condense"
    seconds : dict
        of the stages

    Returns
    -------
    ArchCompliance

    Raises
    ------
    ImpossiblePart
        if the lines leave the arcs
    NotSolved
        if a solve fails, or the mesh is too coarse for the harmonics
    """
    length, mesh = resolution.length, resolution.mesh
    last = highest_harmonic(ring.contact_radius, length, mesh, resolution.harmonics)
    with stage("factor"):
        body = body_of(ring, length, mesh)
    with stage("condense"):
        W = responses(body, FreeMotions(), line_forces(body, length), last) / (2 * np.pi)
    return ArchCompliance(
        ring=ring, length=length, response=W, unknowns=body.stiffness.unknowns, seconds=seconds
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
    """Load vectors (unknowns, 4) of unit forces on the lines: arc at +x outward, +x; arc at -x likewise.

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


def _turned(ring: BoltedGrooveRing, answers: NDArray) -> NDArray:
    """Answers normal and along the lines (..., 2) as those to outward and axial forces (..., 4, 4)."""
    cosine, sine = np.cos(ring.contact_angle), np.sin(ring.contact_angle)
    both = np.zeros((*answers.shape[:-1], 4, 4))
    for arc, side in enumerate((ring.outward, -ring.outward)):
        axes = np.array([[cosine, side * sine], [-sine, side * cosine]])  # normal, along; signs cancel
        forces = slice(2 * arc, 2 * arc + 2)
        both[..., forces, forces] = np.einsum("...k,ki,kj->...ij", answers, axes, axes)
    return both
