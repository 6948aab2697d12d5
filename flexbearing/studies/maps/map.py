"""A map of a case in files: tables, picture and page."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import TYPE_CHECKING

from flexbearing.api import check
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.files import require_outputs, write
from flexbearing.printable import excerpt
from flexbearing.program.commands import keeping
from flexbearing.progress import Report
from flexbearing.report.picture import FORMATS, Format, picture_bytes
from flexbearing.runs.run_case import stem_of_outputs
from flexbearing.studies.maps import branch, pages
from flexbearing.studies.maps.axes import FORM, axes
from flexbearing.studies.maps.solution import OUTPUTS, solved_map
from flexbearing.studies.table.files import csv_bytes, missing, netcdf_bytes

if TYPE_CHECKING:
    from flexbearing.studies.maps.branch import FollowedMap
    from flexbearing.studies.maps.solution import SolvedMap

POINT, SIZE = 1.5e-3, 4e-3  # [s] of a processor, [MB] for a point


@dataclass(frozen=True)
class WrittenMap:
    """A map that is written."""

    found: "SolvedMap | FollowedMap"
    text: str
    complete: bool  # whether every point has a result, or the branch left its range
    files: dict[str, Path]  # by what they are


@dataclass(frozen=True)
class MapRequest:
    """What is mapped, and where to."""

    case: str | Path
    over: tuple[
        str, ...
    ]  # KEY=FROM..TO,N each; a load or speed alone, without N, is followed around its folds
    of: tuple[str, ...] = ()  # outputs with their units; the main ones without
    output: str | Path | None = None  # table (CSV), all others beside it; `results/<case>_map.csv` without
    overrides: tuple[str, ...] = ()  # "key=value" settings that replace those of the file
    form: str = "png"  # of the picture


def map_case(request: MapRequest, report: Report) -> WrittenMap:
    """Compute a map and write its files.

    Raises `BadCase` when axes, outputs or case make no sense, or maps of such a case are not supported;
    `BadOutput` when a file cannot be written, and then nothing is computed; `NotStored` when there is no room
    for a file; `NotSolved` when nothing can be computed.
    """
    case, over, overrides, form = request.case, request.over, request.overrides, request.form
    default = Path("results") / f"{stem_of_outputs(case, overrides)}_map.csv"
    table = Path(request.output or default)
    if table.suffix != ".csv":
        raise BadCase(f"--output {excerpt(str(table))}: the table is written as CSV; its name ends in .csv")
    if form not in FORMATS:
        raise BadCase(f"--format {excerpt(form)}: it is one of {', '.join(FORMATS)}")
    picture = table.with_suffix(f".{form}")
    if branch.is_followed(over):
        return _followed(case, over[0], overrides, {"table": table, "picture": picture})
    files = {
        "table": table,
        "picture": picture,
        "page": table.with_suffix(".html"),
        "folds": table.with_name(f"{table.stem}_folds.csv"),
    }
    if len(over) > 1:
        files["fold curves"] = table.with_name(f"{table.stem}_fold_curves.csv")
    if not missing(".nc"):
        files["arrays"] = table.with_suffix(".nc")
    first = check(case, overrides)
    if not isinstance(first, Case):
        raise BadCase(f'{case}: only roller bearings have maps; this case has kind = "{first.kind}"')
    if without := [text for text in over if "," not in text]:
        raise BadCase(f"--over {without[0]}: {FORM}")
    wanted = axes(over, type(first))
    require_outputs(files.values(), first.input_files)
    points = prod(len(axis.values) for axis in wanted)
    cost = f"about {points * POINT:.2g} s and {points * SIZE:.2g} MB"
    report.line(f"{points} points, {cost}; longer where equilibria end")
    found = solved_map(first, wanted, request.of or OUTPUTS, report)
    _write(found, files, Format(form))
    return WrittenMap(found, pages.text(found), not len(found.unsolved), files)


def _followed(case: str | Path, over: str, overrides: Sequence[str], files: dict[str, Path]) -> WrittenMap:
    """A branch with its table and picture."""
    from flexbearing.report.studies.branch_figure import draw_branch

    wanted = branch.ends(case, over, overrides)
    require_outputs(files.values(), wanted.case.input_files)
    found = branch.followed(wanted)
    write(files["table"].resolve(), csv_bytes(found.table()))
    with keeping([files["table"]], "the table is complete"):
        figure = draw_branch(found.title, found.axis.label, found.columns(), found.raceways)
        form = Format(files["picture"].suffix.removeprefix("."))
        write(files["picture"].resolve(), picture_bytes(figure, form))
    return WrittenMap(found, found.text(), found.complete, files)


def _write(found: "SolvedMap", files: dict[str, Path], form: Format) -> None:
    from flexbearing.report.html.write import html

    table = csv_bytes(pages.rows(found))
    write(files["table"].resolve(), table)
    with keeping([files["table"]], "the table is complete"):
        write(files["folds"].resolve(), csv_bytes(pages.folds(found)))
        if "fold curves" in files:
            write(files["fold curves"].resolve(), csv_bytes(pages.curves(found)))
        if "arrays" in files:
            write(files["arrays"].resolve(), netcdf_bytes(pages.arrays(found)))
        write(files["picture"].resolve(), picture_bytes(pages.picture(found), form))
        document = pages.page(found, files["table"].name, table.decode())
        write(files["page"].resolve(), html(document).encode())
