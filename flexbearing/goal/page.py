"""Changes towards a life as text."""

from collections.abc import Iterator

from rich.console import RenderableType
from rich.text import Text

from flexbearing.case.excerpt import excerpt
from flexbearing.goal.answer import Change, Changed, Goal
from flexbearing.report.output import laid_out
from flexbearing.report.sections import right_aligned

DIGITS = 4
LONGEST = 120  # characters of a reason


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
        yield from (Text(f"  {each.name}: {excerpt(each.limit, LONGEST)}") for each in others if each.limit)
    if goal.weak:
        yield Text(f"  less than 1 %: {', '.join(goal.weak)}")


def _table(goal: Goal, heading: str, changes: list[Change]) -> RenderableType:
    table = right_aligned(heading, "from", "to", "steps", "life")
    table.columns[0].overflow = "fold"
    for change in changes:
        for number, each in enumerate(change.keys):
            ends = (f"{change.steps:.2g}", _life(goal, change.life)) if number == 0 else ("", "")
            table.add_row(*map(Text, (each.key, *_words(each), *ends)))
    return table


def _life(goal: Goal, life: float) -> str:
    rounded = float(f"{life:.{DIGITS}g}")
    return f"{rounded:,.0f} {goal.target.unit}" if rounded >= 10**DIGITS else f"{rounded:g} {goal.target.unit}"


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
