"""The report of a result: its sections in their order."""

from collections.abc import Iterator
from itertools import chain

from flexbearing.quantities.attributes import GRADES
from flexbearing.report.html import (
    clearance,
    elements,
    inputs,
    life,
    lubrication,
    numbers,
    origin,
    others,
    rings,
    stiffness,
    verdict,
)
from flexbearing.report.html.document import Block, Document, Items, Section, Table, Words
from flexbearing.report.html.figures import bars, convergence
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.simplifications import simplifications
from flexbearing.report.html.units import METRIC, Units, printed, with_unit
from flexbearing.results import Result

_FLOODED = (
    "Rolling shear is that of flooded inlets; an inlet with less oil shears less and carries a thinner film. "
    "So with little oil this loss, torque and film are at most what stands here."
)


def of_result(result: Result, units: Units = METRIC, further: tuple[Section, ...] = ()) -> Document:
    """Collect the report of a result.

    Parameters
    ----------
    result : Result
        what a run left behind, of any kind of bearing
    units : Units
        of all numbers but those in texts of the case and in its notes
    further : tuple of Section
        behind the verdict, such as a comparison

    Returns
    -------
    Document

    Raises
    ------
    BadResult
        where the case in the result cannot be read
    """
    reader, shown = Reader(result, units), result.family.report().elements
    sections = {
        "verdict": ("Verdict", verdict.blocks(reader)),
        "computed": ("What was computed", origin.computed(reader)),
        "inputs": ("Inputs", inputs.blocks(reader)),
        "life": ("Life", life.blocks(reader)),
        "stiffness": ("Stiffness", stiffness.blocks(reader)),
        "numbers": (
            "Rigid against flexible" if len(reader.blocks) > 1 else "All numbers",
            numbers.blocks(reader),
        ),
        "others": ("Other states of this case", others.blocks(reader)),
        "elements": (f"{shown.word.capitalize()}s" if shown else "", elements.blocks(reader, shown)),
        "contacts": (
            "Contacts: loads, pressures, films",
            chain(lubrication.blocks(reader) if reader.last else (), elements.contacts(reader, shown)),
        ),
        "heat": ("Heat by cause", _heat(reader)),
        "clearance": ("Clearance", clearance.blocks(reader)),
        "rings": ("Rings: deformation and stresses", rings.blocks(reader)),
        "convergence": ("Convergence", _convergence(reader)),
        "limits": ("Limits of the model that this case touches", _limits(reader)),
        "origin": ("Origin", origin.blocks(reader)),
    }
    first, *rest = [Section(name, title, tuple(blocks)) for name, (title, blocks) in sections.items()]
    complete = (first, *further, *rest)
    title = reader.attributes["title"] or result.stem
    kept = tuple(section for section in complete if section.blocks)
    return Document(f"Bearing report: {title}", origin.line(reader), kept)


def _heat(reader: Reader) -> Iterator[Block]:
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
    note = _FLOODED if "flooding" in {each["code"] for each in reader.attributes["notes"]} else ""
    yield Table("Heat by cause", head, tuple(rows), note)


def _convergence(reader: Reader) -> Iterator[Block]:
    if figure := convergence(reader):
        yield figure
    attempts = reader.attributes.get("attempts") or {}
    rows = [
        (name, str(each["iterations"]), each["status"], each["message"]) for name, each in attempts.items()
    ]
    if rows:
        yield Table(
            "Methods of the coupling, in the order they were tried",
            ("method", "iterations", "status", "message"),
            tuple(rows),
        )
    else:
        yield Words((f"Nothing was iterated between bearing and rings: {reader.attributes['message']}.",))
    choices = reader.attributes.get("choices") or {}
    if choices:
        levels = [(name, choice["level"], "the case" if choice["fixed"] else "accuracy.target")
                  for name, choice in choices.items()]  # fmt: skip
        yield Table("Levels of accuracy", ("choice", "level", "set by"), tuple(levels))


def _limits(reader: Reader) -> Iterator[Block]:
    """Notes by grade."""
    for grade in GRADES:
        notes = reader.notes(grade)
        if notes:
            yield Items(grade.capitalize(), notes, "danger" if grade == GRADES[0] else "")
    if not reader.attributes["notes"]:
        yield Words(("No law was used outside the range of its source, as far as the program checks.",))
    yield Items("What the model leaves out in this case", simplifications(reader))
