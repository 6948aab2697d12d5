"""Tables of a study, CSV and Parquet, given to `report` and `export`."""

import csv
from collections.abc import Callable
from io import BytesIO, StringIO
from random import Random
from typing import Any

from benchmarks.changed.bases import Bases
from benchmarks.changed.changes import cells, damaged, flipped, in_file
from benchmarks.changed.files import Bundle, Change, ChangedFiles
from benchmarks.changed.texts import ABSURD, DIGITS, FORMULA
from flexbearing.report.html.parquet import sealed

HEADINGS = ("", "x", "life [h]", "life [", "life [parsec]", "status", "message", "seconds", FORMULA,
"\x1b[31m", "a\nb",
            "<script>alert(1)</script>", DIGITS, "$x^2$", "\u202e", "operation.radial_load [N]",
            "é [µm]")  # fmt: skip


def table_of_study(rng: Random, bases: Bases) -> ChangedFiles:
    """A report, or an export, of a table one of whose files has changed: rows, lives of cycles, scatter."""
    study, ending = rng.choice(("study", "drawn")), rng.choice((".csv", ".parquet"))
    files = {
        name: _content(name, data)
        for name, data in bases.files.items()
        if name.startswith(study) and name.endswith(ending)
    }
    words = ("report", f"{study}{ending}", "-o", "r.html")
    if rng.random() < 0.15:
        words = ("export", f"{study}{ending}", "--to", "ross")
    changed = rng.choice([f"{study}{ending}", *sorted(files)])
    change = _csv if ending == ".csv" else _parquet
    changes = tuple(change(rng, changed, files[changed]) for _ in range(rng.choice((1, 1, 2))))
    return ChangedFiles("table", " ".join(words), Bundle(words, files), changes)


def _content(name: str, content: bytes):
    return [*csv.reader(StringIO(content.decode()))] if name.endswith(".csv") else content


def _csv(rng: Random, name: str, rows: Any) -> Change:
    if rng.random() < 0.3:
        return damaged(rng, name)
    if rng.random() < 0.3:
        heading, column = rng.choice(HEADINGS), rng.randrange(len(rows[0]))
        return in_file(
            f"heading {column} is {heading[:40]!r}", name,
            lambda rows: [_headed(rows[0], column, heading), *rows[1:]] if rows else rows, list,
        )  # fmt: skip
    return cells(rng, name, rows)


def _headed(line: list[str], column: int, heading: str) -> list[str]:
    return [heading if k == column else each for k, each in enumerate(line)]


def _parquet(rng: Random, name: str, whole: Any) -> Change:
    if rng.random() < 0.35:
        return flipped(rng, name)
    seed, what = rng.getrandbits(32), rng.choice([*WAYS])
    return in_file(f"{what} (seed {seed})", name, lambda _: lambda: _written(whole, what, Random(seed)))


def _written(whole: bytes, what: str, rng: Random) -> bytes:
    """Another table as Parquet."""
    from pyarrow import parquet

    return sealed(WAYS[what](parquet.read_table(BytesIO(whole), use_threads=False), rng))


def _column(table: Any, rng: Random, values: list[Any], kind: Any = None) -> Any:
    """A column of a table with other values."""
    import pyarrow

    place = rng.randrange(table.num_columns)
    column = pyarrow.array([*values * table.num_rows][: table.num_rows], kind)
    return table.set_column(place, table.column_names[place], column)


def _typed(table: Any, rng: Random) -> Any:
    import pyarrow

    values, kind = rng.choice((
        ([[1.0, 2.0]], None), ([{"a": 1, "b": [1]}], None), ([[[1]]], None), ([b"\xff\x00"], None), ([None],
        None), ([10**18], None), ([2**63], pyarrow.uint64()), ([True], None), ([0], pyarrow.timestamp("ns")),
        ([-(2**50)], pyarrow.timestamp("s")), ([0], pyarrow.duration("s")), ([1.0], pyarrow.float16()),
        (["a"], pyarrow.large_string()), (["a", "b"], pyarrow.dictionary(pyarrow.int8(), pyarrow.string())),
        ([3], pyarrow.decimal256(70, 2)), ([3], pyarrow.date32()), ([0], pyarrow.time64("ns")),
        ([[("a", 1)]], pyarrow.map_(pyarrow.string(), pyarrow.int8())), ([float("nan")], None),
        ([float("inf")], None), ([1e308], None), ([-1e308, 1e308], None), ([5e-324], None), (["converged"],
        None), ([DIGITS], None), ([rng.choice(ABSURD[:-1]).encode(errors="replace").decode()], None),
        ([FORMULA], None), (["<script>"], None),
    ))  # fmt: skip
    return _column(table, rng, values, kind)


def _renamed(table: Any, rng: Random) -> Any:
    names = [*table.column_names]
    names[rng.randrange(len(names))] = rng.choice(HEADINGS)
    return table.rename_columns(names)


def _long(table: Any, rng: Random) -> Any:
    """Hundreds of thousands of rows."""
    return table.take([k % table.num_rows for k in range(rng.choice((5000, 400_000)))])


def _wide(table: Any, rng: Random) -> Any:
    for number in range(rng.choice((100, 1500))):
        table = table.append_column(f"x{number} [mm]", table.column(number % 3))
    return table


def _noted(table: Any, rng: Random) -> Any:
    units = rng.choice(
        ("", "{", "[]", "null", '{"life [h]": 3}', '{"life [h]": "parsec"}', 900 * "[", DIGITS, "\xff")
    )
    return table.replace_schema_metadata({"title": rng.choice(ABSURD[:40]), "units": units})


def _twice(table: Any, rng: Random) -> Any:
    place = rng.randrange(table.num_columns)
    return table.append_column(table.column_names[place], table.column(place))


WAYS: dict[str, Callable[[Any, Random], Any]] = {
    "a column of another type": _typed,
    "another heading": _renamed,
    "no rows": lambda table, rng: table.slice(0, 0),
    "one row": lambda table, rng: table.slice(0, 1),
    "no columns": lambda table, rng: table.select([]),
    "a column less": lambda table, rng: table.remove_column(rng.randrange(table.num_columns)),
    "a column twice": _twice,
    "many rows": _long,
    "many columns": _wide,
    "other notes": _noted,
}
