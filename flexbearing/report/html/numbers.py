"""Every declared number of the end states, side by side."""

import re
from collections.abc import Iterator
from typing import Any

from flexbearing.quantities import SummaryValue
from flexbearing.report.html.document import Block, Cell, Table, Words
from flexbearing.report.html.reader import Reader, places
from flexbearing.report.html.units import NOTHING, printed

_AXES = re.compile(r"( about)? [xyz](, [xyz])+$")  # that a label lists, where every number names its own
ALONE = "No part is flexible: bearing and result are those between rigid raceways."


def blocks(reader: Reader) -> Iterator[Block]:
    """A row for each number of the summary: every end state, estimated error, change."""
    if not reader.blocks:
        return
    errors = reader.attributes.get("error_estimate") or {}
    compared = len(reader.blocks) > 1
    head = ["quantity", *reader.blocks, "unit"]
    head += ["error [%]"] if errors else []
    head += ["rigid to flexible [%]"] if compared else []
    entries = [entry for entry in reader.layout.summary if entry.label]
    rows = [row for entry in entries for row in _rows(reader, entry, errors, compared)]
    if not compared:
        yield Words((ALONE,))
    yield Table("All numbers", tuple(head), tuple(rows))


def _rows(
    reader: Reader, entry: SummaryValue, errors: dict[str, Any], compared: bool
) -> Iterator[tuple[Cell, ...]]:
    """A row for each number of an entry; none where no end state has it."""
    for words, steps in places(entry):
        numbers = [reader.declared(entry, block, *steps) for block in reader.blocks]
        if all(number.text == NOTHING for number in numbers):
            continue
        label = f"{_AXES.sub('', entry.label)}, {words.replace('_', ' ')}" if words else entry.label
        row: list[Cell] = [label, *numbers, printed(numbers[-1].unit)]
        if errors:
            known = errors.get(entry.error) is not None
            row.append(reader.of_attribute(f"error_estimate/{entry.error}", "1", "%", ".2g") if known else "")
        if compared:
            row.append(reader.change(numbers[0].of, numbers[-1].of) if entry.compared else "")
        yield tuple(row)
