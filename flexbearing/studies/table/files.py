"""The files of a table: each appears whole, or what had its name before stays."""

from pathlib import Path

from flexbearing.files import write
from flexbearing.studies.table.forms import FORMS, missing
from flexbearing.studies.table.table import Table

# Behind the name of the study:
CYCLES = "_duty"  # in that of the table of lives under its duty cycle
SCATTER = ("_percentiles", "_shares", "_histogram")  # in those of what a sampled study says of its outputs
PICTURE, SCATTER_PICTURE = ".png", "_scatter.png"


def paths(folder: Path, name: str) -> dict[str, Path]:
    """Files of a table by their suffixes, in every form that can be written."""
    return {suffix: folder / f"{name}{suffix}" for suffix in FORMS if not missing(suffix)}


def store(table: Table, folder: Path) -> None:
    """Write a table, and that of its lives under a duty cycle, in every form.

    Raises
    ------
    NotStored
        if there is no room for a file
    """
    for each in filter(None, (table, table.cycles)):
        for suffix, path in paths(folder, each.name).items():
            write(path.resolve(), FORMS[suffix][0](each))
