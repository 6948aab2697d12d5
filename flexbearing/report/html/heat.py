"""Power lost by cause, and whether it is an upper bound."""

from collections.abc import Iterator

from flexbearing.report.html.document import Block, Table
from flexbearing.report.html.figures import bars
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import printed, with_unit

_FLOODED = (
    "Rolling friction of the oil film is hydrodynamic, by the shear of the oil in flooded inlets; an inlet "
    "with less oil shears less and carries a thinner film. So with little oil this loss, torque and film are "
    "at most what is given here."
)


def blocks(reader: Reader) -> Iterator[Block]:
    """Losses by cause."""
    causes = [name for name in reader.layout.datasets("block") if name.startswith("loss_")]
    if not (reader.last and causes):
        return
    unit = reader.units.of("W")
    known = {entry.of[0]: entry.label.strip() for entry in reader.layout.summary if len(entry.of) == 1}
    labels = {name: known.get(name) or name.removeprefix("loss_") for name in causes}
    series = {
        block: {labels[name]: reader.units.value(float(values[name]), "W", "W") for name in causes}
        for block, values in reader.blocks.items()
    }
    yield bars("heat", "Power lost by cause.", with_unit("power", unit), series)
    rows = []
    for name in causes:
        each = (reader.element(block, name, digits=",.2f") for block in reader.blocks)
        rows.append((labels[name], *each, reader.layout[name].meaning))
    powers = (reader.element(block, "driving_power", digits=",.2f") for block in reader.blocks)
    rows.append(("total: driving power", *powers, reader.layout["driving_power"].meaning))
    head = ("cause", *(f"{block} [{printed(unit)}]" for block in reader.blocks), "meaning")
    note = _FLOODED if flooded(reader) else ""
    yield Table("Heat by cause", head, tuple(rows), note)


def flooded(reader: Reader) -> bool:
    """Whether inlets are computed as fully flooded though the case has little oil."""
    return "flooding" in {note["code"] for note in reader.attributes["notes"]}


def at_most(reader: Reader) -> str:
    """That power and torque are upper bounds, with the share of one cause; empty where they are none."""
    block = reader.blocks.get(reader.last, {})
    power = float(block.get("driving_power", 0.0))
    if not flooded(reader) or not power:
        return ""
    share = float(block["loss_rolling"]) / power
    return f"upper bound: {share:.0%} is rolling friction of the oil film in fully flooded inlets"
