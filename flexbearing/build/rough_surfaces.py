"""Rough surfaces of a case: composite roughness, and asperities that carry some of the load."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

import quasidynamic as qd
from flexbearing.case.roller import Case
from quasidynamic.contact.film import composite_roughness
from quasidynamic.contact.traction import TractionLaw
from quasidynamic.contact.traction.mixed import (
    FILM_SHARE_1_8,
    ZHOU_HOEPRICH,
    AsperityShare,
    ErrorFunctionShare,
)

SHARES: dict[str, AsperityShare] = {
    "zhou-hoeprich": ZHOU_HOEPRICH,
    "film-1.8": FILM_SHARE_1_8,
    "error-function": ErrorFunctionShare(),
}


def roughness(case: Case) -> NDArray | None:
    """Composite roughness (2) of inner and outer contact [m]; None when the case does not give it."""
    surfaces = case.bearing.roughness
    if surfaces is None:
        return None
    return composite_roughness(surfaces.roller, [surfaces.inner_raceway, surfaces.outer_raceway])


def mixed(case: Case, fluid: Callable[..., TractionLaw], **contact: Any) -> TractionLaw:
    """Law of the film where asperities carry some of the load."""
    given, sigma = case.lubricant.mixed, roughness(case)
    assert given is not None  # checked on reading
    assert sigma is not None
    inner, outer = sigma
    ratio = np.reshape([1.0, inner / outer], (2, 1, 1))
    return qd.Mixed(
        fluid=fluid(**contact),
        share=OtherRoughness(SHARES[given.share], ratio),
        roughness=float(inner),
        boundary_friction=given.boundary_friction,
        sign_speed=given.sign_speed,
    )


@dataclass(frozen=True)
class OtherRoughness:
    """Asperity share where a raceway is not as rough as the one the film ratio was formed with."""

    share: AsperityShare
    ratio: NDArray  # [-] roughness of the film ratio over that of the contact, inner and outer raceway

    def __call__(self, film_ratio: NDArray) -> tuple[NDArray, NDArray]:
        """Share and its derivative by the film ratio."""
        share, slope = self.share(film_ratio * self.ratio)
        return share, slope * self.ratio
