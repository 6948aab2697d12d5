r"""A squirrel cage as a body of revolution, its bars smeared into a sleeve.

The sleeve carries what its bars carry: along x and r the plane stress of plates that stand upright, no hoop
stress at all, and against tangential shear what bars do that bend,

.. math:: 2\pi a_n = N b \int \left[\tfrac{E}{1-\nu^2} (\varepsilon_x^2 + \varepsilon_r^2
          + 2\nu\,\varepsilon_x \varepsilon_r) + G (\gamma_{xr}^2 + \gamma_{rt}^2) + G_t \gamma_{xt}^2\right]
          dx\,dr, \quad G_t = \frac{L}{b h\,c_t}

with c_t the tangential offset of the ends of a bar per force (`fem.beam.support_springs`).

Source
------
Work of a bar spread over its pitch; derived here.
"""

import logging
import time

import ngsolve as ngs
import numpy as np

from fem.assembly import harmonic_elasticity as forms
from fem.assembly.elasticity import lame_constants
from fem.assembly.factorisation import threads
from fem.assembly.harmonic_stiffness import compliances, harmonic_stiffness
from fem.beam.curved_beam import shear_modulus
from fem.beam.support_springs import tangential_slide
from fem.mesh.axial_section import AxialSection, meshed
from fem.parts.rings import MeshSize, SquirrelCage, require_on_track
from fem.raceway.harmonics import HarmonicCompliance, highest_harmonic
from fem.section.revolved_body import Body, edge_modes

_log = logging.getLogger(__name__)


def condense(
    cage: SquirrelCage, length: float, axial_modes: int, mesh: MeshSize, harmonics: int | None = None
) -> HarmonicCompliance:
    """Compliance of the raceway of a squirrel cage with smeared bars, for rollers anywhere.

    Parameters
    ----------
    cage : SquirrelCage
        ring, bars and flange; fillets are left out
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
        of revolution: no harmonic couples to those that differ by the number of bars

    Raises
    ------
    ImpossiblePart
        if the band is longer than the track
    NotSolved
        if a solve fails, or if the mesh is too coarse for the harmonics

    Valid
    -----
    Many bars, with several per wave of the harmonics that reach them, and slots as wide as they are.
    """
    require_on_track(length, cage.track)
    radius = cage.raceway_diameter / 2
    last = highest_harmonic(radius, length / axial_modes, mesh, harmonics)
    start = time.perf_counter()
    with threads(1):  # sections are small: a second thread would only wait
        body = _assembled(cage, length, mesh)
        ready = time.perf_counter()
        W = compliances(body.stiffness, edge_modes(body, "raceway", axial_modes), last) / (2 * np.pi)
    done = time.perf_counter()
    _log.info("smeared cage: %d unknowns, %.1f s", body.stiffness.unknowns, done - start)
    return HarmonicCompliance(
        harmonics=np.arange(-last, last + 1),
        response=np.concatenate([W[:0:-1], W]),
        radius=radius,
        length=length,
        elastic=cage.elastic,
        bars=None,
        unknowns=body.stiffness.unknowns,
        elements=body.space.mesh.ne,
        seconds={"factor": ready - start, "condense": done - ready},
    )


def _sections(cage: SquirrelCage, length: float) -> list[AxialSection]:
    """Ring, sleeve and flange as polygons that touch along whole edges."""
    inner, side, half = cage.raceway_diameter / 2, cage.width / 2, length / 2
    outer, foot = inner + cage.thickness, side + cage.bar_length
    low, high = ((inner + outer + sign * cage.bar_thickness) / 2 for sign in (-1, 1))
    end = foot + cage.flange_length
    ring = AxialSection("ring", (
        (-side, inner, None), (-half, inner, None), (half, inner, "raceway"), (side, inner, None),
        (side, low, None), (side, high, None), (side, outer, None), (-side, outer, None),
    ))  # fmt: skip
    sleeve = AxialSection(
        "bars", ((side, low, None), (foot, low, None), (foot, high, None), (side, high, None))
    )
    flange = AxialSection("flange", (
        (foot, inner, None), (end, inner, None), (end, outer, "clamped"), (foot, outer, None),
        (foot, high, None), (foot, low, None),
    ))  # fmt: skip
    return [ring, sleeve, flange]


def _assembled(cage: SquirrelCage, length: float, mesh: MeshSize) -> Body:
    """Sections with their stiffness; the sleeve has no isotropic one."""
    section = meshed(_sections(cage, length), mesh)
    space = ngs.H1(section, order=mesh.order, dirichlet="clamped") ** 3
    u, v = space.TnT()
    constants = lame_constants(cage.elastic.youngs_modulus, cage.elastic.poisson_ratio)
    lame, shear = (section.MaterialCF({"ring": c, "flange": c}, default=ngs.CF(0.0)) for c in constants)
    whole = forms.elasticity(u, v, lame, shear)
    parts = (a + b for a, b in zip(whole, _sleeve(u, v, cage, section.Materials("bars")), strict=True))
    return Body(space=space, bulk=lame + 2 * shear / 3, stiffness=harmonic_stiffness(space, *parts))


def _sleeve(u, v, cage: SquirrelCage, where):
    """Virtual work of the bars per radian, as the parts without n, with n, with n^2."""
    E, nu, G = cage.elastic.youngs_modulus, cage.elastic.poisson_ratio, shear_modulus(cage.elastic)
    yields = tangential_slide(cage.bar_length, cage.bar_width, cage.bar_thickness, cage.elastic)
    bending = cage.bar_length / (cage.bar_width * cage.bar_thickness * yields)
    plate = E / (1 - nu**2)
    wide = cage.bars * cage.bar_width / (2 * np.pi)  # where a body of revolution has its radius [m]

    def work(a, b):
        plane = plate * (a[0] * b[0] + a[1] * b[1] + nu * (a[0] * b[1] + a[1] * b[0]))
        sheared = G * (a[3] * b[3] + a[5] * b[5]) + bending * a[4] * b[4]
        # strains are per millimetre of metres: 1e3 each, on an area in square millimetres
        return wide * (plane + sheared) * ngs.dx(definedon=where)

    (e, f), (g, h) = forms.strain(u), forms.strain(v)
    return work(e, g), work(e, h) + work(f, g), work(f, h)
