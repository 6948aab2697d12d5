"""The summary of a result as text: the tables of its report, each below a title, and lists of sentences."""

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.findings.words import of_note
from flexbearing.quantities.attributes import GRADES
from flexbearing.quantities.roller import CONTACT, RIBS, SKEW
from flexbearing.report.catalogue_life import against_catalogue
from flexbearing.report.html import lives, origin, others, rings, subjects
from flexbearing.report.html.document import Number, Table
from flexbearing.report.html.reader import Reader
from flexbearing.report.sections import listed, noted, titled

AXES = ("x", "y", "z", "about y", "about z")
_TILTS = {"fixed": "its tilt is held", "free": "free to tilt"}


def page(reader: Reader) -> Iterator[RenderableType]:
    """Every section of a result: dangers, numbers, matrices, clearance, life, notes."""
    numbers = reader.summary
    yield from _opening(numbers)
    for title, table in _tables(reader):
        yield from titled(title, table)
    yield from solids(reader)
    yield from listed("levels not computed", origin.unusable(reader))
    yield from _in_operation(numbers.get("clearance") or {})
    yield from against_catalogue(numbers.get("catalogue_life"))
    yield from _closing(numbers)


def _opening(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Dangers, each in a line of its own, then the title and how the inner ring is held."""
    for note in numbers["notes"]:
        if note["grade"] == GRADES[0]:
            yield Text(f"DANGER: {of_note(note)}", style="bold red")
    yield Text(numbers["title"], style="bold")
    if held := numbers.get("tilt"):
        choice = held["inner_ring"]
        yield Text(f'inner ring: {_TILTS.get(choice, "")} (operation.tilt = "{choice}")\n')


def _tables(reader: Reader) -> Iterator[tuple[str, Table | None]]:
    """Tables with their titles."""
    formula = reader.summary.get(reader.last, {}).get("torque_formula")
    yield "", subjects.numbers(reader, "", "compared")
    yield "", subjects.numbers(reader, "ring")
    yield "inner ring held the other way, estimated", others.held(reader)
    yield f"torque in parts; that of the bearing by the {formula} formula", subjects.torque_parts(reader)
    yield "most pressed contacts, with stresses below the surface", subjects.numbers(reader, CONTACT)
    yield "rollers passing a pitch", others.passage(reader)
    yield origin.accuracy(reader), origin.levels(reader)
    yield "tangent stiffness [N, m, rad]", _matrix(reader, "stiffness_matrix_SI")
    yield "tangent compliance [m, rad, N]; infinite along x", _matrix(reader, "compliance_matrix_SI")
    yield "several equilibria", others.equilibria(reader)
    yield "lubrication regime, at the smallest film ratio", subjects.regimes(reader)
    yield "lines that hold the outer ring", rings.lines(reader)
    yield "foundation of the outer ring", rings.foundation(reader)
    yield "radial forces on the outer ring", rings.carried(reader)
    yield "thrust on the ribs", subjects.numbers(reader, RIBS)
    skewed = subjects.numbers(reader, SKEW)
    yield "roller skew between guide flanges; without effect on loads and speeds", skewed
    yield "operating clearance, diametral, step by step", rings.steps(reader)
    yield "tolerances, diametral", rings.tolerances(reader)
    for block in reader.attributes.get("life") or {}:
        yield f"modified life, {block}", lives.factors(reader, block)
    yield "probes: strains and outward displacement", rings.probes(reader)


def solids(reader: Reader) -> Iterator[RenderableType]:
    """Largest stresses of each body, and the stiffness of what holds the rings."""
    yield from titled("largest stresses away from contacts and sharp edges", rings.stresses(reader))
    yield from titled("loads of the solids, and stiffness of the supports alone", rings.solids(reader))
    yield from titled("radial stiffness of the supports alone", rings.supports(reader))


def _matrix(reader: Reader, name: str) -> Table | None:
    """Stiffness or compliance of the last end state in SI units."""
    rows = (reader.summary.get(reader.last) or {}).get(name)
    if rows is None:
        return None
    texts = [["-" if value is None else f"{value:.3e}" for value in row] for row in rows]
    place = f"summary/{reader.last}/{name}"
    cells = ((Number(text, "", f"{place}/{row}/{column}", "") for column, text in enumerate(line))
             for row, line in enumerate(texts))  # fmt: skip
    return Table(("", *AXES), tuple((axis, *row) for axis, row in zip(AXES, cells, strict=True)))


def _in_operation(clearance: dict[str, Any]) -> Iterator[RenderableType]:
    """The clearance in words, and both fits; nothing when the case states it, or the run did not end."""
    if clearance.get("steps"):
        fits = [f"{seat}: {clearance[f'{seat}_fit']}" for seat in ("shaft", "housing")]
        yield from listed("in operation", [clearance["verdict"], *fits])


def _closing(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Assumed and calibrated keys, rules, notes that are no dangers, and in a line how the run ended."""
    yield from listed("assumed (not known, chosen)", numbers["assumed"])
    fitted = [f"{key}: {to}" for key, to in numbers["calibrated"].items()]
    yield from listed("fitted, so no validation", fitted)
    yield from listed("rules of the lives", filter(None, [numbers.get("life_rule")]))
    yield from noted(note for note in numbers["notes"] if note["grade"] != GRADES[0])
    converged = numbers["status"] == "converged"
    yield Text(_ending(numbers), style="bold green" if converged else "bold red")


def _ending(numbers: dict[str, Any]) -> str:
    """Say in a line how a run ended."""
    count, seconds = numbers["iterations"], f"{numbers['wall_time_s']:.1f} s"
    iterations = "1 iteration" if count == 1 else f"{count} iterations"
    if numbers["status"] == "unfinished":
        return f"unfinished, {iterations} so far: {numbers['message']}"
    if numbers["status"] != "converged":
        message = f": {numbers['message']}" if numbers["message"] else ""
        how = f" ({numbers['ending']})" if numbers["status"] == "not solved" and numbers["ending"] else ""
        return f"NOT CONVERGED: {numbers['status']}{how} after {iterations}, {seconds}{message}"
    if count:
        return f"converged in {iterations}, {seconds}"
    return f"converged: {numbers['message']}, {seconds}"
