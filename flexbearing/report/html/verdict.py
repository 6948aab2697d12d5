"""First section: whether the answer can be relied on, and what it is."""

from collections.abc import Iterator
from typing import Any

from flexbearing.outputs import outputs
from flexbearing.quantities.attributes import GRADES
from flexbearing.report.html import (
    against_limits,
    answers,
    combined,
    exactness,
    headline,
    heat,
    inputs,
    lives,
    stiffness,
)
from flexbearing.report.html.document import Block, Cell, Items, Number, Table, Words
from flexbearing.report.html.reader import OUTSIDE, Reader
from flexbearing.report.html.units import NOTHING, printed

ALONE = "stiffness"  # output of the bearing without its supports


def blocks(reader: Reader) -> Iterator[Block]:
    """Whether limits are kept, how the run ended, the life to use, what limits most, how exact it all is."""
    converged = reader.attributes["status"] == "converged"
    if converged and reader.blocks:
        yield from headline.blocks(reader)
    if converged and reader.blocks:
        yield from answers.blocks(reader)
    yield Words((ending(reader.attributes),), "" if converged else "danger")
    dangers = reader.notes(GRADES[0])
    if dangers:
        yield Items("Dangers", dangers, "danger")
    elif not converged:
        yield Words(("The numbers below are those of no solution.",))
    yield from _beyond(reader)
    if reader.attributes["calibrated"]:
        yield Items("Fitted inputs: what they were fitted to is no prediction", inputs.fitted_inputs(reader))
    if reader.blocks:
        yield from lives.blocks(reader)
        yield from against_limits.blocks(reader)
        yield from against_limits.to_do(reader)
        yield _main(reader)
    yield from exactness.blocks(reader)


def ending(attributes: dict[str, Any]) -> str:
    """How the run ended, in a sentence."""
    count, message = attributes["iterations"], attributes["message"]
    ended = f"Not converged ({attributes['status']}): {message or attributes['ending']}: no answer."
    words = f"Converged: {message}." if attributes["status"] == "converged" else ended
    return words + (f" {count} iterations of bearing and rings." if count else "")


def _beyond(reader: Reader) -> Iterator[Block]:
    """How many laws were used outside their range, and the notes on them."""
    notes = reader.notes(OUTSIDE)
    if notes:
        title = f"Outside validity: {len(notes)} note{'s' if len(notes) > 1 else ''}"
        yield Items(title, notes, link=("#limits", "All notes, and what the model leaves out"))
    elif not reader.notes(GRADES[0]):
        yield Words(("No danger was noted, and no law outside its range of validity.",))


def _main(reader: Reader) -> Table:
    """The outputs that a result is known by, with their numerical errors and what inputs make of them."""
    rows = list(_rows(reader))
    spans = [combined.cells(reader, word) if word else () for _, word in rows]
    head = ("quantity", "value", "unit", "numerical error [%]")
    if not any(spans):
        return Table("Main results", head, tuple(cells for cells, _ in rows), name="main")
    shown = tuple(
        (*cells, *(span or (NOTHING,) * len(combined.HEAD)))
        for (cells, _), span in zip(rows, spans, strict=True)
    )
    return Table("Main results", (*head, *combined.HEAD), shown, combined.note(reader), name="main")


def _rows(reader: Reader) -> Iterator[tuple[tuple[Cell, ...], str]]:
    """The life of the case, then main outputs, each with its word in effects of inputs."""
    first, known = next(iter(lives.lives(reader)), None), {each.name: each for each in outputs(reader.layout)}
    if first is not None and first.chosen:
        value = first.hours if isinstance(first.hours, Number) else first.turns
        yield (first.name, value, printed(value.unit), first.error), combined.LIFE
    words = dict(reader.layout.weighed)
    for name in dict.fromkeys((*reader.layout.main, *words)):
        output, block = known[name], reader.blocks[reader.last]
        same = name == ALONE and not stiffness.supported(reader)  # as total_stiffness
        if name != "life_L10" and not same and all(each in block for each in output.declared.of):
            number = reader.scalar(output)
            label = _label(reader, name) or ", ".join([output.declared.label.strip(), *name.split(".")[1:]])
            error = exactness.error(reader, output.declared)
            yield (label, number, printed(number.unit), error), words.get(name, "")


def _label(reader: Reader, name: str) -> str:
    """Words of outputs whose declared label is not enough for this case; empty for others."""
    if dict(reader.layout.weighed).get(name) == answers.SLIP:
        fitted = "lubricant.oil_fraction" in reader.attributes["calibrated"]
        of = "; lubricant.oil_fraction was fitted to one: no prediction" * fitted
        return f"{answers.SLIP} (error in percentage points{of})"
    if name == "driving_torque":
        return f"driving torque ({bound})" if (bound := heat.at_most(reader)) else ""
    if name not in ("total_stiffness", ALONE, "stiffness_zz"):
        return ""
    along = "radial stiffness along z" if name == "stiffness_zz" else "radial stiffness along the load"
    supports = name != ALONE and stiffness.supported(reader)
    return f"{along}, {'with supports' if supports else 'of the bearing alone'}"
