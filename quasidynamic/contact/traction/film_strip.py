"""The loaded strip of a line contact: from the stress in its film to a traction."""

from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.line.hertz import half_width
from quasidynamic.contact.traction.traction_law import Traction


class LineContact(Protocol):
    """What a strip depends on besides its load."""

    @property
    def radius(self) -> NDArray | float:
        """Reduced radius [m]."""
        ...

    @property
    def modulus(self) -> NDArray | float:
        """Contact modulus [Pa]."""
        ...

    @property
    def length(self) -> float:
        """Effective length [m]."""
        ...

    @property
    def load_floor(self) -> float:
        """Load below which strip width over load keeps its value [N]."""
        ...


class LoadedStrip(NamedTuple):
    """Contact strip of the floored load."""

    load_share: NDArray  # d ln load / d ln q
    half_width: NDArray  # [m] b
    pressure: NDArray  # [Pa] mean


def loaded_strip(line_load: NDArray, law: LineContact) -> LoadedStrip:
    """Strip of a Hertzian line contact under loads per length [N/m], none narrower than at the load floor."""
    squared = line_load * line_load
    floored = squared + (law.load_floor / law.length) ** 2
    load = np.sqrt(floored)
    b = half_width(load, law.radius, law.modulus)
    return LoadedStrip(load_share=squared / floored, half_width=b, pressure=load / (2 * b))


class ShearStress(NamedTuple):
    """Stress [Pa], >= 0, with its derivatives; the load is the floored one."""

    stress: NDArray
    by_log_load: NDArray
    by_sliding: NDArray
    by_entrainment: NDArray
    by_film: NDArray


def limited_stress(shear: ShearStress, limit: NDArray) -> ShearStress:
    """Stress cut at a limit that grows with the square root of the load; a kink.

    A film that warms needs no second look: less stress is less heat, and the colder film is stiffer.
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
    """Force q tau/p_mean, signed like the sliding; p_mean ~ load^(1/2)."""
    sign = np.sign(sliding)
    coefficient = shear.stress / strip.pressure
    width = line_load / strip.pressure
    pull = sign * width
    return Traction(
        force=pull * shear.stress,
        by_load=sign
        * (coefficient + strip.load_share * (shear.by_log_load / strip.pressure - 0.5 * coefficient)),
        by_sliding=width * shear.by_sliding,
        by_entrainment=pull * shear.by_entrainment,
        by_film=pull * shear.by_film,
    )
