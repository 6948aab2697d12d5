"""Viscosity ratio of an oil, and the a_ISO that no cleanliness exceeds, of any rolling bearing."""

from quasidynamic.outcome.life_factors import (
    LEAST_VISCOSITY_RATIO,
    ModifiedBy,
    modification_factor,
    reference_viscosity,
)


def of_oil(
    viscosity: float, speed: float, pitch_diameter: float, load_ratio: float, elements: ModifiedBy
) -> dict[str, float]:
    r"""Both viscosities of ISO 281, their ratio, and a_ISO with clean oil.

    .. math:: \kappa = \nu / \nu_1,\quad a_{ISO} \le a_{ISO}(\kappa, C_u / P) \;(e_C = 1)

    Parameters
    ----------
    viscosity : float
        nu, kinematic, at the temperature of the inlets [m2/s], > 0
    speed : float
        of one ring against the other [rad/s]
    pitch_diameter : float
        D_pw [m], > 0
    load_ratio : float
        C_u/P [-], >= 0
    elements : ModifiedBy
        constants of rollers or of balls

    Returns
    -------
    dict
        "viscosity" and "reference_viscosity" [m2/s], "viscosity_ratio" [-]; from its least value on
        "largest_a_ISO" [-], as a_ISO grows with e_C

    Raises
    ------
    OutOfRange
        at rest

    Source
    ------
    ISO 281 (2007), section 9.3.3 and Eqs. 31-36; e_C is at most 1, annex A.

    Valid
    -----
    As `reference_viscosity` and `modification_factor`.
    """
    needed = float(reference_viscosity(speed, pitch_diameter))
    ratio = viscosity / needed
    found = {"viscosity": viscosity, "reference_viscosity": needed, "viscosity_ratio": ratio}
    if ratio >= LEAST_VISCOSITY_RATIO:
        found["largest_a_ISO"] = float(modification_factor(ratio, load_ratio, elements).value)
    return found
