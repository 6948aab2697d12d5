"""The report of a result: its sections in their order."""

from collections.abc import Iterator
from itertools import chain

from flexbearing.quantities.attributes import GRADES
from flexbearing.report.html import (
    clearance,
    elements,
    heat,
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
from flexbearing.report.html.figures import convergence
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.simplifications import simplifications
from flexbearing.report.html.units import METRIC, Units
from flexbearing.results import Result


def of_result(result: Result, units: Units = METRIC, further: tuple[Section, ...] = ()) -> Document:
    """Collect the report of a result.

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
        "heat": ("Heat by cause", heat.blocks(reader)),
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
    if left_out := simplifications(reader):
        head = ("left out", "who checks it, with what")
        yield Table("What the model leaves out in this case", head, left_out)
