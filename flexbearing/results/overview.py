"""A result in ten lines, for whoever types its name."""

from collections.abc import Iterator, Mapping
from typing import Any

from flexbearing.outputs import wanted
from flexbearing.outputs.names import Block
from flexbearing.quantities.layout import Layout

WIDTH = 100  # characters of a line


def overview(layout: Layout, attributes: Mapping[str, Any], blocks: Mapping[str, Block], place: str) -> str:
    """How a run ended, and its main outputs beside each other for every block."""
    notes = [note["grade"] for note in attributes["notes"]]
    count = f"{len(notes)} notes, {notes.count('danger')} of them dangers" if notes else "no notes"
    lines = [
        f"{attributes['title']}: {attributes['status']}",
        str(attributes["message"]),
        *_table(layout, blocks),
        f"{attributes['iterations']} iterations, {attributes['wall_time_s']:.3g} s, {count}; {place}",
    ]
    return "\n".join(line if len(line) <= WIDTH else f"{line[: WIDTH - 3]}..." for line in lines)


def _table(layout: Layout, blocks: Mapping[str, Block]) -> Iterator[str]:
    """A row for each main output, a column for each block."""
    if not blocks:
        return
    outputs = [wanted(layout, name) for name in layout.main]
    heads = [f"{output.name} [{output.unit}]" for output in outputs]
    width = max(map(len, heads), default=0)
    yield " " * width + "".join(f"{name:>12}" for name in blocks)
    for output, head in zip(outputs, heads, strict=True):
        numbers = (output.output.numbers(block) for block in blocks.values())
        yield f"{head:<{width}}" + "".join(f"{number:12.6g}" for number in map(float, numbers))
