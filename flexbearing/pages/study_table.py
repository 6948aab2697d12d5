"""Which table of a study a path means."""

from pathlib import Path

from flexbearing.results import BadResult
from flexbearing.studies.table.files import CYCLES, SCATTER


def table_file(place: Path) -> Path:
    """Find the table of a study.

    Parameters
    ----------
    place : Path
        a table, the folder that holds one, or the folder of the results of a study beside its table

    Returns
    -------
    Path
        a CSV file

    Raises
    ------
    BadResult
        where there is none, or a folder holds several
    """
    if not place.is_dir():
        return place
    folder = place.resolve()  # "." has a name as well
    if (beside := folder.parent / f"{folder.name}.csv").is_file():
        return beside
    tables = sorted(path for path in place.glob("*.csv") if not path.stem.endswith((CYCLES, *SCATTER)))
    if len(tables) == 1:
        return tables[0]
    names = ", ".join(path.name for path in tables)
    raise BadResult(
        f"{place}: "
        + (f"holds several tables, name one: {names}." if tables else "holds no table of a study.")
    )
