"""The loaded strip of a line contact: the traction and the heat of the stress in its film."""

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line import half_width
from quasidynamic.contact.traction.traction_law import Traction


class LineContact(Protocol):
    """A line contact: what its strip depends on besides the load."""

    @property
    def radius(self) -> NDArray | float:
        """Reduced radius [m]."""
        ...

    @property
    def modulus(self) -> NDArray | float:
        """Contact modulus [Pa]."""
        ...

    @property
    def smallest_load(self) -> float:
        """Load q/(E' R) below which strip width over load keeps its value [-]."""
        ...


class LoadedStrip(NamedTuple):
    """Hertzian strip under the load of a contact, taken not below the smallest one."""

    load_share: NDArray  # d ln load / d ln q
    half_width: NDArray  # [m] b
    pressure: NDArray  # [Pa] mean


def loaded_strip(line_load: NDArray, law: LineContact) -> LoadedStrip:
    r"""Strip of a Hertzian line contact, none narrower than at the smallest load.

    .. math:: \tilde q = \sqrt{q^2 + q_0^2},\quad b = \sqrt{8 \tilde q R/(\pi E')},\quad
              \bar p = \tilde q/(2 b)

    Parameters
    ----------
    line_load : array (...)
        q, load per length [N/m], >= 0
    law : LineContact
        R [m], E' [Pa] and the smallest load q_0/(E' R) [-]

    Returns
    -------
    LoadedStrip
        b [m], mean pressure [Pa] and d ln(floored load)/d ln q [-]

    Source
    ------
    Johnson, Contact Mechanics (1985), sec. 4.2; q_0 keeps b/q finite at zero load.
    """
    squared = line_load * line_load
    floored = squared + (law.smallest_load * law.modulus * law.radius) ** 2
    load = np.sqrt(floored)
    b = half_width(load, law.radius, law.modulus)
    return LoadedStrip(load_share=squared / floored, half_width=b, pressure=load / (2 * b))


class ShearStress(NamedTuple):
    """Shear stress of a film, >= 0, with its derivatives."""

    stress: NDArray  # [Pa]
    by_log_load: NDArray  # [Pa] by ln of the floored load
    by_sliding: NDArray  # [Pa s/m] by the size of the sliding
    by_entrainment: NDArray  # [Pa s/m]
    by_film: NDArray  # [Pa/m]


def limited_stress(shear: ShearStress, limit: NDArray) -> ShearStress:
    r"""Stress held at a limiting shear stress.

    .. math:: \tau \leftarrow \min(\tau,\; \Lambda \bar p),\quad \bar p \sim q^{1/2}

    A film that warms needs no second solution: less stress is less heat, and the colder film is stiffer.

    Parameters
    ----------
    shear : ShearStress
        tau [Pa] without a limit, with its derivatives
    limit : array (...)
        limiting shear stress, in proportion to the mean pressure [Pa], >= 0

    Returns
    -------
    ShearStress
        at most the limit, with its derivatives; a kink where it is reached

    Source
    ------
    Limiting shear stress in proportion to the pressure: Evans and Johnson (1986).
    """
    below = shear.stress <= limit
    return ShearStress(
        stress=np.minimum(shear.stress, limit),
        by_log_load=np.where(below, shear.by_log_load, 0.5 * limit),
        by_sliding=below * shear.by_sliding,
        by_entrainment=below * shear.by_entrainment,
        by_film=below * shear.by_film,
    )


def film_traction(shear: ShearStress, strip: LoadedStrip, line_load: NDArray, sliding: NDArray) -> Traction:
    r"""Traction per length of a film under shear stress.

    .. math:: F = \operatorname{sgn}(u_s)\, \frac{q}{\bar p}\, \tau,\quad \bar p \sim \tilde q^{1/2}

    that is 2 b tau above the smallest load; below it the friction coefficient tau/p keeps its value.

    Parameters
    ----------
    shear : ShearStress
        tau [Pa], >= 0
    strip : LoadedStrip
        mean pressure [Pa] of the floored load
    line_load : array (...)
        q, load per length [N/m], >= 0
    sliding : array (...)
        u_s, raceway over roller surface [m/s], any sign

    Returns
    -------
    Traction
        [N/m] signed like the sliding, with its derivatives

    Source
    ------
    Stress times area of the strip, derived here.
    """
    sign = np.sign(sliding)
    coefficient = shear.stress / strip.pressure
    width = line_load / strip.pressure  # 2b above the smallest load
    signed_width = sign * width
    by_log_load = shear.by_log_load / strip.pressure - 0.5 * coefficient
    return Traction(
        force=signed_width * shear.stress,
        by_load=sign * (coefficient + strip.load_share * by_log_load),
        by_sliding=width * shear.by_sliding,
        by_entrainment=signed_width * shear.by_entrainment,
        by_film=signed_width * shear.by_film,
    )


def friction_intensity(
    traction: NDArray, sliding: NDArray, line_load: NDArray, radius: NDArray, modulus: NDArray
) -> NDArray:
    r"""Heat of the sliding per area of a line contact, mean over its width.

    .. math:: \frac{|F u_s|}{2 b},\quad b = \sqrt{8 q R/(\pi E')}

    Parameters
    ----------
    traction : array (...)
        F, along the sliding, per length [N/m], any sign
    sliding : array (...)
        u_s, raceway over roller surface [m/s], any sign
    line_load : array (...)
        q, load per length [N/m], >= 0
    radius, modulus : array (...)
        R, reduced radius [m], and E' [Pa], see `peak_pressure`

    Returns
    -------
    array (...)
        [W/m2] >= 0, zero without load

    Source
    ------
    Frictional power intensity, shear stress times sliding speed, as in Fowell, Ioannides and Kadiric,
    Tribology Transactions 57 (2014) 472 (cited from memory); width by Hertz.

    Valid
    -----
    No limit is declared for it: published ones belong to the oils, surfaces and rigs of their tests.

    >>> round(float(friction_intensity(3e3, 0.5, 3e5, 6.4e-3, 228e9)) / 1e6, 2)  # 2b of 293 um
    5.12
    """
    area = 2 * half_width(line_load, radius, modulus)  # per length
    heat = np.abs(np.asarray(traction) * sliding)
    return np.divide(heat, area, out=np.zeros(np.broadcast_shapes(heat.shape, area.shape)), where=area > 0)
