"""How exact the numbers are: estimated numerical errors, or that there are none."""

from collections.abc import Iterator

import numpy as np

from flexbearing.quantities import SummaryValue
from flexbearing.report.html import lives
from flexbearing.report.html.document import Block, Cell, Table, Words
from flexbearing.report.html.reader import Reader

NOT_ESTIMATED = "not estimated"
PRESSURE_NOTES = {"pressed-end", "sharp-roller-end", "sliced-peak", "profile-corner"}
_MEANING = (
    "A numerical error says how far a number is from the exact answer of this model, not from a "
    "measurement: which inputs are assumed stands under Inputs, what the model leaves out under Limits."
)
_NO_TARGET = (
    'The case sets no accuracy.target: with accuracy.target = "1 %" slices, shapes and meshes are chosen '
    "by an error, and those of roller loads, cage slip, life and stiffness are estimated."
)
_BALLS = (
    "Contacts of balls follow closed formulas without a grid: loads, angles, pressures and stiffness have no "
    "numerical error but that of the balance. Friction is summed over the contacts: its error is told where "
    "cells of them are refined."
)


def error(reader: Reader, entry: SummaryValue) -> Cell:
    """Estimated error of an output in percent, or that there is none."""
    estimates = reader.attributes.get("error_estimate") or {}
    if estimates.get(entry.error) is not None:
        return reader.of_attribute(f"error_estimate/{entry.error}", "1", "%", ".2g")
    by_friction = any(word in entry.key for word in ("torque", "power", "friction"))
    return "of the balance alone" if _exact(reader) and not by_friction else NOT_ESTIMATED


def _exact(reader: Reader) -> bool:
    """Whether nothing but a balance is iterated: balls on closed formulas between rigid rings."""
    computed = reader.attributes["case_si"].get("friction", {}).get("contact_pressure", "hertz") != "hertz"
    return reader.of_balls and not computed and len(reader.blocks) < 2


def blocks(reader: Reader) -> Iterator[Block]:
    """Errors that are estimated, how the balance ended, what is not estimated."""
    rows = [*_of_target(reader), *_of_single_outputs(reader)]
    rows.append(("balance of forces at the end", reader.attributes["message"], "of the run"))
    yield Table(_caption(reader), ("number", "error [%] or remark", "estimated by"), tuple(rows), _MEANING)
    if _exact(reader):
        yield Words((_BALLS,))
    elif not (reader.attributes.get("error_estimate") or {}) and "accuracy" in reader.attributes["case_si"]:
        yield Words((_NO_TARGET,))


def _of_slices(reader: Reader) -> str:
    """What is known of peak pressures without an estimate."""
    if {note["code"] for note in reader.attributes["notes"]} & PRESSURE_NOTES:
        return "see the notes on peak pressure under Limits"
    if reader.bearing.get("contact") != "slices":
        return ""
    return "slices were within 5 % of whole contacts where, as here, no note on peak pressure is told"


def _caption(reader: Reader) -> str:
    errors = reader.attributes.get("error_estimate")
    if not errors:
        return "Numerical errors"
    met = "is estimated to be kept" if errors["met"] else "was NOT kept"
    return f"Numerical errors; the target of {100 * errors['target']:g} % {met}"


def _of_target(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    """What `accuracy.target` estimates, or that it was not asked for; the life also by finer slices."""
    estimates = reader.attributes.get("error_estimate") or {}
    if not reader.of_rollers:
        return
    words: dict[str, str] = {}  # of the first output that has an error
    for entry in (entry for entry in reader.layout.summary if entry.error):
        points = "" if entry.error_relative else ", percentage points"
        words.setdefault(entry.error, f"{entry.label.strip()}{points}")
    for name in (name for name in words if estimates.get(name) is not None):
        cell = reader.of_attribute(f"error_estimate/{name}", "1", "%", ".2g")
        yield words[name], cell, "neighbouring levels of accuracy"
    if estimates.get("life") is None:
        yield (
            words["life"],
            lives.error(reader, "life_L10"),
            "finer slices and more axial shapes; those of the other lives stand beside them",
        )
    left = [text for name, text in words.items() if name != "life" and estimates.get(name) is None]
    if left:
        yield "; ".join(left), NOT_ESTIMATED, ""


def _of_single_outputs(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    """Errors that outputs have of their own."""
    summary = reader.summary.get(reader.last) or {}
    pressures = summary.get("peak_pressure_error_MPa")
    for race in summary.get("peak_pressure_MPa") or {}:
        what, known = f"peak pressure, {race} raceway", (pressures or {}).get(race)
        if known is not None and np.isfinite(known):
            path = f"percent/{reader.last}/peak_pressure_error_MPa/{race}/peak_pressure_MPa/{race}"
            of = 100 * known / summary["peak_pressure_MPa"][race]
            yield what, reader.units.number(of, "%", "%", ".2g", path), "cells of twice the size"
        elif not _exact(reader):
            yield what, NOT_ESTIMATED, _of_slices(reader)
    if (stress := summary.get("nominal_bar_stress_MPa")) and summary.get("nominal_bar_stress_error_MPa"):
        of = 100 * summary["nominal_bar_stress_error_MPa"] / stress
        path = f"percent/{reader.last}/nominal_bar_stress_error_MPa/nominal_bar_stress_MPa"
        yield "nominal stress of the bars", reader.units.number(of, "%", "%", ".2g", path), "its own mesh"
    torque = summary.get("torque_grid_error_Nm")
    if torque is not None:
        value = reader.units.number(
            torque, "N m", "N m", ".2g", f"summary/{reader.last}/torque_grid_error_Nm"
        )
        yield f"friction torque, in {value.unit.replace(' ', '·')}", value, "fewer cells"
    for part, figures in (reader.attributes.get("structure") or {}).items():
        stiffness = figures.get("support_stiffness_N_per_m")
        known = figures.get("support_stiffness_error_N_per_m")
        if stiffness and known is not None:
            value = reader.units.number(100 * known / stiffness, "%", "%", ".2g", f"support_error/{part}")
            yield f"support stiffness of the {part} ring", value, "the mesh of its part"
