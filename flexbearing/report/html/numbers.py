"""Every declared number of the end states, side by side."""

import re
from collections.abc import Iterator

from flexbearing.quantities import SummaryValue
from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.report.html import exactness, heat
from flexbearing.report.html.document import Block, Cell, Table, Words
from flexbearing.report.html.reader import Reader, places
from flexbearing.report.html.units import NOTHING, printed
from flexbearing.report.rows import of_supports

_AXES = re.compile(r"( about)? [xyz](, [xyz])+$")  # that a label lists, where every number names its own
_DEFINED = {  # rows whose label does not tell of what, from where and in which sense
    "Ring displacement": "ring_displacement",
    "Stiffness of the bearing": "stiffness",
    "Stiffness with supports": "total_stiffness",
    "Cage slip": CAGE_SLIP.name,
    "Raceway deviation, inner": "inner_deviation",
    "Raceway deviation, outer": "outer_deviation",
    "Stiffness of outer support / of bearing": "support_stiffness_ratio",
}
_LARGER = (
    "Raceway deviation at mid-roller and at roller ends: the larger of both raceways; the figure under Rings "
    "says of which one, and where."
)
ALONE = "No part is flexible: bearing and result are those between rigid raceways."


def blocks(reader: Reader) -> Iterator[Block]:
    """A row for each number of the summary: every end state, estimated error, change."""
    if not reader.blocks:
        return
    errors = any(reader.error_path(entry.error) for entry in reader.layout.summary)
    compared = len(reader.blocks) > 1
    head = ["quantity", *reader.blocks, "unit"]
    head += ["error [%]"] if errors else []
    head += ["rigid to flexible [%]"] if compared else []
    declared = [entry for entry in reader.layout.summary if entry.label]
    entries = [entry for entry in declared if compared or not of_supports(entry)]
    rows = [row for entry in entries for row in _rows(reader, entry, errors, compared)]
    if not compared:
        yield Words((ALONE,))
    meanings = [
        f"{label}: {reader.layout[name].meaning}." for label, name in _DEFINED.items() if _has(reader, name)
    ]
    if compared and _has(reader, "outer_deviation"):
        meanings.append(_LARGER)
    if bound := heat.at_most(reader):
        meanings.append(f"Driving torque and power: {bound}.")
    yield Table("All numbers", tuple(head), tuple(rows), " ".join(meanings))


def _has(reader: Reader, name: str) -> bool:
    return reader.of_rollers and name in reader.blocks[reader.last]


def _rows(reader: Reader, entry: SummaryValue, errors: bool, compared: bool) -> Iterator[tuple[Cell, ...]]:
    """A row for each number of an entry; none where no end state has it."""
    for words, steps in places(entry):
        numbers = [reader.declared(entry, block, *steps) for block in reader.blocks]
        if all(number.text == NOTHING for number in numbers):
            continue
        shown: list[Cell] = [
            NOTHING if compared and of_supports(entry) and block == "rigid" else number
            for block, number in zip(reader.blocks, numbers, strict=True)
        ]
        label = reader.label(entry)
        label = f"{_AXES.sub('', label)}, {words.replace('_', ' ')}" if words else label
        row: list[Cell] = [label, *shown, printed(numbers[-1].unit)]
        if errors:
            row.append(exactness.known(reader, entry) or "")
        if compared:
            both = entry.compared and NOTHING not in shown
            row.append(reader.change(numbers[0].of, numbers[-1].of) if both else "")
        yield tuple(row)
