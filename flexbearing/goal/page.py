"""Changes towards a life as text."""

from collections.abc import Iterator

from rich.console import RenderableType
from rich.text import Text

from flexbearing.goal.answer import Change, Goal
from flexbearing.report.output import laid_out
from flexbearing.report.sections import right_aligned

DIGITS = 4


def text(goal: Goal) -> str:
    """The page for whoever types its name."""
    return laid_out(sections(goal)).rstrip()


def sections(goal: Goal) -> Iterator[RenderableType]:
    """Levers that reach it, levers that do not, the pair."""
    target = goal.target
    yield Text(goal.title, style="bold")
    yield Text(f"{target.name} {_life(goal, target.before)}; wanted {_life(goal, target.wanted)}\n")
    reaching = [each for each in goal.changes if each.reaches]
    others = [each for each in goal.changes if not each.reaches]
    if reaching:
        yield _table(goal, "one change", reaching)
    if goal.pair:
        yield _table(goal, "two changes", [goal.pair])
    if others:
        yield _table(goal, "cannot, comes to", others)
        yield from (Text(f"  {each.name}: {each.limit}") for each in others if each.limit)
    if goal.weak:
        yield Text(f"  less than 1 %: {', '.join(goal.weak)}")


def _table(goal: Goal, heading: str, changes: list[Change]) -> RenderableType:
    table = right_aligned(heading, "from", "to", "steps", "life, by a run")
    for column in table.columns:
        column.overflow = "fold"
    for change in changes:
        for number, each in enumerate(change.keys):
            ends = (f"{change.steps:.2g}", _life(goal, change.life)) if number == 0 else ("", "")
            table.add_row(*map(Text, (each.key, _short(each.before), _short(each.after), *ends)))
    return table


def _life(goal: Goal, life: float) -> str:
    return f"{life:,.{DIGITS}g} {goal.target.unit}" if life < 10**DIGITS else f"{float(f'{life:.{DIGITS}g}'):,.0f} {goal.target.unit}"


def _short(words: str) -> str:
    """A value with four digits; a choice as it is."""
    number, _, unit = words.partition(" ")
    try:
        return f"{float(number):.{DIGITS}g} {unit}".strip()
    except ValueError:
        return words
