"""Rows as they are finished, in a file that is only appended to: a study goes on from there.

Each line is a JSON object that begins with the checksum of the rest. One that holds something else than a row
is left out with a warning, its variants are computed again; so are those of a last line that a kill or a full
disk tore, without a word, and the next writer removes it.
"""

import json
import logging
import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from io import FileIO
from itertools import count
from math import isfinite, isnan, nan
from pathlib import Path
from typing import Any, TypeGuard
from zlib import crc32

from flexbearing import inputs
from flexbearing.files import NotStored, lock
from flexbearing.findings.row import read as read_findings, written
from flexbearing.studies.plan import Row
from flexbearing.studies.plan.task import Call, names as names_of

SUFFIX = ".journal.jsonl"
LONGEST_LINE = 2**24  # bytes: a row with the slopes of a thousand outputs by a hundred keys has a tenth of it
LONGEST_TEXT, LONGEST_STATUS = 10_000, 60  # characters
LARGEST_NUMBER = sys.float_info.max
SHOWN = 5  # numbers of damaged lines
_HALF = re.compile("[\ud800-\udfff]")
_NOTHING: dict[str, Any] = {"names": None}  # in place of a damaged line
log = logging.getLogger(__name__)
_HEAD = '{"crc": "%08x", '
_BEGINNING = len(_HEAD % 0)


def read(path: Path) -> dict[str, Row]:
    """Rows of a journal by their identities, the last one of each."""
    rows: dict[str, Row] = {}
    names, of, damaged = list[str](), "", list[int]()
    for number, entry in _entries(path):
        try:
            if "names" in entry:
                names = _texts(entry["names"])
                of = _of(names)
            elif of and entry.get("of") == of:  # else the line with its names was lost, or a task began
                row = _row(entry, names)
                rows[row.identity] = row
        except _Damaged:
            damaged.append(number)
    _warn(path, damaged)
    return rows


def begun(path: Path) -> frozenset[str]:
    """Variants, or the ring, at which a process of one job was at work when it ended without a word."""
    names = frozenset[str]()
    for _, entry in _entries(path):
        with suppress(_Damaged):  # which `read` reports
            if "begun" in entry:
                names = frozenset(_texts(entry["begun"]))
            elif "identity" in entry:
                names -= {_text(entry["identity"])}
    return names


class Journal:
    """The writer of a journal."""

    def __init__(self, file: FileIO, path: Path, names: Sequence[str], after: bytes = b""):
        self._file, self._path, self._at_work = file, path, False
        self._names, self._of = names, _of(names)
        self._write(after + _line({"names": [*names]}))

    def add(self, rows: Iterable[Row]) -> None:
        """Append rows; they outlive this process; raises `NotStored` if there is no room for them."""
        self._write(b"".join(_line(_entry(row, self._names, self._of)) for row in rows))

    def begins(self, call: Call) -> None:
        """Note what this process is at work at from now on, for `begun`.

        Raises `NotStored` if there is no room for it.
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

    Raises `BadOutput` if another process writes it; `NotStored` if there is no room for it.
    """
    with lock(path), FileIO(path, "ab+") as file:
        kept = Journal(file, path, names, after=_mended(file))
        try:
            yield kept
        finally:
            with suppress(NotStored):  # then the same calls are only made more carefully
                kept.ends()
        os.fsync(file.fileno())


def _mended(file: FileIO) -> bytes:
    """Remove a torn last line; what has to stand before the next one where it is longer than any line."""
    size = file.seek(0, os.SEEK_END)
    end = os.pread(file.fileno(), LONGEST_LINE, max(0, size - LONGEST_LINE))
    torn = len(end) - end.rfind(b"\n") - 1
    if torn == LONGEST_LINE:
        return b"\n"
    file.truncate(size - torn)
    return b""


class _Damaged(ValueError):
    """A line that holds something else than what is written here."""


def _entries(path: Path) -> Iterator[tuple[int, dict[str, Any]]]:
    """Numbers and content of all lines; a damaged one is an entry whose names are none."""
    if not path.exists():
        return
    with inputs.opened(path) as file:
        for number in count(1):
            line = file.readline(LONGEST_LINE)
            if not line.endswith(b"\n") and len(line) < LONGEST_LINE:  # the end, or torn
                return
            yield number, _entry_of(line.rstrip(b"\n"))


def _entry_of(text: bytes) -> dict[str, Any]:
    rest = b"{" + text[_BEGINNING:]
    if text[:_BEGINNING] != (_HEAD % crc32(rest)).encode():
        return _NOTHING
    try:
        found = json.loads(rest)
    except (ValueError, RecursionError):  # no text, no JSON, or integers without end
        return _NOTHING
    return found if isinstance(found, dict) else _NOTHING


def _warn(path: Path, damaged: Sequence[int]) -> None:
    """Report lines that were left out, the first of them by number."""
    if damaged:
        words = "line {} is" if len(damaged) == 1 else "lines {} are"
        more = f" and {len(damaged) - SHOWN} more" if len(damaged) > SHOWN else ""
        numbers = ", ".join(map(str, damaged[:SHOWN])) + more
        log.warning("%s: %s damaged and left out", path, words.format(numbers))


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
        "findings": written(row.findings),
        **({"own_run": row.own_run} if row.own_run else {}),
    }


def _of(names: Sequence[str]) -> str:
    """A short digest of names, by which a row says which ones its values have."""
    return f"{crc32(json.dumps([*names]).encode()):08x}"


def _stored(value: float | None) -> float | str | None:
    """A number as JSON can hold it; None where there is none."""
    if value is None or isnan(value):
        return None
    return value if isfinite(value) else str(value)


def _row(entry: Mapping[str, Any], names: Sequence[str]) -> Row:
    """A row whose parts all have the types in which they are written."""
    values, seconds = entry.get("values"), entry.get("seconds")
    if not isinstance(values, list) or len(values) != len(names) or not _is_number(seconds):
        raise _Damaged
    numbers = dict(zip(names, map(_number, values), strict=True))
    identity, status, message = (_text(entry.get(name)) for name in ("identity", "status", "message"))
    if not status.isprintable() or len(status) > LONGEST_STATUS:
        raise _Damaged
    try:
        findings = read_findings(_text(entry.get("findings")))
    except ValueError:
        raise _Damaged from None
    own_run = _text(entry.get("own_run", ""))
    return Row(identity, status, message, float(seconds), numbers, findings, own_run)


def _number(stored: Any) -> float:
    """A number as `_stored` wrote it."""
    if stored is None:
        return nan
    if stored in ("inf", "-inf"):
        return float(stored)
    if not _is_number(stored):
        raise _Damaged
    return float(stored)


def _is_number(found: Any) -> TypeGuard[int | float]:
    return isinstance(found, int | float) and not isinstance(found, bool) and abs(found) <= LARGEST_NUMBER


def _texts(found: Any) -> list[str]:
    if not isinstance(found, list):
        raise _Damaged
    return [_text(each) for each in found]


def _text(found: Any) -> str:
    """A text that can be stored and shown; a JSON text may hold half a character."""
    if not isinstance(found, str) or len(found) > LONGEST_TEXT or _HALF.search(found):
        raise _Damaged
    return found
