"""The lives of a state, with every factor that modifies them."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import prod
from typing import Any

from numpy.typing import NDArray

from flexbearing.findings.running import NO_MODIFIED_LIFE
from flexbearing.quantities.life_records import BY_LOADS, Factor
from quasidynamic import OutOfRange
from quasidynamic.note import Note, information, outside
from quasidynamic.outcome.life_factors import (
    LEAST_VISCOSITY_RATIO,
    LifeFactor,
    ModifiedLife,
    reliability_factor,
)

MREV = 1e6  # revolutions
CAPACITY, EDGE_STRESS = "capacity", "edge stress"  # factors between the basic and the reference life


@dataclass(frozen=True)
class LifeOfState:
    """The life at one state of the bearing, from the basic one over every factor."""

    basic: float  # [10^6 revolutions]
    factors: tuple[Factor, ...]
    modified: float | None  # [revolutions]; None where a factor does not hold

    @property
    def reference(self) -> float | None:
        """Reference life by ISO/TS 16281 [rev], without rollers that fail; None by other capacities."""
        loads = {factor.name: factor.value for factor in self.factors if factor.effect == BY_LOADS}
        if CAPACITY not in loads:
            return None
        return self.basic * MREV * float(loads[CAPACITY]) * float(loads.get(EDGE_STRESS, 1.0))

    @classmethod
    def of(cls, basic: float, by_loads: Sequence[Factor], factors: Sequence[LifeFactor]) -> "LifeOfState":
        """The life after what changes its loads or capacities, then after factors of different effects."""
        rated = basic * prod(float(factor.value) for factor in by_loads)
        life = ModifiedLife(basic=rated, factors=tuple(factors))
        further = (Factor(**{**vars(factor), "value": float(factor.value)}) for factor in life.factors)
        return cls(basic, (*by_loads, *further), float(life.life) * MREV)

    def record(self) -> dict[str, Any]:
        """The same as JSON can hold it, lives in 10^6 revolutions."""
        return {
            "basic_Mrev": self.basic,
            "factors": [*map(vars, self.factors)],
        } | ({} if self.modified is None else {"modified_Mrev": self.modified / MREV})


def explained(factor: LifeFactor, words: str) -> LifeFactor:
    """A factor with more to say of it."""
    return replace(factor, note="; ".join(filter(None, (factor.note, words))))


def why_none(law: Callable[[], object]) -> str:
    """Why a law has no value; empty where it has one."""
    try:
        law()
    except OutOfRange as why:
        return str(why)
    return ""


def no_life(unrated: str, unmodified: str, kappa: float | None) -> tuple[Note, ...]:
    """Why a life is left out; a viscosity ratio that is too small is a finding of its own."""
    if not unmodified:
        return (information("no-life", f"no rating life: {unrated}"),) if unrated else ()
    if kappa is not None and kappa < LEAST_VISCOSITY_RATIO:
        return ()
    return (outside(NO_MODIFIED_LIFE, f"no modified life: {unmodified}"),)


@dataclass(frozen=True)
class ReferenceLives:
    """Lives at one state of the bearing [rev]."""

    basic: float  # L10r
    raceways: NDArray  # (2) of the inner and the outer raceway on their own
    of_state: LifeOfState | None  # after every factor; None where there is none, or one does not hold

    @property
    def modified(self) -> float | None:
        """Life after every factor [rev]."""
        return None if self.of_state is None else self.of_state.modified


def of_reliability(reliability: float | None) -> list[LifeFactor]:
    """The factor of the reliability that a case requires; none where it requires none."""
    if reliability is None:
        return []
    return [explained(reliability_factor(reliability), f"reliability {reliability:g}")]
