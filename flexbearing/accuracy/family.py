"""What a climb over levels needs to know of a family of rolling elements."""

from collections.abc import Callable, Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from typing import Any, Generic, Protocol, TypeVar

import numpy as np

from flexbearing.accuracy.case_levels import Ladder
from flexbearing.accuracy.ladder import Place
from flexbearing.progress import Report


class Trials(Protocol):
    """Trials of a case, each solved once.

    A trial has `loads` (2, Z) [N] of the rolling elements on both races, and `numbers` whose errors are
    estimated over themselves, by name.
    """

    def __call__(self, place: Place) -> Any:
        """End state at a level of each choice; raises `Unusable` where there is none."""
        ...


T = TypeVar("T", bound=Trials)


@dataclass(frozen=True)
class LevelsOfFamily(Generic[T]):
    """Choices of a family, what is solved at their levels, and how two solutions differ."""

    ladders: Callable[[Any], tuple[Ladder, ...]]
    trials: Callable[[Any, tuple[Ladder, ...], Report], T]
    changes: Callable[[Any, Any], Mapping[str, float]]
    judged: tuple[str, str]  # outputs that the target is of: loads of the rolling elements, life
    begin: Callable[[T, Executor], None] | None = None  # with what takes longest, in other processes


def relative_changes(loads: str, trial: Any, other: Any) -> dict[str, float]:
    """How much two trials differ: loads, by this name, over the largest one, numbers over themselves."""
    with np.errstate(divide="ignore", invalid="ignore"):  # without a load nothing differs
        shares = {loads: np.abs(other.loads - trial.loads).max() / trial.loads.max()}
        shares |= {
            name: abs(np.float64(other.numbers[name]) / value - 1) for name, value in trial.numbers.items()
        }
    return {name: float(share) for name, share in shares.items() if np.isfinite(share)}
