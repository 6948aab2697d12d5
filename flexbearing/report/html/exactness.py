"""How exact the numbers are: estimated numerical errors, or that there are none."""

from collections.abc import Iterator

import numpy as np

from flexbearing.quantities import SummaryValue
from flexbearing.report.html import lives
from flexbearing.report.html.document import Block, Cell, Number, Table, Words
from flexbearing.report.html.reader import Reader

NOT_ESTIMATED = "not estimated"
TORQUE, _RESIDUAL = "driving_torque", "loss_transport"
_BARS = "nominal_bar_stress_MPa"
PRESSURE_NOTES = {"pressed-end", "sharp-roller-end", "sliced-peak", "profile-corner"}
_MEANING = (
    "A numerical error says how far a number is from the exact answer of this model, not from a "
    "measurement: which inputs are assumed stands under Inputs, what the model leaves out under Limits."
)
_SLICES = (
    "By finer slices: this case was solved again from its solution with {} and {} slices along a roller; the "
    "error is 1.6 times the largest change."
)
_NOT_IN_IT = (
    "Not in the errors by slices alone: the meshes of the elastic rings, and the axial shapes (Legendre "
    "shapes in which rollers load the rings)."
)
_MEASURED = (
    "Measured at the meshes of two cases with elastic rings (the squirrel cage of Mao, Wang and Zhang, and a "
    "planet wheel), both together changed roller loads by at most 0.08 %, the cage slip by 0.04 % of itself, "
    "and the stiffness with supports by 0.3 %; on other rings and meshes that is a guide, no estimate."
)
_NO_TARGET = (
    'The case sets no accuracy.target: with accuracy.target = "1 %" slices, shapes and meshes are chosen by '
    "an error, and all of them are counted in the errors of roller loads, cage slip, life and stiffness:"
)
_BALLS = (
    "Contacts of balls follow closed formulas without a grid: loads, angles, pressures and stiffness have no "
    "numerical error but that of the balance. Friction is summed over the contacts: its error is given where "
    "cells of them are refined."
)


def error(reader: Reader, entry: SummaryValue) -> Cell:
    """Estimated error of an output in percent, or that there is none."""
    if estimate := known(reader, entry):
        return estimate
    by_friction = any(word in entry.key for word in ("torque", "power", "friction"))
    return "of the balance alone" if _exact(reader) and not by_friction else NOT_ESTIMATED


def known(reader: Reader, entry: SummaryValue) -> Number | None:
    """Estimated error of an output in percent; None where it was not estimated."""
    if entry.error == "total_stiffness" and (whole := with_supports(reader)):
        return whole
    if entry.error == TORQUE and (whole := of_torque(reader)):
        return whole
    if entry.key == _BARS:
        return _of_bars(reader)
    path = reader.error_path(entry.error)
    return reader.of_attribute(path, "1", "%", ".2g") if path else None


def of_torque(reader: Reader) -> Number | None:
    """Error [%] of the driving torque by its grid and by power that no cause explains; None: not known."""
    path, block = reader.error_path(TORQUE), reader.blocks.get(reader.last, {})
    if not path or _RESIDUAL not in block or not float(block["driving_power"]):
        return None
    error = float(reader.attributes[path.partition("/")[0]][TORQUE])
    error += abs(float(block[_RESIDUAL]) / float(block["driving_power"]))
    return reader.units.number(100 * error, "%", "%", ".2g", f"torque_error/{reader.last}/{path}")


def _of_bars(reader: Reader) -> Number | None:
    """Error [%] of the nominal stress of the bars by its own mesh; None: not known."""
    summary = reader.summary.get(reader.last) or {}
    stress, error = summary.get(_BARS), summary.get("nominal_bar_stress_error_MPa")
    if not stress or not error:
        return None
    path = f"percent/{reader.last}/nominal_bar_stress_error_MPa/{_BARS}"
    return reader.units.number(100 * error / stress, "%", "%", ".2g", path)


def with_supports(reader: Reader) -> Number | None:
    """Error [%] of the stiffness with supports by slices and by the meshes of the supports; None: not known.

    The error of a support counts by its share of the compliance.
    """
    path = reader.error_path("total_stiffness")
    if not path.startswith("slice_error") or len(reader.blocks) < 2:
        return None
    whole = reader.summary[reader.last]["total_stiffness_N_per_m"]
    error = reader.attributes["slice_error"]["total_stiffness"]
    for figures in (reader.attributes.get("structure") or {}).values():
        stiffness, known = (figures.get(f"support_stiffness{end}_N_per_m") for end in ("", "_error"))
        if stiffness and known is not None:
            error += known / stiffness * whole / stiffness
    return reader.units.number(100 * error, "%", "%", ".2g", f"with_supports_error/{reader.last}")


def _exact(reader: Reader) -> bool:
    """Whether nothing but a balance is iterated: balls on closed formulas between rigid rings."""
    computed = reader.attributes["case_si"].get("friction", {}).get("contact_pressure", "hertz") != "hertz"
    return reader.of_balls and not computed and len(reader.blocks) < 2


def blocks(reader: Reader) -> Iterator[Block]:
    """Errors that are estimated, how the balance ended, what is not estimated."""
    found = [*_of_target(reader), *_of_single_outputs(reader)]
    found.append(("balance of forces at the end", reader.attributes["message"], "the run"))
    head = ("number", "error [%]", "estimated by")
    yield Table(_caption(reader), head, tuple(map(_in_columns, found)), _MEANING, name="errors")
    if _exact(reader):
        yield Words((_BALLS,))
    elif not (reader.attributes.get("error_estimate") or {}) and "accuracy" in reader.attributes["case_si"]:
        yield Words((*_of_finer_slices(reader), f"{_NO_TARGET} `{_with_target(reader)}`."))


def _in_columns(row: tuple[Cell, ...]) -> tuple[Cell, ...]:
    """An error as a number, or what is said in place of it beside who says so."""
    what, value, by = row
    if isinstance(value, Number):
        return row
    return what, "", f"{value}; {by}" if by else value


def _of_finer_slices(reader: Reader) -> Iterator[str]:
    """What the estimate by slices counts, and what not."""
    counts = (reader.attributes.get("slice_error") or {}).get("slices")
    if counts:
        elastic = len(reader.blocks) > 1
        yield _SLICES.format(*counts) + (f" {_NOT_IN_IT} {_MEASURED}" if elastic else "")


def _with_target(reader: Reader) -> str:
    return f'flexbearing run {reader.case_name} --set "accuracy.target=1 %" -o OUT.h5'


def _of_slices(reader: Reader) -> str:
    """What is known of peak pressures without an estimate."""
    if {note["code"] for note in reader.attributes["notes"]} & PRESSURE_NOTES:
        return "see the notes on peak pressure under Limits"
    if reader.bearing.get("contact") != "slices":
        return ""
    return "slices were within 5 % of whole contacts in cases without a note on peak pressure, as here"


def _caption(reader: Reader) -> str:
    errors = reader.attributes.get("error_estimate")
    if not errors:
        return "Numerical errors"
    met = "is estimated to be kept" if errors["met"] else "was NOT kept"
    return f"Numerical errors; the target of {100 * errors['target']:g} % {met}"


def _of_target(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    """What `accuracy.target` estimates, or that it was not requested; the life also by finer slices."""
    estimates = reader.attributes.get("error_estimate") or {}
    by = "neighbouring levels of accuracy" if estimates else "finer slices"
    if not reader.of_rollers:
        return
    words: dict[str, str] = {}  # of the first output that has an error
    for entry in (entry for entry in reader.layout.summary if entry.error):
        points = "" if entry.error_relative else ", percentage points"
        words.setdefault(entry.error, f"{reader.label(entry).strip()}{points}")
    if len(reader.blocks) < 2:
        words.pop("total_stiffness", None)  # that of the bearing
    words.pop("peak_pressure", None)  # has rows of its own
    if whole := with_supports(reader):
        yield (
            words.pop("total_stiffness"),
            whole,
            "finer slices, and the meshes of the supports by their share",
        )
    for name in (name for name in words if reader.error_path(name)):
        yield _by_grid(reader, name, words[name], by)
    if estimates.get("life") is None:
        yield (
            words["life"],
            lives.error(reader, "life_L10"),
            "finer slices and more axial shapes; those of the other lives are beside them",
        )
    left = [text for name, text in words.items() if name != "life" and not reader.error_path(name)]
    if left:
        yield "; ".join(left), NOT_ESTIMATED, ""


def _by_grid(reader: Reader, name: str, words: str, by: str) -> tuple[Cell, ...]:
    """Error of an output by its grid; that of the torque has the residual of the losses in it."""
    if name == TORQUE and (whole := of_torque(reader)):
        return words, whole, f"{by}, and the discretisation residual over the power (see Heat by cause)"
    return words, reader.of_attribute(reader.error_path(name), "1", "%", ".2g"), by


def _of_pressures(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    """Errors of the peak pressures, by their estimates."""
    summary = reader.summary.get(reader.last) or {}
    pressures = summary.get("peak_pressure_error_MPa")
    for race in summary.get("peak_pressure_MPa") or {}:
        what, known = f"peak pressure, {race} raceway", (pressures or {}).get(race)
        if known is not None and np.isfinite(known):
            path = f"percent/{reader.last}/peak_pressure_error_MPa/{race}/peak_pressure_MPa/{race}"
            of = 100 * known / summary["peak_pressure_MPa"][race]
            yield what, reader.units.number(of, "%", "%", ".2g", path), "cells of twice the size"
        elif path := reader.error_path("peak_pressure"):
            yield what, reader.of_attribute(path, "1", "%", ".2g"), f"finer slices; {_of_slices(reader)}"
        elif not _exact(reader):
            yield what, NOT_ESTIMATED, _of_slices(reader)


def _of_single_outputs(reader: Reader) -> Iterator[tuple[Cell, ...]]:
    """Errors that outputs have of their own."""
    summary = reader.summary.get(reader.last) or {}
    yield from _of_pressures(reader)
    if (stress := _of_bars(reader)) is not None:
        yield "nominal stress of the bars", stress, "its own mesh"
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
