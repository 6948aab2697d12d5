"""Asperities of rough surfaces that carry some of the load in a case."""

from collections.abc import Callable
from functools import partial

from numpy.typing import NDArray

from flexbearing.case.film_oil import Mixed
from quasidynamic.contact.traction import TractionLaw, in_any_contact
from quasidynamic.contact.traction.asperity_friction import AsperityFriction, Carter, RoundedCoulomb
from quasidynamic.contact.traction.mixed import (
    FILM_SHARE_1_8,
    ZHOU_HOEPRICH,
    AsperityShare,
    ErrorFunctionShare,
    RoughContacts,
)

SHARES: dict[str, AsperityShare] = {
    "zhou-hoeprich": ZHOU_HOEPRICH,
    "film-1.8": FILM_SHARE_1_8,
    "error-function": ErrorFunctionShare(),
}


def mixed(given: Mixed, roughness: NDArray, fluid: Callable[..., TractionLaw]) -> RoughContacts:
    """Law of the film where asperities carry some of the load, at a roughness (2) of both contacts [m]."""
    inner, outer = roughness.tolist()
    return RoughContacts(
        fluid=fluid,
        share=SHARES[given.share],
        asperities=_ASPERITIES[given.asperity_friction](given),
        inner_roughness=inner,
        outer_roughness=outer,
    )


def _rounded(given: Mixed) -> Callable[..., AsperityFriction]:
    law = RoundedCoulomb(coefficient=given.boundary_friction, sign_speed=given.sign_speed)
    return partial(in_any_contact, law)


_ASPERITIES: dict[str, Callable[[Mixed], Callable[..., AsperityFriction]]] = {
    "rounded": _rounded,
    "carter": lambda given: partial(Carter, coefficient=given.boundary_friction),
}
