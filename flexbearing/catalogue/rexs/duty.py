"""Load cases of a bearing as a duty cycle: a table, and the study of it."""

from collections.abc import Collection, Mapping
from math import fsum
from pathlib import Path

from flexbearing.case.declarations import toml
from flexbearing.catalogue.entries import LIKES
from flexbearing.catalogue.new import one_line
from flexbearing.catalogue.rexs.bearings import Bearing
from flexbearing.catalogue.rexs.load_cases import PRESSED, Point, measure_of
from flexbearing.files import as_csv, require_outputs, write

COMPLETE = 0.5  # [%] by how much a sum of percentages may be off, as studies allow
COLUMNS = {  # entry to heading
    "load": "operation.load.radial_z [N]",
    "axial": "operation.load.axial [N]",
    "speed": "operation.inner_speed [rpm]",
    "outer_speed": "operation.outer_speed [rpm]",
    "temperature": "lubricant.inlet_temperature [degC]",
}
OF_POINT = {
    "load": "radial", "axial": "axial", "speed": "inner_speed", "outer_speed": "outer_speed",
    "temperature": "temperature",
}  # fmt: skip
OF_ROLLERS = {"load": "operation.radial_load [N]"}


def places(case: Path) -> tuple[Path, Path]:
    """Where table and study of a case go."""
    return case.with_name(f"{case.stem}_duty.csv"), case.with_name(f"{case.stem}_cycle.toml")


def written(bearing: Bearing, case: Path, given: Collection[str], source: str) -> str:
    """Write the load cases as a duty cycle; in words what was written, or why nothing was.

    Raises `BadOutput`, `NotStored` where it cannot be written.
    """
    count = len(bearing.points)
    if count < 2:
        return ""
    columns = _columns(bearing, given)
    if lacking := _lacking(bearing, columns):
        return f"no duty cycle of its {count} load cases: {lacking}"
    heading, shares, total = _shares(bearing.points)
    header = [heading, *(_heading(bearing.like, name) for name in columns)]
    table, study = require_outputs(places(case))
    write(table, as_csv([header, *zip(shares, *columns.values(), strict=True)]).encode())
    words = f"# Load cases of {one_line(source)}, with their shares of the time.\n"
    write(study, f"{words}case = {toml(case.name)}\n\n[duty]\nfile = {toml(table.name)}\n".encode())
    off = "" if "[" in heading else f", whose shares add up to {total:g} % and are scaled to 100 %"
    some = any(point.temperature is not None for point in bearing.points)
    left = (
        " without temperature, which not all have" if some and "temperature" not in {*columns, *given} else ""
    )
    return f"{count} load cases: flexbearing study {study.name}{off}{left}"


def _columns(bearing: Bearing, given: Collection[str]) -> dict[str, list[float | None]]:
    """What changes from load case to load case, by entries that the user does not give; all have loads."""
    columns = {name: [getattr(point, OF_POINT[name]) for point in bearing.points] for name in COLUMNS}
    return {
        name: values
        for name, values in columns.items()
        if name in LIKES[bearing.like].taken
        and name not in given
        and (name != "temperature" or None not in values)
        and (name != "outer_speed" or any(values))
    }


def _lacking(bearing: Bearing, columns: Mapping[str, list[float | None]]) -> str:
    """Why there is no duty cycle."""
    shares = [point.shares for point in bearing.points]
    if "dynamic_rating" not in LIKES[bearing.like].taken:
        return f"a {bearing.like} has no life"
    if (measure := measure_of(shares)) is None:
        return "not all have a share of the time (load_duration_fraction, operating_time_fraction)"
    if min(each[measure] for each in shares) < 0 or not any(each[measure] for each in shares):
        return "their shares of the time are below zero, or none is above it"
    for name, words in (
        ("load", "a force on the bearing"),
        ("axial", "an axial force"),
        ("speed", "a speed"),
    ):
        if None in columns.get(name, ()):
            return f"not all have {words}"
    needed = {"tapered_roller": [p for p in bearing.points if p.radial], "thrust_roller": bearing.points}
    if "axial" in columns and any((p.axial or 0.0) <= 0 for p in needed.get(bearing.like, ())):
        return f"not all loads press {PRESSED[bearing.like]}"
    return "" if columns else "options give all that changes"


def _shares(points: tuple[Point, ...]) -> tuple[str, list[float], float]:
    """Heading and shares of the time, and their sum."""
    measure = measure_of([point.shares for point in points])
    assert measure is not None  # else shares are lacking
    shares = [point.shares[measure] for point in points]
    total = fsum(shares)
    complete = measure != "%" or abs(total - 100) <= COMPLETE
    return (f"time [{measure}]" if complete else "time"), shares, total


def _heading(like: str, name: str) -> str:
    return OF_ROLLERS.get(name, COLUMNS[name]) if LIKES[like].kind == "cylindrical_roller" else COLUMNS[name]
