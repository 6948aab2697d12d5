"""From a result, two results or a study to the file of its report."""

from collections.abc import Iterable
from pathlib import Path

from flexbearing import api
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.files import require_output, write
from flexbearing.inputs import is_folder, is_plain
from flexbearing.pages.against import section
from flexbearing.pages.chromium import chromium, pdf_bytes
from flexbearing.pages.study_table import table_file
from flexbearing.report.html import SYSTEMS, Units, html, of_result, of_study
from flexbearing.report.html.document import Document
from flexbearing.report.html.scatter import read_scatter
from flexbearing.report.html.table import PARQUET, read_table
from flexbearing.results import Result

TABLES = (".csv", PARQUET)  # of a study
ARRAYS = ".nc"  # of a study: the same numbers over its axes, which are no table


def report(
    source: str | Path,
    output: str | Path | None = None,
    *,
    against: str | Path | None = None,
    units: str = "metric",
    pdf: bool = False,
) -> list[Path]:
    """Write the report of a result or of a study as one HTML file, which opens without a network.

    Parameters
    ----------
    source : path
        result file, the table of a study (CSV or Parquet), or a folder with one such table
    output : path, optional
        where to; else beside the source, NAME_report.html
    against : path, optional
        another result of the same kind of bearing, to compare with
    units : str
        "metric" or "imperial", of every number but those in texts of the case and in its notes
    pdf : bool
        whether the same is printed to a PDF file beside it, by an installed Chromium

    Returns
    -------
    list of Path
        what was written

    Raises
    ------
    BadCase
        for other units, or a study against a result
    BadResult
        when there is no complete result, no table, or the kinds of bearing differ
    BadOutput
        when a file cannot be written, or there is no Chromium that prints; nothing was read then
    NotStored
        when there is no room left, or Chromium did not print
    """
    if units not in SYSTEMS:
        raise BadCase(f"--units {units}: it is {' or '.join(SYSTEMS)}")
    browser = chromium() if pdf else ""
    place = Path(source)
    if place.suffix == ARRAYS:
        raise BadCase(
            f"{place}: holds the arrays of a study, not its rows; name the table beside it: "
            f"{place.with_suffix(TABLES[0]).name}"
        )
    of_table = is_folder(place) or place.suffix in TABLES
    if of_table and against is not None:
        raise BadCase(f"--against {against}: {source} is a study; only results are compared")
    place = table_file(place) if of_table else place
    wanted = Path(output or place.with_name(f"{place.stem}_report.html"))
    inputs = [place, *([Path(against)] if against is not None else [])]
    page = require_output(wanted, inputs)
    printed = require_output(wanted.with_suffix(".pdf"), [*inputs, page]) if pdf else None
    document = (
        _of_study(place, SYSTEMS[units])
        if of_table
        else _of_result(place, against, SYSTEMS[units], [page, printed])
    )
    write(page, html(document).encode())
    if printed is None:
        return [wanted]
    write(printed, pdf_bytes(browser, page))
    return [wanted, wanted.with_suffix(".pdf")]


def _of_result(
    place: Path, against: str | Path | None, units: Units, outputs: Iterable[Path | None]
) -> Document:
    """Report of a result, which is read; none of its outputs may be its case."""
    result = api.read(place)
    _spare_case(result, outputs)
    if against is None:
        return of_result(result, units)
    other = api.read(against)
    _spare_case(other, outputs)
    return of_result(result, units, (section(result, other, units),))


def _spare_case(result: Result, outputs: Iterable[Path | None]) -> None:
    """Raise where an output is the case that a result was computed from."""
    if case := result.attributes.get("case_file"):
        for output in filter(None, outputs):
            require_output(output, [case])


def _of_study(place: Path, units: Units) -> Document:
    """Report of a table, with the lives under its duty cycle and its scatter where there are such."""
    cycles = place.with_name(f"{place.stem}_duty{place.suffix}")
    of_cycles = read_table(cycles, FAMILIES) if is_plain(cycles) else None
    return of_study(read_table(place, FAMILIES), of_cycles, units, read_scatter(place))
