"""The report of a result: findings, tables and figures for the template, which has the words."""

from typing import Any

from flexbearing.case import BadCase
from flexbearing.findings.words import settings
from flexbearing.quantities.attributes import GRADES
from flexbearing.report.drawing.of_case import drawings as drawn
from flexbearing.report.figure import Figure
from flexbearing.report.html import (
    checks,
    effects,
    elements,
    inputs,
    lives,
    origin,
    others,
    rings,
    subjects,
)
from flexbearing.report.html.document import Cell, Document, Drawing, Number, Table
from flexbearing.report.html.figures import around, convergence, deviations, shows_something
from flexbearing.report.html.keys import name
from flexbearing.report.html.reader import Reader
from flexbearing.report.html.units import METRIC, Units, printed, units_in_words
from flexbearing.results import Result

CAVEATS = 3  # on the first page
SIGNED = ("project", "part", "revision", "date", "author", "checker")


def of_result(result: Result, units: Units = METRIC, against: dict[str, Any] | None = None) -> Document:
    """Collect the report of a result; raises `BadResult` where the case in the result cannot be read."""
    reader = Reader(result, units)
    solved = bool(reader.blocks)
    parts = {
        **_of_case(reader),
        **(_of_solution(reader) if solved else {}),
        "against": against,
        "solved": solved,
    }
    title = reader.attributes["title"] or result.stem
    return Document("result.html.j2", title, parts)


def _of_case(reader: Reader) -> dict[str, Any]:
    """What does not need a solution: who signs, inputs, notes, origin."""
    about = reader.attributes
    given = about["case_si"].get("report") or {}
    further, defaults = inputs.tables(reader)
    drawings, not_drawn = _drawings(reader)
    caveats, notes = _notes(reader)
    return {
        "metric": reader.units is METRIC,
        "kind": about["kind"].replace("_", " "),
        "created": about["created"].partition("T")[0],
        "version": about["versions"].get("flexbearing", ""),
        "converged": about["status"] == "converged",
        "ending": origin.ending(reader),
        "signed": [(name, given.get(name) or "") for name in SIGNED],
        "data": inputs.data(reader),
        "inputs": further,
        "defaults": defaults,
        "fitted": inputs.fitted(reader),
        "drawings": drawings,
        "not_drawn": not_drawn,
        "caveats": caveats,
        "notes": notes,
        "counts": [len(about[mark]) for mark in ("assumed", "calibrated")],
        "stale": about.get("effects_left_out") or "",
        "command": origin.command(reader),
        "origin": origin.origin(reader),
        "attempts": origin.attempts(reader),
        "levels": origin.levels(reader),
        "unusable": origin.unusable(reader),
        "overrides": about["case_overrides"],
        "case": about["case_text"],
    }


def _of_solution(reader: Reader) -> dict[str, Any]:
    """Results by subject."""
    shown = reader.result.family.report().elements
    first, further = checks.first_and_further(reader)
    known, bent = reader.effects is not None, deviations(reader)
    loads = elements.figures(reader, shown.figures, shown.azimuth) if shown else []
    return {
        "judged": f"{': '.join(filter(None, checks.judged(reader)))}.",
        "checks": _checked(first),
        "further_checks": _checked(further) if further else None,
        "load": loads[0] if loads else None,
        "motion": loads[1:],
        "contacts": _contacts(reader),
        "elements": elements.table(reader, shown) if shown else None,
        "element": shown.word if shown else "",
        "lives": lives.table(reader),
        "life_rule": reader.attributes.get("life_rule", ""),
        "no_life": lives.why_none(reader),
        "factors": lives.factors(reader, reader.last),
        "stages": lives.stages(reader),
        "effects": effects.figure(reader) if known else None,
        "effects_table": effects.table(reader) if known else None,
        "range": _range(reader),
        "missed_at_low_end": checks.missed_at_low_end(reader),
        "moved": _moved(reader) if known else None,
        "subjects": subjects.tables(reader),
        "regimes": subjects.regimes(reader),
        "torque_parts": subjects.torque_parts(reader),
        "supports": rings.supports(reader),
        "lines": rings.lines(reader),
        "foundation": rings.foundation(reader),
        "carried": rings.carried(reader),
        "solids": rings.solids(reader),
        "matrix": rings.matrix(reader),
        "matrix_units": [printed(unit) for unit in rings.units(reader)],
        "steps": rings.steps(reader),
        "tolerances": rings.tolerances(reader),
        "deformed": bent if bent and shows_something(bent) else None,
        "bars": _bars(reader),
        "stresses": rings.stresses(reader),
        "probes": rings.probes(reader),
        "translations": rings.translations(reader),
        "held": others.held(reader),
        "equilibria": others.equilibria(reader),
        "passage": others.passage(reader),
        "convergence": convergence(reader),
    }


def _checked(found: tuple[checks.Check, ...]) -> Table:
    """Results against their limits; what follows where a limit is not kept is below its name."""
    rows: list[tuple[Cell, ...]] = []
    for check in found:
        action = f"{check.action} ({check.keys})" if check.keys else check.action
        why = "; ".join(filter(None, (check.meaning, action)))
        unit = "" if isinstance(check.value, str) else printed(check.value.unit)
        what = "\n".join(filter(None, (check.what, why)))
        rows.append(
            (
                what,
                check.value,
                unit,
                check.limit,
                units_in_words(check.source),
                checks.used(check),
                check.verdict,
            )
        )
    head = ("result", "value", "unit", "limit", "source", "compared", "verdict")
    return Table(head, tuple(rows))


def _notes(reader: Reader) -> tuple[list[tuple[str, str]], Table]:
    """Notes that no finding is judged by: the gravest for the first page, the others with grades and keys."""
    judged = {record.code for record in reader.findings} | set(checks.NOTED)
    notes = [
        (note["grade"], units_in_words(note["text"]), settings(note.get("keys", {})))
        for grade in GRADES for note in reader.attributes["notes"]
        if note["grade"] == grade and note["code"] not in judged
    ]  # fmt: skip
    unknown = bool(reader.attributes["assumed"] or reader.attributes["calibrated"])
    grave = [note for note in notes if note[0] != GRADES[-1]][: CAVEATS - unknown]
    rows = tuple(note for note in notes if note not in grave)
    return [(text, keys) for _, text, keys in grave], Table(("grade", "note", "keys of the case"), rows)


def _drawings(reader: Reader) -> tuple[list[Drawing], str]:
    """Drawings to scale of the case; where it cannot be read again, why there are none."""
    try:
        sheets = drawn(reader.result.family, reader.case, names=name)
        return [Drawing(sheet.caption, sheet.svg) for sheet in sheets], ""
    except BadCase as problem:
        return [], str(problem).splitlines()[0]


def _range(reader: Reader) -> tuple[Number, Number, str] | None:
    """The life by all inputs that are not known, and the one that moves it most."""
    span, life = effects.span(reader), next((each for each in lives.lives(reader) if each.chosen), None)
    if span is None or life is None:
        return None
    number = life.hours if isinstance(life.hours, Number) else life.turns
    low, high = (lives.rounded(number, times) for times in span.squares)
    return low, high, effects.name(span.most)


def _moved(reader: Reader) -> tuple[str, Number, Number, str] | None:
    """The output that inputs move most where they are not known: from and to which times, and by which."""
    output = effects.most_moved(reader)
    for key, ratios in effects.largest(reader, output, 1):
        return effects.label(reader, output), ratios[0], ratios[-1], effects.name(key)
    return None


def _contacts(reader: Reader) -> list[Figure]:
    shown = reader.result.family.report().elements
    if shown is None:
        return []
    return [*elements.maps(reader, shown), *elements.figures(reader, shown.contact_figures, shown.azimuth)]


def _bars(reader: Reader) -> Figure | None:
    """Axial force of the bars of a squirrel cage."""
    if "bar_azimuth" not in reader.blocks.get("flexible", {}):
        return None
    return around(reader, "axial force of the bars", ("bar_axial_force",), "bar_azimuth")
