"""Elastic materials."""

from dataclasses import dataclass

from quasidynamic.errors import ImpossiblePart, require_positive


@dataclass(frozen=True, kw_only=True)
class Material:
    """A linear elastic, isotropic material."""

    youngs_modulus: float  # [Pa]
    poisson_ratio: float  # [-] from 0 to below 0.5
    density: float  # [kg/m3]

    def __post_init__(self):
        require_positive("material.youngs_modulus", self.youngs_modulus)
        require_positive("material.density", self.density)
        if not 0.0 <= self.poisson_ratio < 0.5:
            raise ImpossiblePart(f"material.poisson_ratio = {self.poisson_ratio} must be in [0, 0.5)")

    @property
    def plane_compliance(self) -> float:
        """(1 - nu^2)/E [1/Pa], what a body adds to a line contact."""
        return (1.0 - self.poisson_ratio**2) / self.youngs_modulus


def contact_modulus(first: Material, second: Material) -> float:
    r"""Modulus of a pair in the convention of film theory.

    .. math:: E' = 2 / [(1-\nu_1^2)/E_1 + (1-\nu_2^2)/E_2]

    Parameters
    ----------
    first, second : Material
        the touching bodies

    Returns
    -------
    float
        E' [Pa]; twice the E* of contact mechanics

    Source
    ------
    Dowson and Higginson, Elasto-hydrodynamic Lubrication (1966).
    """
    return 2.0 / (first.plane_compliance + second.plane_compliance)
