"""How the seat of the flange widens the raceway of a squirrel cage, on half a pitch."""

import ngsolve as ngs
import numpy as np
from numpy.polynomial import legendre

from fem.assembly.elasticity import elastic_energy, lame_constants
from fem.assembly.factorisation import factorised, threads
from fem.mesh.half_pitch import half_pitch
from fem.mesh.solid import MILLIMETRES
from fem.parts.resolution import Resolution
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.growth import RacewayGrowth

WAVES = 4  # of the ripple by the bars: cos(k bars phi), k below it
STIFF = 1e6  # springs that keep a plane of symmetry, over modulus through pitch
EXACT = 4  # orders of quadrature beyond that of the displacement


def cage_seat_growth(cage: SquirrelCage, resolution: Resolution) -> RacewayGrowth:
    r"""Growth of the raceway of a squirrel cage whose flange rests on a seat that expands.

    .. math:: w_{km} = \frac{(2 - \delta_{k0})(2m + 1)}{l a R} \int L_m(2x/l) \cos(k N \varphi)\,u_r\,dA

    over half a pitch a; cage and seat expand alike first, then the cage shrinks by as much in a clamp that
    stays.

    w [m] is per strain of the seat beyond that of the cage.
    Raises `NotSolved` if a residual is too large.

    Source
    ------
    Thermoelasticity by superposition on a cyclic sector with planes of symmetry; derived here.

    Valid
    -----
    Small displacement; the seat expands evenly and is rigid to forces.
    """
    length, mesh_size = resolution.length, resolution.mesh
    pitch = np.pi / cage.bars
    with threads(1):
        mesh = half_pitch(cage, length, mesh_size, graded_clamp=True, nodes_of=resolution.nodes_of)
        space = ngs.VectorH1(mesh, order=mesh_size.order, dirichlet="clamped")
        factored = factorised(space, _energy(cage, mesh, pitch))
        u = ngs.GridFunction(space)
        u.vec.FV().NumPy()[:] = factored.solve(_shrinking(cage, space))
        radius, azimuth = ngs.sqrt(ngs.y**2 + ngs.z**2), ngs.atan2(ngs.y, ngs.z)
        outward = (ngs.y * u[1] + ngs.z * u[2]) / radius
        shapes = _polynomials(2 * ngs.x / (length * MILLIMETRES), resolution.axial_modes)
        band = length * pitch * cage.raceway_diameter / 2 * MILLIMETRES**2
        coefficients = np.array([
            [
                (2 - (k == 0)) * (2 * m + 1) / band
                * ngs.Integrate(
                    L * ngs.cos(k * cage.bars * azimuth) * outward, mesh, ngs.BND,
                    order=2 * mesh_size.order + EXACT, definedon=mesh.Boundaries("raceway"),
                )
                for m, L in enumerate(shapes)
            ]
            for k in range(WAVES)
        ])  # fmt: skip
    coefficients[0, 0] += cage.raceway_diameter / 2
    return RacewayGrowth(coefficients, cage.bars)


def _polynomials(xi, count: int) -> list:
    """Legendre polynomials of a coefficient function."""
    powers = [xi**k for k in range(count)]
    return [
        sum(float(c) * power for c, power in zip(legendre.leg2poly([0] * m + [1]), powers, strict=False))
        for m in range(count)
    ]


def _energy(cage: SquirrelCage, mesh, pitch: float):
    """Elastic energy of half a pitch, its planes of symmetry held by springs across them."""
    elastic = elastic_energy(mesh, cage.materials)
    width = pitch * cage.raceway_diameter / 2
    spring = STIFF * cage.elastic.youngs_modulus / width / MILLIMETRES**2  # [N/m^3] over areas in mm^2
    planes = {"middle": (0.0, 1.0, 0.0), "cut": (0.0, np.cos(pitch), -np.sin(pitch))}

    def energy(u, v):
        form = elastic(u, v)
        for name, normal in planes.items():
            across = ngs.CF(normal)
            form += spring * (u * across) * (v * across) * ngs.ds(name)
        return form

    return energy


def _shrinking(cage: SquirrelCage, space):
    """Load vector (unknowns,) [N] of a free thermal strain of -1."""
    lame, shear = lame_constants(cage.elastic.youngs_modulus, cage.elastic.poisson_ratio)
    v = space.TestFunction()
    load = ngs.LinearForm(-(3 * lame + 2 * shear) / MILLIMETRES**2 * ngs.div(v) * ngs.dx).Assemble()
    return load.vec.FV().NumPy().copy()
