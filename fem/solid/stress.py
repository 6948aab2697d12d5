"""Stress of a displacement, with its von Mises and principal values."""

from math import pi

import ngsolve as ngs

from fem.assembly import elasticity
from fem.mesh.solid import MILLIMETRES
from fem.parts.material import Elastic

NO_SHEAR = 1e-12  # second invariant over the mean square of a stress, below it all directions are principal


def stress(displacement, materials: dict[str, Elastic]):
    r"""Stress of an isotropic body.

    .. math:: \sigma = 2\mu\,\varepsilon + \lambda\,\mathrm{tr}\,\varepsilon\,I

    Parameters
    ----------
    displacement : ngsolve.GridFunction (3,)
        u [m] on a mesh in millimetres
    materials : dict
        `Elastic` of every body by its name

    Returns
    -------
    ngsolve.CoefficientFunction (3, 3)
        sigma [Pa] in x, y, z, tension positive

    Source
    ------
    Hooke's law; any text on elasticity, e.g. Braess, Finite Elements (2007), ch. VI.
    """
    constants = {
        name: elasticity.lame_constants(m.youngs_modulus, m.poisson_ratio) for name, m in materials.items()
    }
    lame, shear = (
        displacement.space.mesh.MaterialCF({name: values[k] for name, values in constants.items()})
        for k in (0, 1)
    )
    strain = MILLIMETRES * elasticity.strain(displacement)
    return 2 * shear * strain + lame * ngs.Trace(strain) * ngs.Id(3)


def von_mises(stress):
    r"""Equivalent stress of the largest distortion energy.

    .. math:: \sigma_v = \sqrt{\tfrac{3}{2}\,s : s}, \quad s = \sigma - \tfrac{1}{3}\mathrm{tr}\,\sigma\,I

    Parameters
    ----------
    stress : ngsolve.CoefficientFunction (3, 3)
        sigma [Pa]

    Returns
    -------
    ngsolve.CoefficientFunction
        sigma_v [Pa], >= 0

    Source
    ------
    von Mises (1913); any text on strength of materials.
    """
    s = _deviator(stress)
    return ngs.sqrt(1.5 * ngs.InnerProduct(s, s))


def principal(stress):
    r"""Principal stresses by the cosine of a third of an angle.

    .. math:: \sigma_k = \tfrac{1}{3}\mathrm{tr}\,\sigma + 2\sqrt{J_2/3}\,\cos(\theta - 2\pi k/3), \quad
              \cos 3\theta = \tfrac{3\sqrt{3}}{2} J_3 J_2^{-3/2}

    Parameters
    ----------
    stress : ngsolve.CoefficientFunction (3, 3)
        sigma [Pa], symmetric

    Returns
    -------
    ngsolve.CoefficientFunction (3,)
        [Pa], largest first, tension positive

    Source
    ------
    Malvern, Introduction to the Mechanics of a Continuous Medium (1969), sec. 3.3.
    """
    s, mean = _deviator(stress), ngs.Trace(stress) / 3
    second = ngs.InnerProduct(s, s) / 2
    least = NO_SHEAR * ngs.InnerProduct(stress, stress) + 1e-200
    cosine = 1.5 * 3**0.5 * ngs.Det(s) / ngs.IfPos(second - least, second, least) ** 1.5
    # rounding may leave [-1, 1], where acos is not defined
    theta = ngs.acos(ngs.IfPos(cosine - 1, 1, ngs.IfPos(-1 - cosine, -1, cosine))) / 3
    size = 2 * ngs.sqrt(second / 3)
    first, last = (mean + size * ngs.cos(theta + turn) for turn in (0.0, 2 * pi / 3))
    return ngs.CF((first, 3 * mean - first - last, last))


def _deviator(stress):
    return stress - ngs.Trace(stress) / 3 * ngs.Id(3)
