"""A bearing of a rotor for ROSS, as TOML: its stiffness over the speed of a study, or of one result.

ROSS has z along the shaft and counts speeds positive about it. With s the sign of the speed, x axial, z along
the load here, x = s y, y = -z, z = -s x there: a right-handed system in which the load of a case without
load direction points down.
"""

import csv
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import StringIO
from math import isfinite
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing import inputs
from flexbearing.files import require_folder, require_outputs, write
from flexbearing.inputs.file import TABLE
from flexbearing.outputs import AbsentOutput
from flexbearing.outputs.value import WrongUnit, conversion
from flexbearing.results import BadResult, Result

LEAST = 5  # speeds: ROSS takes a cubic through four, and extrapolates without a word
SPEED, CONVERGED = "operation.inner_speed", "converged"
ENTRIES = ("yy", "yz", "zy", "zz")  # force by displacement
TILT_FOLLOWS, TILT_HELD = "total_stiffness", "stiffness"  # with free tilt, as of rollers; of balls
AXES = {2: "frequency", 3: "speed"}  # what the first axis of a bearing is called, by version of ROSS
_HEADING = re.compile(r"(?P<name>[^\[]*?)(?: \[(?P<unit>[^]]*)\])?")


@dataclass(frozen=True)
class Bearing:
    """Radial stiffness over the speed, in the axes of ROSS."""

    speed: NDArray  # (n) [rad/s], growing, above or at zero
    kxx: NDArray  # (n) [N/m]
    kxy: NDArray  # force along x by displacement along y
    kyx: NDArray
    kyy: NDArray
    inside: str = ""  # whether supports are in it


def export(source: Path | Result, directory: Path) -> Iterator[Path]:
    """Write the bearing of a study over its speeds, a file for each version of ROSS; of a result one for all.

    Raises `BadResult` if the table cannot be read or is none over five speeds or more, or the result has no
    stiffness; `BadOutput`, `NotStored` if a file cannot be written.
    """
    bearing = of_result(source) if isinstance(source, Result) else read(source)
    folder, files = require_folder(directory), source.files if isinstance(source, Result) else (source,)
    versions = {f"_ross{version}": axis for version, axis in AXES.items()}
    ends = versions if len(bearing.speed) > 1 else {"_ross": ""}
    paths = {folder / f"{source.stem}{end}.toml": axis for end, axis in ends.items()}
    require_outputs(paths, files)
    for path, axis in paths.items():
        write(path.resolve(), text(bearing, source.stem, axis).encode())
        yield path


def of_result(result: Result) -> Bearing:
    """The bearing at the speed of a result.

    Raises `BadResult` where it did not converge, or has no stiffness.
    """
    if result.attributes["status"] != CONVERGED:
        raise BadResult(f"{result.place}: not converged: {result.attributes['message']}.")
    case = result.attributes["case_si"]
    kinds = {race: (case.get(race) or {}).get("kind", "rigid") for race in ("inner", "outer")}
    rings = case.get("rings") or {}  # of slow balls
    kinds |= {
        race: ring["kind"] for race, ring in rings.items() if isinstance(ring, Mapping) and "kind" in ring
    }
    elastic = [f"{race} ring ({kind})" for race, kind in kinds.items() if kind != "rigid"]
    speed = case["operation"].get("inner_speed") or 0.0
    which = TILT_FOLLOWS if f"{TILT_FOLLOWS}_yy" in result.outputs else TILT_HELD
    try:
        yy, yz, zy, zz = (np.array([float(result[f"{which}_{entry} [N/m]"])]) for entry in ENTRIES)
    except AbsentOutput as problem:  # such as of a ball under given loads of its contacts
        raise BadResult(f"{result.place}: {problem}") from problem
    turns = np.sign(speed) or 1.0
    return Bearing(np.array([abs(speed)]), yy, -turns * yz, -turns * zy, zz, _inside(elastic))


def _inside(elastic: Sequence[str]) -> str:
    if not elastic:
        return "Rings and supports are rigid: no stiffness of a support or housing is inside."
    return f"Inside is the deflection of {', '.join(elastic)} with supports: leave them out of the rotor."


def text(bearing: Bearing, tag: str, axis: str) -> str:
    """A bearing as ``BearingElement.load`` of ROSS reads it, at node 0, without damping."""
    numbers = {"kxx": bearing.kxx, "kxy": bearing.kxy, "kyx": bearing.kyx, "kyy": bearing.kyy}
    values = {**numbers, **{f"c{name[1:]}": 0.0 * each for name, each in numbers.items()}}
    lists = {axis: bearing.speed, **values} if axis else values
    lines = [f"{name} = {json.dumps(each.tolist() if axis else each.item())}" for name, each in lists.items()]
    head = [
        f"# {bearing.inside}",
        f"[{json.dumps(f'BearingElement_{tag}')}]",
        "n = 0",
        f"tag = {json.dumps(tag)}",
    ]
    return "\n".join([*head, *lines]) + "\n"


def read(path: Path) -> Bearing:
    """Read the table of a study.

    Raises `BadResult` naming the column or the row that is missing or wrong.
    """
    try:
        heads, *rows = csv.reader(StringIO(inputs.text(path, TABLE), newline=""), strict=True)
        inputs.require_different(heads)
    except inputs.Unreadable as problem:
        raise BadResult(f"{path}: is no table of a study: {problem}.") from problem
    except (ValueError, csv.Error) as problem:
        raise BadResult(f"{path}: is no table of a study: it is no CSV.") from problem
    speeds = _column(path, heads, rows, (SPEED,), "rad/s")
    of_balls = not any(TILT_FOLLOWS in head for head in heads) and any(TILT_HELD in head for head in heads)
    which = TILT_HELD if of_balls else TILT_FOLLOWS
    states = [_column(path, heads, rows, _names(f"{which}_{entry}"), "N/m") for entry in ENTRIES]
    flexible = any(head.startswith(f"flexible.{which}") for head in heads)
    _require_speeds(path, heads, rows, speeds)
    if (least := min(states[0].min(), states[3].min())) <= 0:
        raise BadResult(
            f"{path}: has a stiffness of {least:.3g} N/m along y or z, which is not positive: no rotor is "
            "stable on it."
        )
    turns = np.sign(speeds[np.argmax(np.abs(speeds))])
    order = np.argsort(np.abs(speeds))
    yy, yz, zy, zz = (state[order] for state in states)
    return Bearing(np.abs(speeds)[order], yy, -turns * yz, -turns * zy, zz, _INSIDE[flexible])


_INSIDE = {
    True: "Inside is the deflection of elastic rings with their supports: leave them out of the rotor.",
    False: "Inside are supports only if the case of the study has elastic rings.",
}


def _names(entry: str) -> tuple[str, ...]:
    """Columns that may hold an output, the first that is there is taken."""
    return f"flexible.{entry}", entry, f"rigid.{entry}"


def _column(
    path: Path, heads: Sequence[str], rows: Sequence[Sequence[str]], names: Sequence[str], unit: str
) -> NDArray:
    """Numbers of the first of some columns in a unit."""
    found: Mapping[str, tuple[int, str]] = {
        parts["name"]: (place, parts["unit"] or "1")
        for place, head in enumerate(heads)
        if (parts := _HEADING.fullmatch(head))
    }
    name = next((name for name in names if name in found), None)
    if name is None:
        raise BadResult(
            f"{path}: has no column {names[-1].removeprefix('rigid.')}; a study without [collect] has it."
        )
    place, given = found[name]
    try:
        factor = conversion(given, unit).factor
        values = np.array([inputs.number(row[place]) for row in rows]) * factor
    except (WrongUnit, inputs.BadNumber, IndexError) as problem:
        raise BadResult(f"{path}: column {name}: a row has no number, or not in {unit}.") from problem
    return values


def _require_speeds(path: Path, heads: Sequence[str], rows: Sequence[Sequence[str]], speeds: NDArray) -> None:
    """Raise unless the rows are converged states of one case at enough speeds of one direction."""
    status = heads.index("status") if "status" in heads else None
    if status is None or any(row[status] != CONVERGED for row in rows):
        raise BadResult(f"{path}: has rows that did not converge.")
    if len({*np.abs(speeds)}) < len(speeds):
        raise BadResult(f"{path}: has a speed twice; vary {SPEED} alone.")
    if len(speeds) < LEAST or not all(map(isfinite, speeds)):
        raise BadResult(f"{path}: has {len(speeds)} speeds; ROSS needs {LEAST} or more.")
    if speeds.min() < 0 < speeds.max():
        raise BadResult(f"{path}: has speeds of both directions; the axes of ROSS follow the direction.")
