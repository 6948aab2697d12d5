"""The table as Parquet, units in the metadata of its fields."""

import json
from io import BytesIO

import pyarrow
from pyarrow import parquet

from flexbearing.studies.table.table import Table


def parquet_bytes(table: Table) -> bytes:
    """Write a table as Parquet.

    Parameters
    ----------
    table : Table
        whatever it holds

    Returns
    -------
    bytes
        of a file whose fields are called as the headings; each has its unit as metadata, and the metadata of
        the file hold all of them as JSON, "units"
    """
    arrays = [pyarrow.array(column.values) for column in table.columns]
    fields = [
        pyarrow.field(column.heading, array.type, metadata={"unit": column.unit})
        for column, array in zip(table.columns, arrays, strict=True)
    ]
    units = json.dumps({column.heading: column.unit for column in table.columns if column.unit})
    schema = pyarrow.schema(fields, metadata={"title": table.name, "units": units})
    file = BytesIO()
    parquet.write_table(pyarrow.table(arrays, schema=schema), file, compression="zstd")
    return file.getvalue()
