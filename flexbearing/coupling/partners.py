"""What the coupling asks of its partners: plain arrays, inner raceway first, outer second."""

from collections.abc import Iterator
from typing import Protocol, Self, TypeVar

from numpy.typing import NDArray

Compliance = tuple[NDArray | None, NDArray | None]


class PartnerFailed(RuntimeError):
    """A partner could not answer; the message is its own, `ending` says in a word how it ended."""

    def __init__(self, message: str, ending: str = ""):
        super().__init__(message)
        self.ending = ending


class State(Protocol):
    """A state of the bearing."""

    @property
    def forces(self) -> NDArray:
        """Generalised forces (2, Z, M) of the rolling elements on the raceways [N]."""
        ...

    @property
    def loads(self) -> NDArray:
        """Normal loads (2, Z) [N] of the rolling elements on both raceways."""
        ...

    @property
    def deviation(self) -> NDArray | None:
        """Outward raceway deviations (2, Z, M) [m] between which it balances; None: not known."""
        ...

    @property
    def residual(self) -> float:
        """Largest unbalanced force over the load [-]."""
        ...

    @property
    def status(self) -> str:
        """Empty while iterating, "converged", or the word for another end."""
        ...

    def failure(self) -> str:
        """Say how the solve ended and how far it came."""
        ...

    def refined(self) -> Self:
        """The state after another step of Newton's method, where that comes closer to balance."""
        ...


S = TypeVar("S", bound=State)


class Iterating(Protocol[S]):
    """A bearing that iterates between elastic raceways."""

    def iterate(self, compliance: Compliance, start: S, deviation: NDArray | None) -> Iterator[S]:
        """Newton iterates between raceways of compliance (Z, M, Z, M) [m/N] and initial deviation.

        Raises `PartnerFailed`.
        """
        ...


class Bearing(Iterating[S], Protocol[S]):
    """Answers with loads to given raceway deviations, too."""

    def solve(self, start: S | None = None, deviation: NDArray | None = None) -> S:
        """Equilibrium between raceways of given deviations (2, Z, M) [m]; raises `PartnerFailed`."""
        ...

    def force_by_deviation(self, state: S) -> NDArray:
        """About the change of forces by deviations (2 Z M, 2 Z M) [N/m], zero where nothing touches."""
        ...


class LinearRaceway(Protocol):
    """A raceway near some forces F of its rollers: outward deviation w = w_0 + C F and mean translation.

    Deviations are from the ground, the mean translation along (y, z) of the raceway included.
    """

    @property
    def azimuths(self) -> NDArray:
        """Of the rollers (Z) [rad]."""
        ...

    @property
    def absolute(self) -> NDArray:
        """Outward deviation per outward force (Z, M, Z, M), C [m/N]."""
        ...

    @property
    def translation(self) -> NDArray:
        """Mean translation along (y, z) per outward force (2, Z, M) [m/N]."""
        ...

    @property
    def initial_deviation(self) -> NDArray:
        """Outward deviation left when the tangent is followed back to no load (Z, M), w_0 [m]."""
        ...

    @property
    def initial_translation(self) -> NDArray:
        """Mean translation along (y, z) at no load (2) [m]."""
        ...

    @property
    def support_stiffness(self) -> float:
        """Resultant over mean translation under outward forces like the cosine of the azimuth [N/m]."""
        ...

    @property
    def bar_response(self) -> object | None:
        """What the bars carry by the same forces; None without bars."""
        ...


class Raceway(Protocol):
    """One raceway with what carries it: rigid, condensed, in a fit, or solved in full."""

    @property
    def rigid(self) -> bool:
        """Whether it deflects under no force."""
        ...

    @property
    def solved_in_full(self) -> bool:
        """Whether an answer is a solve of a whole solid, so that a tangent costs as much as many answers."""
        ...

    @property
    def azimuths(self) -> NDArray:
        """Of the rollers (Z) [rad]."""
        ...

    def answer(self, outward: NDArray) -> tuple[NDArray, NDArray]:
        """Outward deviations (Z, M) and mean translation (2) [m] under outward forces (Z, M) [N].

        Raises `PartnerFailed`.
        """
        ...

    def linearised(self, outward: NDArray) -> LinearRaceway | None:
        """Itself near outward forces (Z, M) [N], None where it is rigid; raises `PartnerFailed`."""
        ...

    def under(self, azimuths: NDArray) -> "Raceway":
        """The same raceway under rollers at other azimuths (Z) [rad]; raises `PartnerFailed`."""
        ...

    def figures(self) -> dict[str, object]:
        """What the result file says of it; nothing of a rigid one."""
        ...


class LinearStructure(Protocol):
    """Both raceways near some loads."""

    @property
    def compliance(self) -> Compliance:
        """Outward deviation per outward force (Z, M, Z, M) [m/N]; None where a raceway is rigid."""
        ...

    @property
    def initial_deviation(self) -> NDArray | None:
        """Outward deviations (2, Z, M) [m] at no load; None where there are none."""
        ...

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward raceway deviations (2, Z, M) [m] under roller forces (2, Z, M) [N]."""
        ...


class Structure(Protocol):
    """Answers with raceway deviations to roller loads."""

    def answer(self, forces: NDArray) -> tuple[NDArray, Compliance | None]:
        """Outward deviations (2, Z, M) [m] under roller forces (2, Z, M) [N], and the compliance there.

        The compliance is None where it would cost far more than the answer. Raises `PartnerFailed`.
        """
        ...

    def linearised(self, forces: NDArray) -> LinearStructure:
        """Itself near these roller forces (2, Z, M) [N], which `newton` requires; raises `PartnerFailed`."""
        ...
