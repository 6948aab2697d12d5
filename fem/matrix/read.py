"""Matrix files of CalculiX, Abaqus and Nastran, with the nodes of their meshes."""

import re
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from fem.matrix.stiffness import Stiffness, symmetric
from fem.parts.material import ImpossiblePart

LARGEST = 2_000_000_000  # bytes of a file
COMPONENTS = 6
_NUMBER = re.compile(r"([+-]?[0-9]*\.?[0-9]+\.?|[+-]?[0-9]+\.[0-9]*)(?:[DdEe]?([+-][0-9]+)|[DdEe]([0-9]+))?")


def stiffness(path: Path) -> Stiffness:
    """Read a stiffness matrix; the ending of its name tells the program.

    Parameters
    ----------
    path : Path
        ``.sti`` of CalculiX, with its ``.dof`` beside it; ``.mtx`` of Abaqus, matrix text; ``.bdf``,
        ``.dat``, ``.pch`` or ``.dmig`` of Nastran, DMIG

    Returns
    -------
    Stiffness
        in the units of the file

    Raises
    ------
    ImpossiblePart
        if the file cannot be read, or holds no symmetric real matrix
    """
    readers: dict[str, Callable[[Path], Stiffness]] = {".sti": _calculix, ".mtx": _abaqus}
    readers |= dict.fromkeys((".bdf", ".dat", ".pch", ".dmig"), _nastran)
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ImpossiblePart(f"{path.name}: a matrix has the ending {', '.join(readers)}")
    return reader(path)


def places(path: Path) -> dict[int, NDArray]:
    """Read the nodes of a mesh.

    Parameters
    ----------
    path : Path
        input file with ``*NODE`` (CalculiX, Abaqus) or ``GRID`` (Nastran) in the basic system, CP and CD 0

    Returns
    -------
    dict
        number to x, y, z in the units of the file

    Raises
    ------
    ImpossiblePart
        if the file cannot be read or holds no nodes
    """
    lines = _lines(path)
    try:
        found = dict(_grids(lines)) or dict(_nodes(lines))
    except ValueError as problem:
        raise ImpossiblePart(f"{path.name}: a node cannot be read: {problem}") from problem
    if not found:
        raise ImpossiblePart(f"{path.name}: holds no nodes: neither *NODE nor GRID")
    return found


def _lines(path: Path) -> list[str]:
    try:
        if path.stat().st_size > LARGEST:
            raise ImpossiblePart(f"{path.name}: has more than {LARGEST // 10**9} GB")
        return path.read_text(encoding="latin-1").splitlines()
    except OSError as problem:
        raise ImpossiblePart(f"{path.name}: cannot be read: {problem.strerror}") from problem


def _table(path: Path, columns: int) -> NDArray:
    """Rows of numbers, separated by commas or blanks; comments begin with **."""
    rows = [
        line.replace(",", " ").split() for line in _lines(path) if line.strip() and line.lstrip()[0] != "*"
    ]
    try:
        table = np.array([[float(word.replace("D", "E")) for word in row[:columns]] for row in rows])
    except ValueError as problem:
        raise ImpossiblePart(f"{path.name}: a row holds no {columns} numbers: {problem}") from problem
    if table.ndim != 2 or table.shape[1] != columns:
        raise ImpossiblePart(f"{path.name}: its rows do not hold {columns} numbers each")
    return table


def _calculix(path: Path) -> Stiffness:
    """Matrix storage: row, column, value from 1, and node.motion of every row in the file beside it."""
    unknowns = [line.strip().partition(".") for line in _lines(path.with_suffix(".dof")) if line.strip()]
    try:
        nodes, motions = (np.array([int(each[k]) for each in unknowns]) for k in (0, 2))
    except ValueError as problem:
        raise ImpossiblePart(f"{path.stem}.dof: a line is no node.motion: {problem}") from problem
    table = _table(path, 3)
    rows, columns = (table[:, k].astype(int) - 1 for k in (0, 1))
    if min(rows.min(), columns.min()) < 0 or max(rows.max(), columns.max()) >= len(nodes):
        raise ImpossiblePart(f"{path.name}: has rows that {path.stem}.dof does not name")
    return symmetric(nodes, motions, rows, columns, table[:, 2])


def _abaqus(path: Path) -> Stiffness:
    """Matrix text: row node, row motion, column node, column motion, value."""
    table = _table(path, 5)
    return _by_pairs(table[:, :4].astype(int), table[:, 4])


def _nastran(path: Path) -> Stiffness:
    """DMIG: a column of the matrix in every card after the header."""
    entries: list[tuple[int, int, int, int]] = []
    values: list[float] = []
    names: set[str] = set()
    try:
        for fields in _cards(_lines(path), "DMIG"):
            names.add(fields[0].upper())
            if fields[1] == "0":
                _require_real(path, fields)
                continue
            column = int(fields[1]), int(fields[2])
            for k in range(4, len(fields) - 2, 4):
                if fields[k]:
                    entries.append((int(fields[k]), int(fields[k + 1]), *column))
                    values.append(_number(fields[k + 2]))
    except (ValueError, IndexError) as problem:
        raise ImpossiblePart(f"{path.name}: a card DMIG cannot be read: {problem}") from problem
    if len(names) != 1:
        told = f"{len(names)} matrices, {', '.join(sorted(names))}" if names else "no DMIG"
        raise ImpossiblePart(f"{path.name}: holds {told}; allowed is one")
    if not entries:
        raise ImpossiblePart(f"{path.name}: its matrix {names.pop()} has no entries")
    return _by_pairs(np.array(entries), np.array(values))


def _require_real(path: Path, fields: list[str]) -> None:
    form, kind = int(fields[2]), int(fields[3])
    if form not in (1, 6) or kind not in (1, 2):
        raise ImpossiblePart(
            f"{path.name}: DMIG {fields[0]} has form {form} and type {kind}; allowed are a square or "
            "symmetric matrix, 1 or 6, of real numbers, 1 or 2"
        )


def _by_pairs(pairs: NDArray, values: NDArray) -> Stiffness:
    """Stiffness of entries by (row node, row motion, column node, column motion)."""
    coded = np.concatenate([pairs[:, :2], pairs[:, 2:]])
    if coded[:, 1].min() < 1 or coded[:, 1].max() > COMPONENTS:
        raise ImpossiblePart(f"a motion of a node is none of 1 to {COMPONENTS}")
    unknowns, where = np.unique(coded[:, 0] * (COMPONENTS + 1) + coded[:, 1], return_inverse=True)
    rows, columns = np.split(where.ravel(), 2)
    return symmetric(unknowns // (COMPONENTS + 1), unknowns % (COMPONENTS + 1), rows, columns, values)


def _nodes(lines: list[str]) -> Iterator[tuple[int, NDArray]]:
    """Nodes of every block *NODE."""
    inside = False
    for line in lines:
        if line.startswith("*"):
            inside = (inside and line.startswith("**")) or re.match(r"\*NODE\s*(,|$)", line, re.I) is not None
        elif inside and line.strip():
            number, *rest = line.split(",")
            yield (
                int(number),
                np.array([float(word) if word.strip() else 0.0 for word in (*rest, "", "", "")[:3]]),
            )


def _grids(lines: list[str]) -> Iterator[tuple[int, NDArray]]:
    """Nodes of every card GRID."""
    for fields in _cards(lines, "GRID"):
        padded = [*fields, *[""] * 8]
        for name, frame in (("CP", padded[1]), ("CD", padded[5])):  # a DMIG has its motions along CD
            if frame not in ("", "0"):
                raise ValueError(f"GRID {padded[0]} has {name} = {frame}; allowed is 0, the basic system")
        yield int(padded[0]), np.array([_number(word) if word else 0.0 for word in padded[2:5]])


def _cards(lines: list[str], wanted: str) -> Iterator[list[str]]:
    """Fields of every card of a name: free, small or large, with its continuations."""
    fields: list[str] = []
    for line in [*lines, wanted]:
        text = line.partition("$")[0].rstrip()
        head = text.split(",")[0][:8].strip().upper() if text else ""
        if text and fields and (head in ("", "*") or head[0] in "+*"):
            fields += _fields(text)
            continue
        if fields:
            yield fields
        fields = _fields(text) if head.rstrip("*") == wanted and text != wanted else []


def _fields(text: str) -> list[str]:
    """Fields of a line behind its name: four of 16 characters behind a star, else eight of 8."""
    large = "*" in text.split(",")[0][:8]
    count = 4 if large else 8
    if "," in text:
        words = text.split(",")[1:]
    else:
        size = 64 // count
        words = [text.expandtabs()[8 + size * k : 8 + size * (k + 1)] for k in range(count)]
    return [word.strip() for word in [*words, *[""] * count][:count]]


def _number(word: str) -> float:
    """A number of Nastran, also 1.5D+06 and 1.5+6."""
    parts = _NUMBER.fullmatch(word)
    if parts is None:
        raise ValueError(f"{word[:40]!r} is no number")
    return float(f"{parts[1]}e{parts[2] or parts[3] or 0}")
