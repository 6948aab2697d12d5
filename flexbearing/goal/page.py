"""Changes towards a life as text."""

from collections.abc import Iterator, Sequence
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.goal.answer import Change, Changed
from flexbearing.goal.target import Target
from flexbearing.printable import excerpt
from flexbearing.report.output import laid_out
from flexbearing.report.sections import right_aligned

DIGITS = 4
LONGEST = 120  # characters of a reason


def text(*goal: Any) -> str:
    """The page for whoever types its name; arguments as of `sections`."""
    return laid_out(sections(*goal)).rstrip()


def sections(
    title: str, target: Target, changes: Sequence[Change], pair: Change | None, weak: Sequence[str]
) -> Iterator[RenderableType]:
    """Changes that reach it, the pair, changes that do not."""
    yield Text(title, style="bold")
    yield Text(f"{target.name} {_life(target.before, target)}; wanted {_life(target.wanted, target)}\n")
    others = [each for each in changes if not each.reaches]
    groups = {
        "one change": [each for each in changes if each.reaches],
        "two changes": [pair] if pair else [],
        "cannot, comes to": others,
    }
    yield from (_table(name, group, target) for name, group in groups.items() if group)
    yield from (Text(f"  {each.name}: {excerpt(each.limit, LONGEST)}") for each in others if each.limit)
    if weak:
        yield Text(f"  less than 1 %: {', '.join(weak)}")


def _table(heading: str, changes: Sequence[Change], target: Target) -> RenderableType:
    table = right_aligned(heading, "from", "to", "steps", "life")
    table.columns[0].overflow = "fold"
    for change in changes:
        for number, each in enumerate(change.keys):
            ends = ("", "") if number else (f"{change.steps:.2g}", _life(change.life, target))
            table.add_row(*map(Text, (each.key, *_words(each), *ends)))
    return table


def _life(life: float, target: Target) -> str:
    rounded = float(f"{life:.{DIGITS}g}")
    return f"{rounded:,.0f} {target.unit}" if rounded >= 10**DIGITS else f"{rounded:g} {target.unit}"


def _words(changed: Changed) -> tuple[str, str]:
    """Both values: numbers with four digits, of choices the last part."""
    both = changed.before, changed.after
    try:
        return _number(both[0]), _number(both[1])
    except ValueError:
        return both[0].rpartition(", ")[2], both[1].rpartition(", ")[2]


def _number(words: str) -> str:
    number, _, unit = words.partition(" ")
    return f"{float(number):.{DIGITS}g} {unit}".strip()
