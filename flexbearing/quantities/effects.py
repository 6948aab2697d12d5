"""Effects of assumed inputs, as a result stores them."""

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

INPUT, CHOICE, COMPARISON = "input", "choice", "comparison"  # a comparison is in no combined range
LIVES = ("modified_life", "life_L10")  # the first that a result has is the life that effects are ranked by
_OF_ONE_THING = {"bearing.roller.drop": "bearing.roller.profile"}


def about(key: str) -> str:
    """What a key describes: keys of one thing count once where changes are combined.

    >>> about("bearing.roller.drop"), about("lubricant.oil")
    ('bearing.roller.profile', 'lubricant.oil')
    """
    return _OF_ONE_THING.get(key, key)


@dataclass(frozen=True)
class OtherCase:
    """Outputs of the case with other settings."""

    words: str
    settings: list[str]  # "key=value"
    values: dict[str, float]  # by name of the output; empty without a result
    problem: str  # why there is none


@dataclass(frozen=True)
class KeyEffects:
    """What other values of a key make of the outputs."""

    key: str
    source: str  # of the range of its values
    others: list[OtherCase]
    role: str = INPUT


@dataclass(frozen=True)
class Effects:
    """What other values of all inputs that are not known make of the outputs."""

    of: dict[str, float]  # outputs of the case itself
    keys: list[KeyEffects]
    together: list[OtherCase] = field(default_factory=list)  # that shorten the life at once, and lengthen it

    def stored(self) -> dict[str, Any]:
        """The same as JSON can hold it."""
        return asdict(self)


def effects(stored: Mapping[str, Any]) -> Effects:
    """Effects that `Effects.stored` wrote."""
    keys = [KeyEffects(**{**key, "others": _others(key["others"])}) for key in stored["keys"]]
    return Effects(stored["of"], keys, _others(stored.get("together", ())))


def _others(stored: Iterable[Mapping[str, Any]]) -> list[OtherCase]:
    return [OtherCase(**each) for each in stored]
