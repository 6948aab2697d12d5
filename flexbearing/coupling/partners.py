"""What the coupling asks of its partners: plain arrays, inner raceway first, outer second."""

from collections.abc import Iterator
from typing import Protocol, TypeVar, runtime_checkable

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
        """Generalised roller forces (2, Z, M) on the raceways [N]; [..., 0] is the load."""
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


S = TypeVar("S", bound=State)


class Bearing(Protocol[S]):
    """Answers with loads to a given raceway shape, or iterates together with a yielding one."""

    def solve(self, start: S | None = None, deviation: NDArray | None = None) -> S:
        """Equilibrium between raceways of a given shape (2, Z, M) [m]; raises `PartnerFailed`."""
        ...

    def roller_stiffness(self, state: S) -> NDArray:
        """Stiffness of every roller between its raceways (Z) [N/m], about zero where one does not touch."""
        ...

    def iterate(self, compliance: Compliance, start: S, deviation: NDArray | None) -> Iterator[S]:
        """Newton iterates between raceways that yield by (Z, M, Z, M) [m/N] on top of a given deviation.

        Raises `PartnerFailed`.
        """
        ...


class Linear(Protocol):
    """A structure near some loads."""

    @property
    def compliance(self) -> Compliance:
        """Outward deviation per outward force (Z, M, Z, M) [m/N]; None where a raceway is rigid."""
        ...

    @property
    def unloaded(self) -> NDArray | None:
        """Outward deviations (2, Z, M) [m] that are left when the compliance is taken back to no load."""
        ...

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward raceway deviations (2, Z, M) [m] under roller forces (2, Z, M) [N]."""
        ...


class Structure(Protocol):
    """Answers with raceway deviations to roller loads."""

    def deviation(self, forces: NDArray) -> NDArray:
        """Outward raceway deviations (2, Z, M) [m] under roller forces (2, Z, M) [N].

        Raises `PartnerFailed`.
        """
        ...


@runtime_checkable
class Condensed(Structure, Protocol):
    """A structure that also tells how it yields, which `newton` asks for."""

    def linearised(self, forces: NDArray) -> Linear:
        """Itself near these roller forces (2, Z, M) [N]; raises `PartnerFailed`."""
        ...
