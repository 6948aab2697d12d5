"""A result as netCDF4: groups of arrays with named dimensions, places along them and units."""

from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path

from flexbearing.files import BadOutput, require_folder, require_output, write
from flexbearing.results import Result

EXTRA = 'pip install "flexbearing[studies]"'


def export(result: Result, directory: Path) -> Iterator[Path]:
    """Write a result as `Result.to_xarray` has it.

    Raises
    ------
    BadOutput
        if the file cannot be written, or xarray and h5netcdf are not installed
    NotStored
        if there is no room for it
    """
    if missing := [name for name in ("xarray", "h5netcdf") if find_spec(name) is None]:
        raise BadOutput(f"--to netcdf needs {' and '.join(missing)}: {EXTRA}.")
    path = require_output(require_folder(directory) / f"{result.stem}.nc", result.files)
    write(path, bytes(result.to_xarray().to_netcdf(engine="h5netcdf")))  # type: ignore[arg-type]
    yield path
