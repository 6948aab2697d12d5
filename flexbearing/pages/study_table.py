"""Which table of a study a path means."""

from pathlib import Path

from flexbearing.inputs import is_folder, is_plain
from flexbearing.results import BadResult
from flexbearing.studies.table.files import CYCLES, SCATTER


def tables_of(table: Path) -> list[Path]:
    """The table of a study, that of lives under its duty cycle, those of its scatter; there or not."""
    return [table.with_name(f"{table.stem}{part}{table.suffix}") for part in ("", CYCLES, *SCATTER)]


def table_file(place: Path) -> Path:
    """Find the table of a study.

    Raises
    ------
    BadResult
        where there is none, or a folder holds several
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
