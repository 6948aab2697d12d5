"""Load cases of a bearing as a duty cycle: a table, and the study of it."""

from collections.abc import Collection
from math import fsum
from pathlib import Path

from flexbearing.case.declarations import toml
from flexbearing.catalogue.entries import LIKES
from flexbearing.catalogue.rexs.bearings import Bearing
from flexbearing.catalogue.rexs.operation import Point
from flexbearing.files import as_csv, require_outputs, write

RATED = 0.5  # [%] by how much a sum of percentages may be off
COLUMNS = {  # entry to heading
    "load": "operation.load.radial_z [N]",
    "axial": "operation.load.axial [N]",
    "speed": "operation.inner_speed [rpm]",
    "temperature": "lubricant.inlet_temperature [degC]",
}
OF_ROLLERS = {"load": "operation.radial_load [N]"}


def places(case: Path) -> tuple[Path, Path]:
    """Where table and study of a case go."""
    return case.with_name(f"{case.stem}_duty.csv"), case.with_name(f"{case.stem}_cycle.toml")


def written(bearing: Bearing, case: Path, given: Collection[str], source: str) -> str:
    """Write the load cases as a duty cycle.

    Parameters
    ----------
    bearing : Bearing
        with its load cases
    case : Path
        of the bearing
    given : collection of str
        entries of the user, which hold in all load cases
    source : str
        of the load cases

    Returns
    -------
    str
        what was written, or why nothing was; empty for a single load case

    Raises
    ------
    BadOutput, NotStored
        where it cannot be written
    """
    points = bearing.points
    if len(points) < 2:
        return ""
    lacking = _lacking(bearing)
    if lacking:
        return f"no duty cycle of its {len(points)} load cases: {lacking}"
    measure = next(unit for unit in ("%", "h") if all(unit in point.shares for point in points))
    shares = [point.shares[measure] for point in points]
    known = {name: [_value(point, name) for point in points] for name in COLUMNS}
    known = {
        name: values
        for name, values in known.items()
        if name in LIKES[bearing.like].taken and name not in given and None not in values
    }
    complete = measure == "h" or abs(fsum(shares) - 100) <= RATED
    headings = COLUMNS | (OF_ROLLERS if LIKES[bearing.like].kind == "cylindrical_roller" else {})
    header = [f"time [{measure}]" if complete else "time", *(headings[name] for name in known)]
    table, study = require_outputs(places(case))
    write(table, as_csv([header, *zip(shares, *known.values(), strict=True)]).encode())
    words = f"# Load cases of {source}, with their shares of the time.\n"
    write(study, f"{words}case = {toml(case.name)}\n\n[duty]\nfile = {toml(table.name)}\n".encode())
    off = "" if complete else f", whose shares add up to {fsum(shares):g} % and are scaled to 100 %"
    return f"{len(points)} load cases: flexbearing study {study.name}{off}"


def _lacking(bearing: Bearing) -> str:
    """Why there is no duty cycle."""
    points = bearing.points
    if "dynamic_rating" not in LIKES[bearing.like].taken:
        return f"a {bearing.like} has no life"
    if not any(all(unit in point.shares for point in points) for unit in ("%", "h")):
        return "not all have a share of the time (load_duration_fraction, operating_time_fraction)"
    if any(point.radial is None for point in points):
        return "not all have a force on the bearing"
    if any(point.speed is None for point in points):
        return "not all have a speed"
    return ""


def _value(point: Point, name: str) -> float | None:
    values = {
        "load": point.radial,
        "axial": point.axial,
        "speed": point.speed,
        "temperature": point.temperature,
    }
    return values[name]
