"""The files of a table: each appears whole, or what had its name before stays."""

from collections.abc import Iterable
from pathlib import Path

from flexbearing.files import require_output, write
from flexbearing.studies.table.forms import FORMS, missing
from flexbearing.studies.table.table import Table

CYCLES = "_duty"  # behind the name of the study, in that of the table of lives under its duty cycle

SCATTER = ("_percentiles", "_shares", "_histogram")  # the same of what a sampled study tells of its outputs


def places(folder: Path, name: str, inputs: Iterable[Path]) -> dict[str, Path]:
    """Settle where the table goes, before anything is computed.

    Parameters
    ----------
    folder : Path
        is there
    name : str
        of the study
    inputs : iterable of Path
        files that are read

    Returns
    -------
    dict
        suffix to path, of every form that can be written

    Raises
    ------
    BadOutput
        for a file that cannot be written, or that is read
    """
    given = tuple(inputs)
    return {
        suffix: require_output(folder / f"{name}{suffix}", given) for suffix in FORMS if not missing(suffix)
    }


def store(table: Table, paths: dict[str, Path]) -> None:
    """Write a table in every form.

    Parameters
    ----------
    table : Table
        whatever it holds
    paths : dict
        of `places`

    Raises
    ------
    NotStored
        if there is no room for a file
    """
    for suffix, path in paths.items():
        write(path, FORMS[suffix][0](table))
        if table.cycles is not None:
            write(path.with_name(f"{table.cycles.name}{suffix}"), FORMS[suffix][0](table.cycles))
