"""A bearing of a rotor for ROSS: its stiffness over the speed, from the table of a study, as TOML.

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
from flexbearing.inputs.limits import TABLE
from flexbearing.outputs.value import WrongUnit, conversion
from flexbearing.results import BadResult

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


def export(table: Path, directory: Path) -> Iterator[Path]:
    """Write the bearing of a study over its speeds, a file for each version of ROSS.

    Raises
    ------
    BadResult
        if the table cannot be read or is none over five speeds or more
    BadOutput, NotStored
        if a file cannot be written
    """
    bearing, folder = read(table), require_folder(directory)
    paths = {version: folder / f"{table.stem}_ross{version}.toml" for version in AXES}
    require_outputs(paths.values(), (table,))
    for version, path in paths.items():
        write(path.resolve(), text(bearing, table.stem, AXES[version]).encode())
        yield path


def text(bearing: Bearing, tag: str, axis: str) -> str:
    """A bearing as ``BearingElement.load`` of ROSS reads it, at node 0 and without damping."""
    numbers = {"kxx": bearing.kxx, "kxy": bearing.kxy, "kyx": bearing.kyx, "kyy": bearing.kyy}
    lists = {axis: bearing.speed, **numbers, **{f"c{name[1:]}": 0.0 * each for name, each in numbers.items()}}
    lines = [f"{name} = {json.dumps(each.tolist())}" for name, each in lists.items()]
    head = [f"[{json.dumps(f'BearingElement_{tag}')}]", "n = 0", f"tag = {json.dumps(tag)}"]
    return "\n".join([*head, *lines]) + "\n"


def read(path: Path) -> Bearing:
    """Read the table of a study.

    Raises
    ------
    BadResult
        naming the column or the row that is missing or wrong
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
    _require_speeds(path, heads, rows, speeds)
    if (least := min(states[0].min(), states[3].min())) <= 0:
        raise BadResult(
            f"{path}: has a stiffness of {least:.3g} N/m along y or z, which is not positive: no rotor is "
            "stable on it."
        )
    turns = np.sign(speeds[np.argmax(np.abs(speeds))])
    order = np.argsort(np.abs(speeds))
    yy, yz, zy, zz = (state[order] for state in states)
    return Bearing(np.abs(speeds)[order], yy, -turns * yz, -turns * zy, zz)


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
