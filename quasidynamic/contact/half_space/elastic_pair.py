"""Elastic constants of two half-spaces in contact."""

from dataclasses import dataclass

from quasidynamic.errors import require_positive
from quasidynamic.parts.material import Material


@dataclass(frozen=True)
class ElasticPair:
    r"""Constants of the relative displacement of two half-spaces under opposite tractions.

    .. math:: \frac{1}{G} = \frac12\left(\frac{1}{G_1} + \frac{1}{G_2}\right),\quad
              \frac{\nu}{G} = \frac12\left(\frac{\nu_1}{G_1} + \frac{\nu_2}{G_2}\right),\quad
              \frac{K}{G} = \frac14\left(\frac{1-2\nu_1}{G_1} - \frac{1-2\nu_2}{G_2}\right)

    Source
    ------
    Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), Eq. (1.44).
    """

    shear: float  # [1/Pa] 1/G
    poisson: float  # [1/Pa] nu/G
    coupling: float = 0.0  # [1/Pa] K/G between pressure and tangential displacement, zero for equal bodies

    def __post_init__(self):
        require_positive("elastic_pair.shear", self.shear)

    @property
    def plane_compliance(self) -> float:
        """1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 [1/Pa]."""
        return self.shear - self.poisson


def elastic_pair(first: Material, second: Material) -> ElasticPair:
    r"""Pair of two materials.

    .. math:: G = E / [2 (1 + \nu)]

    Parameters
    ----------
    first, second : Material
        the body on which tractions are counted, and the other one [Pa]

    Returns
    -------
    ElasticPair
        [1/Pa]

    Source
    ------
    Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990), sec. 1.6.
    """
    one, two = (2 * (1 + body.poisson_ratio) / body.youngs_modulus for body in (first, second))
    return ElasticPair(
        shear=(one + two) / 2,
        poisson=(first.poisson_ratio * one + second.poisson_ratio * two) / 2,
        coupling=((1 - 2 * first.poisson_ratio) * one - (1 - 2 * second.poisson_ratio) * two) / 4,
    )
