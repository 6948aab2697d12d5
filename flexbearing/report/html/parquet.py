"""The table of a study in a Parquet file, as text of a CSV file."""

import re
from collections.abc import Callable, Sequence
from hashlib import sha256
from io import BytesIO, StringIO
from itertools import chain
from pathlib import Path
from typing import Any, TypeVar

from flexbearing import inputs
from flexbearing.files import as_csv
from flexbearing.files.csv_rows import as_cell
from flexbearing.inputs.file import TABLE
from flexbearing.printable import excerpt

MOST_ROWS, MOST_CELLS = 1_000_000, 20_000_000  # numbers and texts, those of lists among them
DIGEST, NO_DIGEST = "sha256", "0" * 64  # in the metadata: of the bytes of the file, with zeros in its place
_SEAL = re.compile(rb"\x06sha256\x18@([0-9a-f]{64})")  # name and value behind their lengths, in Thrift
LONGEST = 10_000  # bytes of a text
AT_ONCE = 1000  # rows
T = TypeVar("T")


def csv_text(place: Path, most: int | None = None) -> str:
    """Text of the CSV file with the same table; of its first batches alone where only some rows are needed.

    Raises `Unreadable` where the file cannot be read, is larger than any table of a study, or pyarrow is not
    installed.
    """
    return _read(place, lambda opened: _text(opened, most or MOST_ROWS))


def row_count(place: Path) -> int:
    """Rows of a table; raises as `csv_text` does."""
    return _read(place, lambda opened: opened.metadata.num_rows)


def texts(place: Path, names: Sequence[str]) -> list[list[str]]:
    """Some columns of texts, all rows, as the CSV file has them; raises as `csv_text` does."""

    def cells(opened: Any) -> list[list[str]]:
        table = opened.read(columns=[*names])
        columns = [table.column(name).chunks for name in names]
        for chunk in chain(*columns):
            _require_short(chunk)
        return [[as_cell(cell) or "" for chunk in chunks for cell in _cells(chunk)] for chunks in columns]

    return _read(place, cells)


def _read(place: Path, take: Callable[[Any], T]) -> T:
    """What is taken from a file that was examined, texts of which are packed."""
    try:
        import pyarrow
        from pyarrow.parquet import ParquetFile
    except ImportError:
        raise inputs.Unreadable(
            'reading Parquet needs pyarrow: pip install "flexbearing[studies]"', place
        ) from None
    stored = inputs.content(place, TABLE)
    _require_sealed(stored, place)
    content = pyarrow.BufferReader(stored)
    try:
        metadata = ParquetFile(content).metadata
        _require_size(metadata)
        packed = [metadata.schema.column(k).path for k in range(metadata.num_columns)]
        opened = ParquetFile(content, read_dictionary=packed)
        _require_types(opened.schema_arrow)
        return take(opened)
    except (pyarrow.ArrowException, OSError) as problem:
        raise inputs.Unreadable(
            f"is no Parquet file, or damaged: {excerpt(str(problem))}", place
        ) from problem


def sealed(table: Any) -> bytes:
    """A Parquet file with the digest of its bytes, as pyarrow may crash while it reads a damaged one."""
    from pyarrow.parquet import ParquetWriter

    file = BytesIO()
    with ParquetWriter(file, table.schema, compression="zstd") as writer:
        writer.write_table(table)
        writer.add_key_value_metadata({DIGEST: NO_DIGEST})
    content = file.getvalue()
    (seal,) = _SEAL.finditer(content)
    return content[: seal.start(1)] + _digest(content).encode() + content[seal.end(1) :]


def _require_sealed(content: bytes, place: Path) -> None:
    """Refuse what is not as `flexbearing study` wrote it, before pyarrow reads it."""
    seals = [*_SEAL.finditer(content)]
    if len(seals) != 1:
        words = (
            "has no digest of flexbearing study: take its CSV file, or run the study again, which writes both"
        )
        raise inputs.Unreadable(words, place)
    (seal,) = seals
    if seal[1].decode() != _digest(content[: seal.start(1)] + NO_DIGEST.encode() + content[seal.end(1) :]):
        raise inputs.Unreadable("is damaged: its bytes are others than its digest says", place)


def _digest(content: bytes) -> str:
    return sha256(content).hexdigest()


def _require_size(metadata: Any) -> None:
    """Refuse what is no table of a study before it is unpacked."""
    groups = [metadata.row_group(k) for k in range(metadata.num_row_groups)]
    cells = sum(group.column(k).num_values for group in groups for k in range(group.num_columns))
    unpacked = sum(group.total_byte_size for group in groups)
    if metadata.num_rows > MOST_ROWS or cells > MOST_CELLS or unpacked > TABLE:
        raise inputs.Unreadable(
            f"has {metadata.num_rows} rows, {cells} cells, {inputs.size(unpacked)} unpacked; a table of a "
            f"study has at most {MOST_ROWS} rows, {MOST_CELLS} cells, {inputs.size(TABLE)}"
        )


def _require_types(schema: Any) -> None:
    """Refuse columns of anything but numbers, texts and lists of them."""
    from pyarrow import types

    known = (types.is_floating, types.is_integer, types.is_boolean, types.is_dictionary, types.is_string)
    for field in schema:
        cells = field.type.value_type if types.is_list(field.type) else field.type
        if not any(of_type(cells) for of_type in known):
            raise inputs.Unreadable(f"{excerpt(field.name)}: a column of {field.type}, which no study writes")


def _text(opened: Any, most: int) -> str:
    """Rows as CSV, at least so many if there are more; texts come last, as one may be in a million cells."""
    inputs.require_different(opened.schema_arrow.names)
    file = StringIO(newline="")
    file.write(as_csv([opened.schema_arrow.names]))
    rows = 0
    for batch in opened.iter_batches(AT_ONCE):
        if rows >= most:
            break
        rows += batch.num_rows
        for column in batch.columns:
            _require_short(column)
        file.write(as_csv(zip(*map(_cells, batch.columns), strict=True)))
        if file.tell() > TABLE:
            raise inputs.Unreadable(f"is larger than {inputs.size(TABLE)} unpacked")
    return file.getvalue()


def _cells(column: Any) -> list[Any]:
    """Cells of a column, most of which are numbers, or the same few texts."""
    import pyarrow

    if pyarrow.types.is_floating(column.type):
        return column.to_numpy(zero_copy_only=False).tolist()  # NaN where there is none
    if pyarrow.types.is_dictionary(column.type):
        texts = [*column.dictionary.to_pylist(), None]
        return [texts[place] for place in column.indices.fill_null(-1).to_numpy().tolist()]
    return column.to_pylist()


def _require_short(column: Any) -> None:
    """Refuse a column with a text, or one in its lists, that no study writes; before rows share it."""
    import pyarrow
    from pyarrow import compute

    flat = column.flatten() if pyarrow.types.is_list(column.type) else column
    if not pyarrow.types.is_dictionary(flat.type):
        return
    if (compute.max(compute.binary_length(flat.dictionary)).as_py() or 0) > LONGEST:  # type: ignore[attr-defined]
        raise inputs.Unreadable(f"has a text of more than {LONGEST} bytes")
