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

from dataclasses import replace
from functools import lru_cache

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly import harmonic_elasticity as forms
from fem.assembly.elasticity import lame_constants
from fem.assembly.factorisation import threads
from fem.assembly.harmonic_stiffness import (
    HarmonicAnswers,
    HarmonicStiffness,
    answers,
    compliances,
    harmonic_stiffness,
    near_compliances,
)
from fem.beam.curved_beam import shear_modulus
from fem.beam.support_springs import tangential_slide
from fem.mesh.axial_section import smeared_sections
from fem.mesh.section_mesh import meshed
from fem.mesh.solid import MILLIMETRES
from fem.parts.resolution import Resolution, Shape
from fem.parts.rings import MeshSize
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.bar_response import of_revolution
from fem.raceway.harmonics import RESOLVED, Responses
from fem.section.revolved_body import Body, edge_modes
from fem.stages import Stage

ORDER = 4  # of displacements under short waves
SIZE = 1.2  # of their elements over the length of the band


@threads(1)  # sections are small: a second thread would only wait
def smeared_responses(cage: SquirrelCage, resolution: Resolution, last: int, stage: Stage) -> Responses:
    """Answers of the raceway of a squirrel cage with smeared bars to harmonics 0 .. `last`.

    Fillets are left out. No harmonic couples to those that differ by the number of bars. Order 5 or 6 of the
    displacements pays.
    Raises `NotSolved` if a solve fails.

    Valid
    -----
    Many bars, with several per wave of the harmonics that reach them, and slots as wide as they are.
    """
    with stage("factor"):
        body = assembled_cage(cage, resolution)
    with stage("condense"):
        modes = edge_modes(body, "raceway", resolution.axial_modes)
        readings = np.hstack([_bar_readings(body, cage, end) for end in cage.ends])
        W = compliances(body.stiffness, np.hstack([modes, readings]), last) / (2 * np.pi)
    M = resolution.axial_modes
    read = np.split(W[:, M:, :M], len(cage.ends), axis=1)
    in_bars = np.concatenate([_bar_forces(each, cage.bar_length) for each in read], axis=2)
    bars = of_revolution(cage.bars, in_bars)
    return Responses(W[:, :M, :M], body.stiffness.unknowns, body.space.mesh.ne, bar_response=bars)


@threads(1)
def short_waves(cage: SquirrelCage, resolution: Resolution, first: int, last: int) -> NDArray:
    """Answers of the raceway to harmonics whose waves hardly reach the bars, each to itself.

    They are (last - first + 1, M, M) [m/N]. Fillets are left out; elements are of their own sizes.
    Raises `NotSolved` if a solve fails.

    Valid
    -----
    Waves of a few thicknesses of the ring, or shorter: the bars of `smeared_responses` then matter little.
    """
    shape = resolution.nodes_of or Shape(part=cage, length=resolution.length)
    raceway_size = RESOLVED * ORDER * shape.part.raceway_diameter / 2 / last
    mesh = MeshSize(order=ORDER, size=SIZE * shape.length, raceway_size=raceway_size)
    fine = replace(resolution, mesh_size=mesh)
    stiffness, modes = _under_short_waves(cage, fine, first)
    if resolution.first_order:
        unmoved = replace(fine, length=shape.length, nodes_of=None, first_order=False)
        known = _short_answers(shape.part, unmoved, first, last)
        return near_compliances(known, stiffness, modes) / (2 * np.pi)
    return compliances(stiffness, modes, last - first) / (2 * np.pi)


def _under_short_waves(
    cage: SquirrelCage, resolution: Resolution, first: int
) -> tuple[HarmonicStiffness, NDArray]:
    """Stiffness with harmonics counted from the first one, and loads (unknowns, M) of the raceway."""
    body = assembled_cage(cage, resolution)
    modes = edge_modes(body, "raceway", resolution.axial_modes)
    return body.stiffness.beginning_at(first), modes


@lru_cache(maxsize=1)  # changes of one cage come one after the other
def _short_answers(cage: SquirrelCage, resolution: Resolution, first: int, last: int) -> HarmonicAnswers:
    return answers(*_under_short_waves(cage, resolution, first), last - first)


def _bar_readings(body: Body, cage: SquirrelCage, end: int) -> NDArray:
    r"""Load vectors (unknowns, 5) that read a bar in a sleeve, constant along it or straight on average.

    They are N, M_n and the radial shear from its change along the bar, then the tangential shear as the parts
    without n and with n: :math:`b h \int G_t \gamma_{xt}` over the sleeve's length.
    """
    E, nu = cage.elastic.youngs_modulus, cage.elastic.poisson_ratio
    L, low_high = cage.bar_length * MILLIMETRES, cage.bar_radii
    v, sleeve = body.space.TestFunction(), body.space.mesh.Materials("bars")
    plain, turned = forms.strain(v)
    tension = E / (1 - nu**2) * (plain[0] + nu * plain[1])
    n, xi = ngs.y / MILLIMETRES - sum(low_high) / 2, (end * ngs.x - cage.end_distance(end) * MILLIMETRES) / L
    slope = 12 * (xi - 0.5) * tension * n  # of a straight line: its change from end to end
    sheared = (end * _tangential_modulus(cage) * part[4] for part in (plain, turned))
    # strains are per millimetre of metres, on an area in square millimetres over a length in millimetres
    per_bar = cage.bar_width / L * (ngs.IfPos(end * ngs.x, 1.0, 0.0) if cage.two_sided else 1.0)
    integrands = (tension, tension * n, slope, *sheared)
    return np.stack([body.load(per_bar * f * ngs.dx(definedon=sleeve)) for f in integrands], axis=1)


def _bar_forces(answers: NDArray, length: float) -> NDArray:
    """Section forces (N + 1, M, 6) of a bar from what was read of the sleeve (N + 1, 5, M); no torque."""
    n = np.arange(len(answers))[:, None]
    axial, moment, change, plain, turned = np.moveaxis(answers, 1, 0)
    sideways = -(plain + n * turned) * length / 2  # of the ring on the bar, with equal moments at both ends
    forces = [axial, moment - change / 2, moment + change / 2, sideways, -sideways, np.zeros_like(axial)]
    return np.stack(forces, axis=2)


def assembled_cage(cage: SquirrelCage, resolution: Resolution) -> Body:
    """Sections of a cage with their stiffness; the sleeve of its bars has no isotropic one."""
    other = resolution.nodes_of
    nodes_of = None if other is None else smeared_sections(other.part, other.length)
    section = meshed(smeared_sections(cage, resolution.length), resolution.mesh, nodes_of)
    space = ngs.H1(section, order=resolution.mesh.order, dirichlet="clamped") ** 3
    u, v = space.TnT()
    constants = lame_constants(cage.elastic.youngs_modulus, cage.elastic.poisson_ratio)
    lame, shear = (section.MaterialCF({"ring": c, "flange": c}, default=ngs.CF(0.0)) for c in constants)
    whole = forms.elasticity(u, v, lame, shear)
    parts = (a + b for a, b in zip(whole, _sleeve(u, v, cage, section.Materials("bars")), strict=True))
    return Body(space=space, bulk=lame + 2 * shear / 3, stiffness=harmonic_stiffness(space, *parts))


def _sleeve(u, v, cage: SquirrelCage, where):
    """Virtual work of the bars per radian, as the parts without n, with n, with n^2."""
    E, nu, G = cage.elastic.youngs_modulus, cage.elastic.poisson_ratio, shear_modulus(cage.elastic)
    bending = _tangential_modulus(cage)
    plate = E / (1 - nu**2)
    wide = cage.bars * cage.bar_width / (2 * np.pi)  # where a body of revolution has its radius [m]

    def work(a, b):
        plane = plate * (a[0] * b[0] + a[1] * b[1] + nu * (a[0] * b[1] + a[1] * b[0]))
        sheared = G * (a[3] * b[3] + a[5] * b[5]) + bending * a[4] * b[4]
        # strains are per millimetre of metres: 1e3 each, on an area in square millimetres
        return wide * (plane + sheared) * ngs.dx(definedon=where)

    (e, f), (g, h) = forms.strain(u), forms.strain(v)
    return work(e, g), work(e, h) + work(f, g), work(f, h)


def _tangential_modulus(cage: SquirrelCage) -> float:
    """G_t, shear modulus along x and t of a sleeve whose bars bend [Pa]."""
    compliance = tangential_slide(cage.bar_length, cage.bar_width, cage.bar_thickness, cage.elastic)
    return cage.bar_length / (cage.bar_width * cage.bar_thickness * compliance)
