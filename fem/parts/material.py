"""Elastic materials as frozen data; what cannot exist is refused here for all parts."""

from dataclasses import dataclass
from math import isfinite


class ImpossiblePart(ValueError):
    """A part or a resolution that cannot exist; the message says what, found and allowed."""


def require(holds: bool, name: str, value: object, allowed: str) -> None:
    """Refuse an impossible value.

    Raises `ImpossiblePart` unless it holds.
    """
    if not holds:
        raise ImpossiblePart(f"{name} = {value} is impossible; allowed is {allowed}")


def in_mm(length: float) -> str:
    """A length [m] as people write it."""
    return f"{1e3 * length:.5g} mm"


def require_positive(part: object, *names: str) -> None:
    """Refuse a part with an attribute that is not a finite number above zero.

    Raises `ImpossiblePart` for the first such attribute.
    """
    for name in names:
        value = getattr(part, name)
        require(value > 0 and isfinite(value), name, value, "a finite number above zero")


@dataclass(frozen=True, kw_only=True)
class Elastic:
    """An isotropic elastic material."""

    youngs_modulus: float  # [Pa]
    poisson_ratio: float  # [-] below one half: incompressible elements would lock

    def __post_init__(self):
        require_positive(self, "youngs_modulus")
        require(-1 < self.poisson_ratio < 0.49, "poisson_ratio", self.poisson_ratio, "-1 to 0.49")
