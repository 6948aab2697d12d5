"""Sensitivities as text."""

from collections.abc import Iterator, Sequence
from math import isnan

from rich.console import RenderableType
from rich.text import Text

from flexbearing.derivatives.table import Chosen, Sensitivities, Slope
from flexbearing.report.sections import listed, right_aligned

MOST = 12  # keys of an output


def sections(found: Sensitivities) -> Iterator[RenderableType]:
    """A table of the keys for every output, by what a realistic step of each changes."""
    yield Text(f"{found.title}, {found.raceways}", style="bold")
    for output in found.outputs:
        unit = "" if output.unit == "1" else f" {output.unit}"
        yield Text(f"\n{output.name} = {output.value:.6g}{unit}")
        slopes = found.by_output[output.name]
        if not slopes:
            yield Text("  no key reaches it")
            continue
        yield _table(slopes[:MOST], output.unit)
        if len(slopes) > MOST:
            yield Text(f"  and {len(slopes) - MOST} weaker keys, which the table in the file has")
    yield Text("\nchange: of the output by one step of the key, by the derivative; of a choice as solved.")
    if any(_one_sided(each) for changes in found.by_output.values() for each in changes):
        yield Text(
            "One-sided, with the derivative below and above: a contact opens or closes within 0.01 % of the "
            "key, a maximum changes its place, or the key ends there."
        )
    yield from listed("keys without derivatives", [f"{key}: {why}" for key, why in found.left_out])


def _table(changes: Sequence[Slope | Chosen], unit: str) -> RenderableType:
    sided = any(map(_one_sided, changes))
    table = right_aligned("key", "step", "change", "derivative", *(("below", "above") if sided else ()))
    for column in table.columns:
        column.no_wrap, column.overflow = not (sided or column is table.columns[0]), "fold"
    for each in changes:
        change = f"{each.change:+.3g} {unit}" if isnan(each.percent) else f"{each.percent:+.3g} %"
        if isinstance(each, Chosen):
            row = each.key, each.words.rpartition(", ")[2], change
        else:
            step = f"{each.key.realistic_step:.4g} {each.key.unit}".strip()
            sides = (_number(each.below), _number(each.above)) if sided else ()
            row = each.key.path, step, change, _derivative(each, unit), *sides
        table.add_row(*map(Text, row))
    return table


def _one_sided(change: Slope | Chosen) -> bool:
    return isinstance(change, Slope) and change.one_sided


def _derivative(slope: Slope, unit: str) -> str:
    key = f"({slope.key.unit})" if {" ", "/"} & set(slope.key.unit) else slope.key.unit
    per = f"{unit}/{key}" if key else "" if unit == "1" else unit
    return f"{_number(slope.slope)} {per}".rstrip()


def _number(number: float) -> str:
    return "-" if isnan(number) else f"{number:+.4g}"
