"""A raceway on a body of revolution, condensed harmonic by harmonic on the axial section."""

import logging
import time

import numpy as np

from fem.assembly.factorisation import threads
from fem.parts.rings import ImpossiblePart, MeshSize, OuterRing, RingOnShaft, require_on_track
from fem.raceway.harmonics import HarmonicCompliance, highest_harmonic
from fem.section.revolved_body import edge_modes
from fem.section.rigid_body_modes import body_of, responses

_log = logging.getLogger(__name__)


def condense(
    part: OuterRing | RingOnShaft,
    length: float,
    axial_modes: int,
    mesh: MeshSize,
    harmonics: int | None = None,
) -> HarmonicCompliance:
    r"""Compliance of the raceway of a body of revolution, for rollers anywhere.

    .. math:: W_n = \frac{1}{2\pi}\,G^T K(n)^{-1} G, \quad g_m = \int a_m v_r\,dx

    Parameters
    ----------
    part : OuterRing, RingOnShaft
        body of revolution with its seat
    length : float
        l of the loaded band [m]
    axial_modes : int
        M, number of axial modes, 1 or more
    mesh : MeshSize
        wishes for the finite elements; order 5 or 6 pays
    harmonics : int
        N, the highest; by default 6 M R/l or what the mesh resolves

    Returns
    -------
    HarmonicCompliance

    Raises
    ------
    ImpossiblePart
        if the band is longer than the track, or the part not a body of revolution, held as such
    NotSolved
        if a solve fails, or if the mesh is too coarse for the harmonics

    Source
    ------
    Body of revolution in harmonics, virtual work per radian; derived here.

    Valid
    -----
    Small displacement, perfect bonds, clamps that do not yield; no load outside the band.
    """
    require_on_track(length, part.track)
    if isinstance(part, OuterRing) and part.free_motions.across:
        raise ImpossiblePart(
            "a ring that nothing holds has no compliance; `fem.section.supported_ring` adds the lines"
        )
    radius = part.raceway_diameter / 2
    last = highest_harmonic(radius, length / axial_modes, mesh, harmonics)
    start = time.perf_counter()
    with threads(1):  # sections are small: a second thread would only wait
        body = body_of(part, length, mesh)
        ready = time.perf_counter()
        W = responses(body, part.free_motions, edge_modes(body, "raceway", axial_modes), last) / (2 * np.pi)
    done = time.perf_counter()
    _log.info("%s: %d unknowns, %.1f s", type(part).__name__, body.stiffness.unknowns, done - start)
    return HarmonicCompliance(
        harmonics=np.arange(-last, last + 1),
        response=np.concatenate([W[:0:-1], W]),
        radius=radius,
        length=length,
        elastic=part.materials["ring"],
        bars=None,
        unknowns=body.stiffness.unknowns,
        elements=body.space.mesh.ne,
        seconds={"factor": ready - start, "condense": done - ready},
    )
