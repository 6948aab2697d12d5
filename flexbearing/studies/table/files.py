"""The files of a table: each appears whole, or what had its name before stays."""

import json
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from io import BytesIO
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from flexbearing.files import as_csv, write
from flexbearing.studies.plan.task import NO_DAMAGE
from flexbearing.studies.table.table import Table

if TYPE_CHECKING:
    import pyarrow

TEXT = np.dtype("O", metadata={"vlen": str})  # of HDF5: of any length
EXTRA = 'pip install "flexbearing[studies]"'


def csv_bytes(table: Table) -> bytes:
    """A table as CSV: headings with units, then the rows; nothing stands where there is no number.

    Infinite lives of rows without damage are none either: their status says it.
    """
    headings = [column.heading for column in table.columns]
    return as_csv(
        [headings, *map(_cells, zip(*(column.values for column in table.columns), strict=True))]
    ).encode()


def _cells(row: Sequence[Any]) -> Sequence[Any]:
    return [None if value == inf else value for value in row] if NO_DAMAGE in row else row


def parquet_bytes(table: Table) -> bytes:
    """A table as Parquet, fields called as the headings.

    Each field has its unit as metadata, and the metadata of the file hold all of them as JSON, "units".
    """
    import pyarrow

    from flexbearing.report.html.parquet import sealed

    arrays = [_arrow(column.values) for column in table.columns]
    fields = [
        pyarrow.field(column.heading, array.type, metadata={"unit": column.unit})
        for column, array in zip(table.columns, arrays, strict=True)
    ]
    units = json.dumps({column.heading: column.unit for column in table.columns if column.unit})
    schema = pyarrow.schema(fields, metadata={"title": table.name, "units": units})
    return sealed(pyarrow.table(arrays, schema=schema))


def _arrow(values: Sequence[Any]) -> "pyarrow.Array":
    """A column from its memory: `pyarrow.array` loads pandas, which takes longer than a small study."""
    import pyarrow

    array = np.asarray(values)
    if array.dtype.kind == "U":
        texts = [text.encode() for text in values]
        ends = np.cumsum([0, *map(len, texts)], dtype=np.int32)
        return pyarrow.StringArray.from_buffers(
            len(texts), pyarrow.py_buffer(ends), pyarrow.py_buffer(b"".join(texts))
        )
    stored = np.packbits(array, bitorder="little") if array.dtype == bool else array
    kind = pyarrow.from_numpy_dtype(array.dtype)
    return pyarrow.Array.from_buffers(kind, len(array), [None, pyarrow.py_buffer(stored)])


def netcdf_bytes(table: Table) -> bytes:
    """A table as netCDF4, arrays over its axes with units as attributes, as `Table.to_xarray` has them.

    Without xarray, which loads Dask for it: that takes longer than a small study.
    """
    import h5netcdf

    outputs, keys = table.over_axes()
    arrays = outputs | keys
    beside = {name: axes for name, (axes, _, _) in keys.items() if axes != (name,)}
    memory = BytesIO()
    with h5netcdf.File(memory, "w") as file:
        file.attrs["title"] = table.name
        file.dimensions = {
            axis: length
            for axes, values, _ in arrays.values()
            for axis, length in zip(axes, values.shape, strict=True)
        }
        for name, (axes, values, attributes) in arrays.items():
            kind = TEXT if values.dtype.kind == "U" else values.dtype
            filled = np.nan if values.dtype.kind == "f" else None
            variable = file.create_variable(name, axes, kind, values.astype(kind), fillvalue=filled)
            variable.attrs.update(attributes)
            if name in outputs and (along := [key for key, own in beside.items() if set(own) <= set(axes)]):
                variable.attrs["coordinates"] = " ".join(along)
    return memory.getvalue()


FORMS: dict[str, tuple[Callable[[Table], bytes], tuple[str, ...]]] = {  # with the packages that they need
    ".csv": (csv_bytes, ()),
    ".parquet": (parquet_bytes, ("pyarrow",)),
    ".nc": (netcdf_bytes, ("h5netcdf",)),
}


def missing(suffix: str) -> list[str]:
    """Packages that a form of the table needs and that are not installed."""
    return [package for package in FORMS[suffix][1] if find_spec(package) is None]


# Behind the name of the study:
CYCLES = "_duty"  # in that of the table of lives under its duty cycle
SCATTER = ("_percentiles", "_shares", "_histogram")  # in those of what a sampled study says of its outputs
PICTURE, SCATTER_PICTURE = ".png", "_scatter.png"


def paths(folder: Path, name: str) -> dict[str, Path]:
    """Files of a table by their suffixes, in every form that can be written."""
    return {suffix: folder / f"{name}{suffix}" for suffix in FORMS if not missing(suffix)}


def store(table: Table, folder: Path) -> None:
    """Write a table, and that of its lives under a duty cycle, in every form.

    Raises `NotStored` if there is no room for a file.
    """
    for each in filter(None, (table, table.cycles)):
        for suffix, path in paths(folder, each.name).items():
            write(path.resolve(), FORMS[suffix][0](each))
