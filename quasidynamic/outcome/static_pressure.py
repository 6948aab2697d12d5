"""Static safety by contact pressure."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

# [Pa] a lasting dent of 1e-4 of the rolling element's diameter, over which static ratings are defined
ROLLERS, BALLS, SELF_ALIGNING_BALLS = 4.0e9, 4.2e9, 4.6e9
LINE, POINT = 2.0, 3.0  # pressure to this power goes with the load


def pressure_safety(pressure: ArrayLike, limit: float, exponent: float) -> Any:
    r"""Static safety of a contact: load over that of the static rating's pressure, by the pressure alone.

    .. math:: s_p = (p_{lim}/p_{max})^n

    with n = 2 of line and 3 of point contact, so that it falls with the load of the contact as s_0 does with
    that of the bearing.

    Parameters
    ----------
    pressure : float or array (...)
        p_max [Pa], >= 0
    limit : float
        p_lim [Pa]: `ROLLERS`, `BALLS` or `SELF_ALIGNING_BALLS`
    exponent : float
        n [-]: `LINE` or `POINT`

    Returns
    -------
    float or array (...)
        s_p [-]; infinite without pressure

    Source
    ------
    ISO 76 (2006) for the pressures of 4000 MPa (rollers), 4200 MPa (balls), 4600 MPa (self-aligning balls);
    Hertz for the exponents.

    Valid
    -----
    Hardened bearing steel, elastic contact: above the limit the pressure itself is overstated. At the end of
    a roller it is the safety of that place, not of the load of the roller.
    """
    with np.errstate(divide="ignore"):
        return ((limit / np.asarray(pressure, dtype=float)) ** exponent)[()]
