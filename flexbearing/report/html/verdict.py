"""First section: whether the answer can be relied on, and what it is."""

from collections.abc import Iterator
from typing import Any

from flexbearing.outputs import outputs
from flexbearing.quantities.attributes import GRADES
from flexbearing.report.html import against_limits, exactness, inputs, lives, stiffness
from flexbearing.report.html.document import Block, Cell, Items, Number, Table, Words
from flexbearing.report.html.reader import OUTSIDE, Reader
from flexbearing.report.html.units import printed
from flexbearing.report.rows import unit_of


def blocks(reader: Reader) -> Iterator[Block]:
    """Whether limits are kept, how the run ended, the life to use, what limits most, how exact it all is."""
    converged = reader.attributes["status"] == "converged"
    if converged and reader.blocks:
        yield from against_limits.summary(reader)
    yield Words((_ending(reader.attributes),), "" if converged else "danger")
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
        yield _main(reader)
    yield from exactness.blocks(reader)


def _ending(attributes: dict[str, Any]) -> str:
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
    """The outputs that a result is known by."""
    known = {output.name: output for output in outputs(reader.layout)}
    rows: list[tuple[Cell, ...]] = []
    for name in reader.layout.main:
        output, block = known[name], reader.blocks[reader.last]
        if all(each in block for each in output.declared.of):
            if name == "life_L10":  # has a table of its own
                continue
            number = _scalar(reader, output)
            words = _label(reader, name) or ", ".join([output.declared.label.strip(), *name.split(".")[1:]])
            rows.append((words, number, printed(number.unit), exactness.error(reader, output.declared)))
    return Table("Main results", ("quantity", "value", "unit", "numerical error [%]"), tuple(rows))


def _label(reader: Reader, name: str) -> str:
    """Words of outputs whose declared label is not enough for this case; empty for others."""
    if reader.of_rollers and "lubricant.oil_fraction" in reader.attributes["calibrated"]:
        from flexbearing.quantities.roller import CAGE_SLIP  # reports of balls load no rollers

        if name == CAGE_SLIP.name:
            return "cage slip (lubricant.oil_fraction was fitted to one: no prediction)"
    if name != "total_stiffness":
        return ""
    along = "radial stiffness along the load"
    return f"{along}, {'with supports' if stiffness.supported(reader) else 'of the bearing alone'}"


def _scalar(reader: Reader, output: Any) -> Number:
    unit = unit_of(output.declared).name
    si = reader.layout[output.declared.of[0]].unit if output.declared.in_si else unit
    asked = f"{reader.last}.{output.name}"
    return reader.units.number(
        float(reader.result[asked].number), si, unit, output.declared.digits or ".4g", f"outputs/{asked}"
    )
