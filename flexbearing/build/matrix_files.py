"""Stiffness matrices and meshes in files of CalculiX, Abaqus and Nastran."""

import re
from array import array
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache, wraps
from itertools import chain
from pathlib import Path
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fem import ImpossiblePart
from fem.matrix.stiffness import Stiffness, symmetric
from flexbearing import inputs
from flexbearing.inputs import Unreadable
from flexbearing.inputs.file import MATRIX
from flexbearing.printable import enumerated, excerpt

MOST_FIELDS = 2**22  # of a card; a million numbers in a column of a matrix
HIGHEST = 10**9  # number of a node
COMPONENTS = 6
LONGEST_NAME = 8  # characters of the name of a matrix
_NODE = re.compile(r"\*NODE\s*(,.*)?", re.I)
_ANOTHER_SYSTEM = re.compile(r",\s*SYSTEM\s*=\s*[CS]\b", re.I)

Content = TypeVar("Content")


def cards(lines: Iterable[str], wanted: str) -> Iterator[list[str]]:
    """Fields of every card of a name, without the name.

    Raises `Unreadable` for a card with more than `MOST_FIELDS`.
    """
    fields: list[str] = []
    for line in chain(lines, [wanted]):
        text = line.partition("$")[0].rstrip()
        head = text.split(",", 1)[0][:8].strip().upper() if text else ""
        if text and fields and (head in ("", "*") or head[0] in "+*"):
            fields += _fields(text)
            if len(fields) > MOST_FIELDS:
                raise Unreadable(f"has a card {wanted} with more than {MOST_FIELDS} fields")
            continue
        if fields:
            yield fields
        fields = _fields(text) if head.rstrip("*") == wanted and text != wanted else []


def _fields(text: str) -> list[str]:
    """Fields of a line behind its name: four of 16 characters behind a star, else eight of 8."""
    large = "*" in text.split(",", 1)[0][:8]
    count = 4 if large else 8
    if "," in text:
        words = text.split(",")[1:]
    else:
        size = 64 // count
        fixed = text.expandtabs()
        words = [fixed[8 + size * k : 8 + size * (k + 1)] for k in range(count)]
    return [word.strip() for word in [*words, *[""] * count][:count]]


def _named(read: Callable[[Path], Content]) -> Callable[[Path], Content]:
    """Begin what is wrong with a file with its name."""

    @wraps(read)
    def reader(path: Path) -> Content:
        try:
            return read(path)
        except inputs.Unreadable as problem:
            raise ImpossiblePart(f"{excerpt((problem.path or path).name)}: {problem}") from problem
        except (inputs.BadNumber, ImpossiblePart) as problem:
            raise ImpossiblePart(f"{excerpt(path.name)}: {problem}") from problem

    return reader


@_named
def stiffness(path: Path) -> Stiffness:
    """Read a stiffness matrix; the ending of its name says of which program it is.

    Raises `ImpossiblePart` if the file cannot be read, or holds no symmetric real matrix.
    """
    readers: dict[str, Callable[[Path], Stiffness]] = {".sti": _calculix, ".mtx": _abaqus}
    readers |= dict.fromkeys((".bdf", ".dat", ".pch", ".dmig"), _nastran)
    reader = readers.get(path.suffix.lower())
    if reader is None:
        raise ImpossiblePart(f"a matrix has the ending {', '.join(readers)}")
    return reader(path)


@_named
def places(path: Path) -> tuple[NDArray, NDArray]:
    """Read the nodes of a mesh.

    Raises `ImpossiblePart` if the file cannot be read, holds no nodes, or one at two places.
    """
    numbers, where = array("q"), array("d")
    for nodes in (_grids, _nodes):
        for number, place in nodes(inputs.lines(path, MATRIX)):
            numbers.append(number)
            where.extend(place)
        if numbers:
            break
    else:
        raise ImpossiblePart("holds no nodes: neither *NODE nor GRID")
    found, (there, first, again) = np.array(where).reshape(-1, 3), _unique(np.array(numbers))
    if (moved := (found != found[first[again]]).any(axis=1)).any():
        raise ImpossiblePart(f"node {numbers[int(np.argmax(moved))]} stands at two places")
    return there, found[first]


def _unique(numbers: ArrayLike) -> tuple[NDArray, NDArray, NDArray]:
    return np.unique(numbers, return_index=True, return_inverse=True)


def _table(path: Path, columns: int) -> tuple[NDArray, NDArray]:
    """Whole numbers (rows, columns) and the number behind them (rows,); comments begin with a star."""
    whole, values = array("q"), array("d")
    for line in inputs.lines(path, MATRIX):
        words = line.replace(",", " ").split()
        if not words or words[0].startswith("*"):
            continue
        if len(words) != columns + 1:
            raise ImpossiblePart(f"a row holds {len(words)} numbers, not {columns + 1}: {excerpt(line)!r}")
        whole.extend(_node(word) for word in words[:-1])
        values.append(inputs.number(words[-1]))
    if not values:
        raise ImpossiblePart(f"holds no rows of {columns + 1} numbers")
    return np.array(whole).reshape(-1, columns), np.array(values)


@lru_cache(maxsize=2**16)  # every entry of a row names the same node
def _node(word: str) -> int:
    """Number of a node or of one of its motions; those that a program adds may be negative."""
    return inputs.whole(word, -HIGHEST, HIGHEST)


def _calculix(path: Path) -> Stiffness:
    """Matrix storage: row, column, value from 1, and node.motion of every row in a file of its own."""
    unknowns = _unknowns(path.with_suffix(".dof"))
    pairs, values = _table(path, 2)
    if pairs.min() < 1 or pairs.max() > len(unknowns):
        raise ImpossiblePart(f"has rows that {excerpt(path.stem)}.dof does not name")
    (nodes, motions), (rows, columns) = unknowns.T, pairs.T - 1
    return symmetric(nodes, motions, rows, columns, values)


@_named
def _unknowns(path: Path) -> NDArray:
    """Node and motion (n, 2) of every row."""
    unknowns = array("q")
    for line in inputs.lines(path, MATRIX):
        node, dot, motion = line.strip().partition(".")
        if node and not dot:
            raise ImpossiblePart(f"a line is no node.motion: {excerpt(node)!r}")
        if dot:
            unknowns.extend((_node(node), inputs.whole(motion, 1, COMPONENTS)))
    found = np.array(unknowns).reshape(-1, 2)
    if len(np.unique(found, axis=0)) < len(found):
        raise ImpossiblePart("names a motion of a node twice")
    return found


def _abaqus(path: Path) -> Stiffness:
    """Matrix text: row node, row motion, column node, column motion, value."""
    return _by_pairs(*_table(path, 4))


def _nastran(path: Path) -> Stiffness:
    """DMIG: a column of the matrix in every card after the header."""
    pairs, values, names = array("q"), array("d"), set[str]()
    for fields in cards(inputs.lines(path, MATRIX), "DMIG"):
        names.add(fields[0].upper())
        if fields[1] == "0":
            _require_real(fields)
            continue
        column = _node(fields[1]), _node(fields[2])
        for k in range(4, len(fields) - 2, 4):
            if fields[k]:
                pairs.extend((_node(fields[k]), _node(fields[k + 1]), *column))
                values.append(inputs.number(fields[k + 2]))
    if len(names) != 1:
        quoted = [excerpt(name, LONGEST_NAME) for name in sorted(names)]
        found = f"{len(names)} matrices, {enumerated(quoted)}" if names else "no DMIG"
        raise ImpossiblePart(f"holds {found}; allowed is one")
    if not values:
        raise ImpossiblePart(f"its matrix {excerpt(names.pop())} has no entries")
    return _by_pairs(np.array(pairs).reshape(-1, 4), np.array(values))


def _require_real(fields: list[str]) -> None:
    form, kind = (inputs.whole(field, 0, 9) for field in fields[2:4])
    if form not in (1, 6) or kind not in (1, 2):
        raise ImpossiblePart(
            f"DMIG {excerpt(fields[0])} has form {form} and type {kind}; allowed are a square or "
            "symmetric matrix, 1 or 6, of real numbers, 1 or 2"
        )


def _by_pairs(pairs: NDArray, values: NDArray) -> Stiffness:
    """Stiffness of entries by (row node, row motion, column node, column motion)."""
    coded = np.concatenate([pairs[:, :2], pairs[:, 2:]])
    if coded[:, 1].min() < 1 or coded[:, 1].max() > COMPONENTS:
        raise ImpossiblePart(f"a motion of a node is none of 1 to {COMPONENTS}")
    unknowns, _, where = _unique(coded[:, 0] * (COMPONENTS + 1) + coded[:, 1])
    rows, columns = np.split(where.ravel(), 2)
    return symmetric(unknowns // (COMPONENTS + 1), unknowns % (COMPONENTS + 1), rows, columns, values)


def _nodes(lines: Iterator[str]) -> Iterator[tuple[int, list[float]]]:
    """Nodes of every block *NODE."""
    inside = False
    for line in lines:
        if line.startswith("*"):
            inside = (inside and line.startswith("**")) or _NODE.fullmatch(line.rstrip()) is not None
            if inside and _ANOTHER_SYSTEM.search(line):
                raise ImpossiblePart(f"{excerpt(line.strip())}: allowed are rectangular coordinates")
        elif inside and line.strip():
            number, *rest = line.split(",")
            yield inputs.whole(number, 1, HIGHEST), _place(rest)


def _grids(lines: Iterator[str]) -> Iterator[tuple[int, list[float]]]:
    """Nodes of every card GRID."""
    for fields in cards(lines, "GRID"):
        padded = [*fields, *[""] * 8]
        for name, frame in (("CP", padded[1]), ("CD", padded[5])):  # a DMIG has its motions along CD
            if frame not in ("", "0"):
                raise ImpossiblePart(
                    f"GRID {excerpt(padded[0])} has {name} = {excerpt(frame)}; allowed is 0, the basic system"
                )
        yield inputs.whole(padded[0], 1, HIGHEST), _place(padded[2:5])


def _place(words: list[str]) -> list[float]:
    """Coordinates of a node; those that are left out are zero."""
    return [inputs.number(word) if word.strip() else 0.0 for word in (*words, "", "", "")[:3]]
