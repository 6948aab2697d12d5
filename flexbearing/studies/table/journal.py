"""Rows as they are finished, in a file that is only ever appended to: a study goes on from there.

Each line is a JSON object that begins with the checksum of the rest. A line that a kill or a full disk
tore is left out when the file is read; its variants are computed again.
"""

import json
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from io import FileIO
from math import isfinite, isnan
from pathlib import Path
from typing import Any
from zlib import crc32

from flexbearing import inputs
from flexbearing.files import NotStored, lock
from flexbearing.studies.plan import Row
from flexbearing.studies.plan.task import Call, names as names_of

SUFFIX = ".journal.jsonl"
_HEAD = '{"crc": "%08x", '
_BEGINNING = len(_HEAD % 0)


def read(path: Path) -> dict[str, Row]:
    """Rows of a journal by their identities, the last one of each.

    Parameters
    ----------
    path : Path
        there or not

    Returns
    -------
    dict
        identity to row, whose values are those that were asked for when it was written, NaN where there was
        none
    """
    rows: dict[str, Row] = {}
    names, of = list[str](), ""
    for entry in _entries(path):
        if "names" in entry:
            names, of = entry["names"], _of(entry["names"])
        elif of and entry.get("of") == of:  # else the line with its names was lost, or a task began
            row = _row(entry, names)
            rows[row.identity] = row
    return rows


def begun(path: Path) -> frozenset[str]:
    """Variants, or the ring, at which a process of one job was at work when it ended without a word.

    Parameters
    ----------
    path : Path
        there or not

    Returns
    -------
    frozenset of str
        identities of variants without a row, or the name of a ring
    """
    names = frozenset[str]()
    for entry in _entries(path):
        if "begun" in entry:
            names = frozenset(entry["begun"])
        elif "identity" in entry:
            names -= {entry["identity"]}
    return names


class Journal:
    """The writer of a journal."""

    def __init__(self, file: FileIO, path: Path, names: Sequence[str], after: bytes = b""):
        self._file, self._path, self._at_work = file, path, False
        self._names, self._of = names, _of(names)
        self._write(after + _line({"names": [*names]}))

    def add(self, rows: Iterable[Row]) -> None:
        """Append rows; they outlive whatever ends this process.

        Raises
        ------
        NotStored
            if there is no room for them
        """
        self._write(b"".join(_line(_entry(row, self._names, self._of)) for row in rows))

    def begins(self, call: Call) -> None:
        """Note what this process is at work at from now on, for `begun`.

        Raises
        ------
        NotStored
            if there is no room for it
        """
        self._at_work = True
        self._write(_line({"begun": names_of(call)}))

    def ends(self) -> None:
        """Note that this process ends and no call ended it."""
        if self._at_work:
            self._write(_line({"begun": []}))

    def _write(self, lines: bytes) -> None:
        left = memoryview(lines)
        try:
            while left:
                left = left[self._file.write(left) :]
        except OSError as problem:
            raise NotStored(
                f"{self._path}: not written: {problem.strerror}. What is finished so far is in it; free "
                "space there and run the same study again: it goes on from there."
            ) from problem


@contextmanager
def opened(path: Path, names: Sequence[str]) -> Iterator[Journal]:
    """Open a journal for its only writer.

    Parameters
    ----------
    path : Path
        made when it is not there
    names : sequence of str
        names of the values in the rows that will be added

    Raises
    ------
    BadOutput
        if another process writes it
    NotStored
        if there is no room for it
    """
    with lock(path), FileIO(path, "ab+") as file:
        torn = file.seek(0, os.SEEK_END) and os.pread(file.fileno(), 1, file.tell() - 1) != b"\n"
        kept = Journal(file, path, names, after=b"\n" if torn else b"")
        try:
            yield kept
        finally:
            with suppress(NotStored):  # then the same calls are only made more carefully
                kept.ends()
        os.fsync(file.fileno())


def _entries(path: Path) -> Iterator[dict[str, Any]]:
    """Lines that are whole."""
    if not path.exists():
        return
    with inputs.opened(path) as file:
        for line in file:
            text = line.rstrip(b"\n")
            rest = b"{" + text[_BEGINNING:]
            if text[:_BEGINNING] == (_HEAD % crc32(rest)).encode():
                yield json.loads(rest)


def _line(entry: Mapping[str, Any]) -> bytes:
    rest = json.dumps(entry, allow_nan=False).encode()
    return (_HEAD % crc32(rest)).encode() + rest[1:] + b"\n"


def _entry(row: Row, names: Sequence[str], of: str) -> dict[str, Any]:
    return {
        "of": of,
        "identity": row.identity,
        "status": row.status,
        "message": row.message,
        "seconds": row.seconds,
        "values": [_stored(row.values.get(name)) for name in names],
    }


def _of(names: Sequence[str]) -> str:
    """A short digest of names, by which a row tells which ones its values have."""
    return f"{crc32(json.dumps([*names]).encode()):08x}"


def _stored(value: float | None) -> float | str | None:
    """A number as JSON can hold it; None where there is none."""
    if value is None or isnan(value):
        return None
    return value if isfinite(value) else str(value)


def _row(entry: Mapping[str, Any], names: Sequence[str]) -> Row:
    numbers = (float("nan") if value is None else float(value) for value in entry["values"])
    values = dict(zip(names, numbers, strict=True))
    return Row(entry["identity"], entry["status"], entry["message"], entry["seconds"], values)
