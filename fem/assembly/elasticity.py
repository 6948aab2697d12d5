"""Weak forms of linear elasticity, one function each."""

import ngsolve as ngs

from fem.mesh.solid import MILLIMETRES
from fem.parts.material import Elastic


def strain(u):
    r"""Strain of a small displacement.

    .. math:: \varepsilon(u) = (\nabla u + \nabla u^T)/2

    Parameters
    ----------
    u : ngsolve.CoefficientFunction (d,)
        displacement [m]

    Returns
    -------
    ngsolve.CoefficientFunction (d, d)
        strain [-] for coordinates in metres

    Source
    ------
    Definition of the small strain tensor; any text on elasticity, e.g. Braess, Finite Elements (2007), ch.
    VI.
    """
    return ngs.Sym(ngs.Grad(u))


def elasticity(u, v, lame, shear):
    r"""Virtual work of the stresses, in 3-D, plane strain or plane stress.

    .. math:: a(u, v) = \int 2\mu\,\varepsilon(u):\varepsilon(v) + \lambda\,\nabla\!\cdot u\,\nabla\!\cdot v

    Parameters
    ----------
    u, v : ngsolve proxies (d,)
        trial and test displacement
    lame, shear : float or ngsolve.CoefficientFunction
        lambda and mu [Pa]; from `lame_constants`

    Source
    ------
    Any text on elasticity, e.g. Braess, Finite Elements (2007), ch. VI.
    """
    return (2 * shear * ngs.InnerProduct(strain(u), strain(v)) + lame * ngs.div(u) * ngs.div(v)) * ngs.dx


def elastic_energy(mesh, materials: dict[str, Elastic]):
    """Weak form (u, v) of bodies on a mesh in millimetres, each with the `Elastic` of its name.

    Its matrix is in N/m: a modulus in Pa integrated over millimetres is one in mN/m.
    """
    constants = {name: lame_constants(m.youngs_modulus, m.poisson_ratio) for name, m in materials.items()}
    lame, shear = (
        mesh.MaterialCF({name: values[k] / MILLIMETRES for name, values in constants.items()}) for k in (0, 1)
    )
    return lambda u, v: elasticity(u, v, lame, shear)


def lame_constants(youngs_modulus, poisson_ratio):
    r"""Constants of an isotropic solid, also for plane strain.

    .. math:: \lambda = \frac{E\nu}{(1+\nu)(1-2\nu)}, \quad \mu = \frac{E}{2(1+\nu)}

    Parameters
    ----------
    youngs_modulus : float
        E [Pa], > 0
    poisson_ratio : float
        nu [-], -1 < nu < 1/2

    Returns
    -------
    tuple of float
        lambda, mu [Pa]

    Source
    ------
    Any text on elasticity, e.g. Braess, Finite Elements (2007), ch. VI.
    """
    E, nu = youngs_modulus, poisson_ratio
    return E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
