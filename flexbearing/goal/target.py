"""The life that is wanted, as a multiple of that of the case or as a value."""

from dataclasses import dataclass
from math import inf, isfinite, log, nan

from flexbearing import inputs
from flexbearing.case import BadCase
from flexbearing.outputs import AbsentOutput, UnknownOutput, Value, WrongUnit
from flexbearing.printable import excerpt
from flexbearing.quantities.effects import LIVES
from flexbearing.results import Result

FORMS = '"x2", or a life with its unit, "20000 h"'


@dataclass(frozen=True)
class Target:
    """A life that is wanted of a case."""

    name: str  # of the output
    unit: str  # "h" where the bearing turns
    before: float  # in the case as it is
    wanted: float

    @property
    def text(self) -> str:
        """The output with its unit."""
        return f"{self.name} [{self.unit}]"

    def distance(self, life: float) -> float:
        """Logarithm of a life over the wanted one, negative on the side of the case; NaN of none."""
        if not (life > 0 and isfinite(life)):
            return nan
        longer = log(life / self.wanted)
        return longer if self.wanted >= self.before else -longer


def target(result: Result, life: str) -> Target:
    """Read what is wanted of a result.

    Raises `BadCase` for a text that is no life, or a result without a life.
    """
    names = [name for name in LIVES if _has(result, name)]
    if not names:
        raise BadCase(f"{result.place}: has no life, so there is no goal for one.")
    now = result[names[0]]
    hours = now.to("h") if now.speed is not None else now
    now = hours if isfinite(float(hours)) else now
    before = float(now)
    wanted = _wanted(life, now)
    if not (isfinite(before) and before > 0 and 0 < wanted < inf):
        raise BadCase(f"life {excerpt(life)}: must be above zero and finite, as that of the case: {now}.")
    return Target(names[0], now.unit, before, wanted)


def _has(result: Result, name: str) -> bool:
    try:
        return isfinite(float(result[name]))
    except (AbsentOutput, UnknownOutput):
        return False


def _wanted(life: str, now: Value) -> float:
    """The wanted life in the unit of the present one."""
    text = life.strip()
    number, _, unit = text.removeprefix("x").strip().partition(" ")
    try:
        if text.startswith("x") and not unit:
            return float(now) * inputs.number(number)
        if unit and not text.startswith("x"):
            factor = float(now.to(unit.strip())) / float(now)
            return inputs.number(number) / factor
    except (inputs.BadNumber, WrongUnit) as problem:
        raise BadCase(f"life {excerpt(life)}: {problem}") from None
    raise BadCase(f"life {excerpt(life)}: is no goal; it must be {FORMS}.")
