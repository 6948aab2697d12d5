"""Rolling elements of a bearing, where nothing says how many of what size there are."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

Pair = tuple[int, float]  # number of rolling elements, and their size [m]
APART = 1.15  # of a rating and its formula, as older and other standards have it; assumed


@dataclass(frozen=True)
class Ratings:
    """What the formulas of ISO 281 and ISO 76 give [N]."""

    dynamic: float
    static: float
    fatigue: float


@dataclass(frozen=True, kw_only=True)
class ElementSet:
    """Number and size of the rolling elements, and what else they may be."""

    chosen: Pair  # of the pairs
    pairs: tuple[Pair, ...]  # plausible ones that have the maker's C_0 where it is given, by number
    plausible: tuple[Pair, ...]  # among them those of the least and the greatest ratings
    rated: Callable[[int, float], Ratings]  # ratings by the formulas for a number and a size
    about: str = ""  # what must be known of these ratings


def near(pairs: Sequence[Pair], rated: Callable[[int, float], Ratings], wanted: float) -> list[Pair]:
    """The pair nearest to a static rating [N] that no plausible pair has; none where it is far away."""
    best = min(pairs, key=lambda pair: abs(rated(*pair).static - wanted))
    return [best] if 1 / APART <= wanted / rated(*best).static <= APART else []


def chosen(pairs: list[Pair], rated: bool) -> Pair:
    """Pair of a case: with a maker's C_0 that of most elements, as makers fill bearings; else the middle."""
    return pairs[-1] if rated else pairs[(len(pairs) - 1) // 2]


def span(few: int, many: int) -> str:
    """Write a range of numbers."""
    return f"{few} to {many}" if few < many else f"{few}"
