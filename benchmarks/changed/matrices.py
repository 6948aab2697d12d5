"""Stiffness matrices of other programs with their nodes, through a case that has one."""

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory

import numpy as np
from scipy import sparse

from benchmarks.changed.bases import Bases
from benchmarks.changed.changes import damaged, in_file
from benchmarks.changed.files import Bundle, Change, ChangedFiles, rendered
from benchmarks.changed.texts import DIGITS
from tests.mutated_cases import COARSE, based_on

SEAT = Path(__file__).parents[2] / "tests" / "flexbearing" / "seat"
FORMS = {"abaqus": ".mtx", "calculix": ".sti", "nastran": ".bdf"}
PLAIN = (
    "inner.kind=rigid", "outer.kind=matrix", "outer.centre_x=3 mm", "outer.width=12 mm",
    "outer.thickness=5 mm", "accuracy.mesh_size=8 mm", "accuracy.raceway_mesh_size=4 mm",
    "accuracy.element_order=2", *COARSE,
)  # fmt: skip
NUMBERS = (
    "nan", "inf", "-inf", "1e400", "1e308", "-1e308", "1e-320", "0", "-0", "-1", "1.5", "1.5D+03", "1.5+3",
    "1D400", "2147483648", "9223372036854775808", "1e20", DIGITS, "0." + DIGITS, "1e" + DIGITS, "１", "٣",
    "1_0", "0x1", "", "x", "1,5", "\x1b[31m", "'", "4", "7", "1e9", "1000000007", 20_000 * "1 ", 300 * "x",
)  # fmt: skip
LINES = (
    "*NODE", "*NODE, NSET=ALL", "*INCLUDE, INPUT=n.inp", "*INCLUDE, INPUT=/dev/zero",
    "*MATRIX INPUT, NAME=K", "GRID", "GRID,1,,1.,2.,3.", "GRID,1,7,1.,2.,3.", "GRID*", "*", "**", "+",
    "DMIG", "DMIG,KAAX,0,6,2,0", "DMIG,KAAX,0,6,4,0", "DMIG,OTHER,0,6,2,0", "DMIG,KAAX,1,1",
    "DMIG,KAAX,1,1,,2,1,nan", "1,1,1,1,1e30", "1 1 -1e30", "ENDDATA", "$", "", "\x00", "1.1", "1.1.1",
    "999999999.1", "1." + DIGITS, "-1.1", "1.9", "1, 1.0, 2.0, 3.0", "1, 1.0, 2.0, 3.0, " + 5000 * "4, ",
    60_000 * "x", "1.5, 1.0, 2.0, 3.0", "é", "-1, 1, 2, 3",
)  # fmt: skip


@cache
def files_of(form: str) -> dict[str, bytes]:
    """Matrix and nodes of the seat of the tests in the form of a program."""
    from tests.fem import written_matrices as write

    rows = _numbers(SEAT / "springs.mtx")
    nodes = _numbers(SEAT / "springs.inp")
    unknowns = np.unique(rows[:, :2].astype(int), axis=0)
    number = {tuple(each): k for k, each in enumerate(unknowns)}
    at = [[number[tuple(row)] for row in rows[:, k : k + 2].astype(int)] for k in (0, 2)]
    lower = sparse.coo_array((rows[:, 4], at), shape=(len(unknowns), len(unknowns)))
    matrix = sparse.csr_array(lower + sparse.tril(lower, -1).T)
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"k{FORMS[form]}"
        getattr(write, form)(path, unknowns, matrix)
        places = write.grid_bdf if form == "nastran" else write.nodes_inp
        places(Path(folder) / "n.inp", nodes[:, 1:], nodes[:, 0].astype(int))
        return {each.name: each.read_bytes() for each in Path(folder).iterdir()}


def _numbers(path: Path) -> np.ndarray:
    lines = [line for line in path.read_text().splitlines() if line[0] != "*"]
    return np.array([[float(word) for word in line.split(",")] for line in lines])


@cache
def case_of(form: str) -> dict:
    return based_on("mao2016", (*PLAIN, f"outer.matrix=k{FORMS[form]}", "outer.nodes=n.inp"))


def matrix(rng: Random, bases: Bases) -> ChangedFiles:
    """A case whose ring is on a body from files, mostly checked, at times run."""
    form = rng.choice([*FORMS])
    files = files_of(form)
    command = ("run", "case.toml", "-o", "out.h5") if rng.random() < 0.12 else ("check", "case.toml")
    bundle = Bundle(command, {"case.toml": case_of(form), **files})
    changes = tuple(_change(rng, rng.choice([*files])) for _ in range(rng.choice((1, 1, 2, 3))))
    return ChangedFiles("matrix", f"{form}, {command[0]}", bundle, changes)


def _change(rng: Random, name: str) -> Change:
    how = rng.choices((_number, _line, _whole, damaged, _missing), weights=(8, 4, 2, 2, 1))[0]
    return how(rng, name)


def _on_lines(what: str, name: str, change: Callable[[list[bytes]], list[bytes]]) -> Change:
    return in_file(what, name, lambda content: b"\n".join(change(rendered(content).split(b"\n"))))


def _number(rng: Random, name: str) -> Change:
    """Another number in a line, or in all lines in the same place."""
    share, place, text, every = rng.random(), rng.randrange(6), rng.choice(NUMBERS), rng.random() < 0.2

    def replaced(line: bytes) -> bytes:
        found = [*re.finditer(rb"[^\s,.*][^\s,]*|\.[0-9]+", line)]
        if not found:
            return line
        one = found[place % len(found)]
        return line[: one.start()] + text.encode() + line[one.end() :]

    def change(lines: list[bytes]) -> list[bytes]:
        chosen = range(len(lines)) if every else [int(share * len(lines))]
        return [replaced(line) if k in chosen else line for k, line in enumerate(lines)]

    where = "every line" if every else f"line {share:.4f}"
    return _on_lines(f"{where}, place {place} is {text[:30]!r} ({len(text)})", name, change)


def _line(rng: Random, name: str) -> Change:
    """A line more, in place of another, or twice."""
    share, text, times = rng.random(), rng.choice(LINES), rng.choice((0, 1, 1, 2, 3000))
    instead, twice = rng.random() < 0.3, rng.random() < 0.3

    def change(lines: list[bytes]) -> list[bytes]:
        k = int(share * len(lines))
        return [*lines[:k], *times * [lines[k] if twice else text.encode()], *lines[k + instead :]]

    told = "itself" if twice else f"{text[:40]!r} ({len(text)})"
    return _on_lines(f"{times} times {told} {'for' if instead else 'at'} line {share:.4f}", name, change)


def _whole(rng: Random, name: str) -> Change:
    """Everything in another way."""
    ways: dict[str, Callable[[bytes], bytes]] = {
        "empty": lambda content: b"",
        "zeros": lambda content: bytes(100_000),
        "carriage returns": lambda content: content.replace(b"\n", b"\r"),
        "no line ends": lambda content: content.replace(b"\n", b" "),
        "UTF-16": lambda content: content.decode("latin-1").encode("utf-16"),
        "in capitals": lambda content: content.upper(),
        "in small letters": lambda content: content.lower(),
        "minus": lambda content: content.replace(b" 1.", b"-1.").replace(b" 2.", b"-2."),
        "blanks for commas": lambda content: content.replace(b",", b" "),
        "ten times": lambda content: 10 * content,
        "numbers from 2e9": lambda content: re.sub(rb"(?m)^([0-9]+)", rb"200000\1", content),
        "first column is the second": lambda content: re.sub(rb"(?m)^([0-9]+),([0-9]+)", rb"\2,\1", content),
    }
    what = rng.choice([*ways])
    return in_file(what, name, lambda content: ways[what](rendered(content)))


def _missing(rng: Random, name: str) -> Change:
    def applied(bundle: Bundle) -> Bundle:
        return Bundle(
            bundle.words, {key: each for key, each in bundle.files.items() if key != name}, bundle.rewritten
        )

    return Change(f"no {name}", applied)
