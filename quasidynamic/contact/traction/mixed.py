"""Mixed lubrication: film and asperities share the load."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from quasidynamic.columns import stacked
from quasidynamic.contact.traction.asperity_friction import AsperityFriction
from quasidynamic.contact.traction.traction_law import Traction, TractionLaw
from quasidynamic.errors import require_positive


class AsperityShare(Protocol):
    """Maps the film ratio Lambda > 0 to the share of the load on asperities, one at zero film."""

    def __call__(self, film_ratio: NDArray) -> tuple[NDArray, NDArray]:
        """Share [-] and its derivative by the film ratio [-], <= 0."""
        ...


@dataclass(frozen=True, kw_only=True)
class StretchedExponential:
    r"""Share that decays as a stretched exponential.

    .. math:: f_a = e^{-B \Lambda^C}

    Source
    ------
    Zhou and Hoeprich (1991) for tapered rollers; constants see `ZHOU_HOEPRICH` and `FILM_SHARE_1_8`.

    Valid
    -----
    Film ratio above zero: with C < 1 the slope has no limit at zero film.
    """

    rate: float  # [-] B
    power: float  # [-] C

    def __post_init__(self):
        for name in ("rate", "power"):
            require_positive(f"asperity share: {name}", getattr(self, name))

    def __call__(self, film_ratio: NDArray) -> tuple[NDArray, NDArray]:
        """Share and its derivative."""
        exponent = self.rate * film_ratio**self.power
        share = np.exp(-exponent)
        return share, -self.power * exponent / film_ratio * share


ZHOU_HOEPRICH = StretchedExponential(rate=2.32, power=0.97)  # raceway of a 32216 bearing
FILM_SHARE_1_8 = StretchedExponential(rate=1.8, power=1.2)  # film share 1 - exp(-1.8 Lambda^1.2)


@dataclass(frozen=True)
class ErrorFunctionShare:
    r"""Share of a Gaussian height beyond the film.

    .. math:: f_a = 1 - \operatorname{erf}\Lambda

    Source
    ------
    Arana, Larranaga and Ulacia (2019).
    """

    def __call__(self, film_ratio: NDArray) -> tuple[NDArray, NDArray]:
        """Share and its derivative."""
        from scipy.special import erfc  # costly to import, and few cases take this share

        return erfc(film_ratio), -2 / np.sqrt(np.pi) * np.exp(-(film_ratio**2))


@dataclass(frozen=True, kw_only=True)
class Mixed:
    r"""Film and asperities share the load, each with its own friction.

    .. math:: F = (1 - f_a(\Lambda))\, F_f + F_a(f_a),\quad \Lambda = h/\sigma

    F_f is the traction of the wrapped law under the whole load, so that its coefficient keeps its
    value; F_a is that of the asperities under their share, see `RoundedCoulomb` and `Carter`.

    Source
    ------
    Load sharing of Johnson, Greenwood and Poon (1972), as used for rollers by Zhou and Hoeprich (1991).

    Valid
    -----
    Film > 0; asperities do not change the film. Kinks are those of the wrapped law and of the asperities'.
    """

    fluid: TractionLaw
    share: AsperityShare
    asperities: AsperityFriction
    roughness: NDArray | float  # [m] sigma, composite: sqrt(Rq1^2 + Rq2^2)

    def __post_init__(self):
        for value in np.ravel(self.roughness).tolist():
            require_positive("mixed.roughness", value)

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the film acts through the wrapped law and the share."""
        fluid = self.fluid(line_load, sliding, entrainment, film)
        share, by_ratio = self.share(film / self.roughness)
        asperities = self.asperities(line_load, sliding, entrainment, share)
        film_share = 1 - share
        return Traction(
            force=film_share * fluid.force + asperities.force,
            by_load=film_share * fluid.by_load + asperities.by_load,
            by_sliding=film_share * fluid.by_sliding + asperities.by_sliding,
            by_entrainment=film_share * fluid.by_entrainment + asperities.by_entrainment,
            by_film=film_share * fluid.by_film
            + by_ratio / self.roughness * (asperities.by_share - fluid.force),
        )


@dataclass(frozen=True, kw_only=True)
class RoughContacts:
    """`Mixed` for the contacts of a bearing, whose raceways are not equally rough."""

    fluid: Callable[..., TractionLaw]  # called with radius, modulus, length, oil
    share: AsperityShare
    asperities: Callable[..., AsperityFriction]  # called with radius and modulus
    inner_roughness: float  # [m] composite, see `Mixed`
    outer_roughness: float  # [m]

    def __call__(self, *, radius: Any, modulus: Any, **contact: Any) -> Mixed:
        """Law of both contacts, from radius, modulus, length and oil."""
        return Mixed(
            fluid=self.fluid(radius=radius, modulus=modulus, **contact),
            share=self.share,
            asperities=self.asperities(radius=radius, modulus=modulus),
            roughness=stacked(self.inner_roughness, self.outer_roughness),
        )
