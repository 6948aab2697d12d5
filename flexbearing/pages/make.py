"""From a result, two results or a study to the file of its report."""

import os
import shutil
import subprocess
from collections.abc import Iterable
from pathlib import Path
from tempfile import TemporaryDirectory

from flexbearing import api
from flexbearing.case import BadCase
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput, NotStored, require_outputs, write
from flexbearing.inputs import is_folder, is_plain
from flexbearing.pages.against import parts
from flexbearing.report.html import SYSTEMS, Units, html, of_result, of_study
from flexbearing.report.html.document import Document
from flexbearing.report.html.scatter import read_scatter
from flexbearing.report.html.table import MOST_ROWS, PARQUET, read_table
from flexbearing.results import BadResult, Result
from flexbearing.studies.table.files import CYCLES, SCATTER

PAGES = (".html", ".htm")
TABLES = (".csv", PARQUET)  # of a study
ARRAYS = ".nc"  # of a study: the same numbers over its axes, which are no table


def report(
    source: str | Path | Result,
    output: str | Path | None = None,
    *,
    against: str | Path | None = None,
    units: str = "metric",
    pdf: bool = False,
) -> list[Path]:
    """Write the report of a result or of a study as one HTML file, which opens without a network.

    Raises
    ------
    BadCase
        for other units, or a study against a result
    BadResult
        when there is no complete result, no table, or the kinds of bearing differ
    BadOutput
        for files that cannot be written, another name than one of HTML, and without a Chromium that prints;
        nothing was read then
    NotStored
        when there is no room left, or Chromium did not print
    """
    if units not in SYSTEMS:
        raise BadCase(f"units {units}: it is {' or '.join(SYSTEMS)}")
    browser = chromium() if pdf else ""
    place = (source.path or Path(f"{source.stem}.h5")) if isinstance(source, Result) else Path(source)
    if place.suffix == ARRAYS:
        raise BadCase(
            f"{place}: holds the arrays of a study, not its rows; name the table beside it: "
            f"{place.with_suffix(TABLES[0]).name}"
        )
    of_table = not isinstance(source, Result) and (is_folder(place) or place.suffix in TABLES)
    if of_table and against is not None:
        raise BadCase(f"against {against}: {source} is a study; only results are compared")
    place = table_file(place) if of_table else place
    wanted = Path(output or place.with_name(f"{place.stem}_report.html"))
    outputs = [wanted, *([wanted.with_suffix(".pdf")] if pdf else [])]
    inputs = tables_of(place) if of_table else [place, *([Path(against)] if against is not None else [])]
    page, *printed = require_outputs(outputs, inputs)
    if wanted.suffix not in PAGES:
        raise BadOutput(f"{wanted}: a report is HTML; choose a name that ends in {PAGES[0]}.")
    if of_table:
        document = _of_study(place, SYSTEMS[units])
    else:
        first, *others = [source if isinstance(source, Result) else place, *inputs[1:]]
        document = _of_result([first, *others], SYSTEMS[units], outputs)
    write(page, html(document).encode())
    for paper in printed:
        write(paper, pdf_bytes(browser, page))
    return outputs


def _of_result(sources: Iterable[Path | Result], units: Units, outputs: Iterable[Path]) -> Document:
    """Report of a result, perhaps against another; no output may be a file that they were computed from."""
    result, *others = (each if isinstance(each, Result) else api.read(each) for each in sources)
    require_outputs(outputs, [file for each in (result, *others) for file in each.files])
    return of_result(result, units, parts(result, others[0], units) if others else None)


def _of_study(place: Path, units: Units) -> Document:
    """Report of a table, with the lives under its duty cycle and its scatter where there are such."""
    _, cycles, *_ = tables_of(place)
    of_cycles = read_table(cycles, FAMILIES, MOST_ROWS + 1) if is_plain(cycles) else None
    return of_study(read_table(place, FAMILIES), of_cycles, units, read_scatter(place))


def tables_of(table: Path) -> list[Path]:
    """The table of a study, that of lives under its duty cycle, those of its scatter; there or not."""
    return [table.with_name(f"{table.stem}{part}{table.suffix}") for part in ("", CYCLES, *SCATTER)]


def table_file(place: Path) -> Path:
    """Find the table of a study.

    Raises `BadResult` where there is none, or a folder holds several.
    """
    if not is_folder(place):
        return place
    folder = place.resolve()  # "." has a name as well
    if is_plain(beside := folder.parent / f"{folder.name}.csv"):
        return beside
    tables = sorted(path for path in place.glob("*.csv") if not path.stem.endswith((CYCLES, *SCATTER)))
    if len(tables) == 1:
        return tables[0]
    names = ", ".join(path.name for path in tables)
    raise BadResult(
        f"{place}: "
        + (f"holds several tables, name one: {names}." if tables else "holds no table of a study.")
    )


NAMES = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome")
SECONDS = 120.0  # that a page may take


def chromium() -> str:
    """Find an installed Chromium.

    Raises `BadOutput` where there is none.
    """
    for name in NAMES:
        if found := shutil.which(name):
            return found
    raise BadOutput("--pdf: no Chromium is installed that could print; the HTML report needs none.")


def pdf_bytes(browser: str, page: Path) -> bytes:
    """Print a page.

    Raises `NotStored` where Chromium ends without one.
    """
    alone = ["--no-sandbox"] if os.geteuid() == 0 else []  # Chromium refuses to run as root otherwise
    with TemporaryDirectory() as folder:
        printed = Path(folder) / "report.pdf"
        options = [
            "--headless=new", "--disable-gpu", "--no-pdf-header-footer", "--virtual-time-budget=20000",
            f"--user-data-dir={folder}/profile", "--window-size=720,1000", f"--print-to-pdf={printed}",
        ]  # fmt: skip
        command = [browser, *alone, *options, page.resolve().as_uri()]
        try:
            done = subprocess.run(command, capture_output=True, timeout=SECONDS, check=False)
        except subprocess.TimeoutExpired:
            raise NotStored(
                f"{page}: Chromium did not print it within {SECONDS:.0f} s; the HTML is complete."
            ) from None
        if not printed.is_file():
            last = done.stderr.decode(errors="replace").strip().splitlines()[-1:]
            raise NotStored(f"{page}: Chromium did not print it ({' '.join(last)}); the HTML is complete.")
        return printed.read_bytes()
