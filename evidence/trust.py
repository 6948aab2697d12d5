"""How far to trust each number: the largest misfit of the evidence by bearing and output, and its kind."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from evidence.case import Findings, Number
from evidence.markdown import cells, shown
from evidence.measured.page import Registered
from evidence.measured.verdict import verdict

Kind = Literal["measured", "program", "closed form"]


@dataclass(frozen=True)
class Compared:
    """Numbers of a page whose names a pattern is found in; all without a pattern."""

    kind: Kind
    page: str
    pattern: str = ""

    def numbers(self, findings: Mapping[str, Findings]) -> list[Number]:
        """Known numbers that are not zero, and those with a scale."""
        return [
            number
            for number in findings[self.page].numbers
            if (number.known or number.scale) and re.search(self.pattern, number.name)
        ]


@dataclass(frozen=True)
class Row:
    """An output of a family of bearings, what it was compared with, and measurements of it."""

    family: str
    output: str
    compared: tuple[Compared, ...]
    measured: tuple[str, ...] = ()


ROLLERS, FAST, SLOW, ALL = "rollers", "fast balls", "four-point", "all"
ROWS = (
    Row(
        ROLLERS,
        "load, rigid rings",
        (
            Compared("closed form", "sjovall-rollers"),
            Compared("closed form", "stribeck"),
            Compared("closed form", "harris-209", "load"),
            Compared("program", "mao-rigid", "load by|law|other program"),
            Compared("program", "iso16281-rollers", "largest load"),
        ),
        ("misalignment",),
    ),
    Row(
        ROLLERS,
        "load, elastic rings",
        (
            Compared("program", "mao-flexible", "^largest load"),
            Compared("closed form", "half-space-split"),
        ),
        ("planet-helical-couple", "planet-rim-load", "planet-rim-out-of-plane"),
    ),
    Row(
        ROLLERS,
        "life",
        (
            Compared("closed form", "iso281-annex-c"),
            Compared("closed form", "ntn-catalogue", "life"),
            Compared("closed form", "life-of-slices"),
            Compared("program", "iso16281-rollers", "life"),
        ),
    ),
    Row(
        ROLLERS,
        "cage slip",
        (
            Compared("closed form", "cage-slip", "slip"),
            Compared("program", "mao-flexible", "^cage slip"),
        ),
        ("slip-of-cage", "slip-of-unloaded-rollers", "cage-states-ester", "cage-states-traction-fluid"),
    ),
    Row(
        ROLLERS,
        "radial stiffness",
        (Compared("closed form", "friswell"), Compared("program", "mao-rigid", "stiffness")),
    ),
    Row(ROLLERS, "tilting stiffness", (Compared("program", "tilt-of-slices"),)),
    Row(ROLLERS, "torque", ()),
    Row(ROLLERS, "peak pressure", (Compared("closed form", "whole-roller"),)),
    Row(
        FAST,
        "load, contact angle",
        (
            Compared("closed form", "sjovall-balls"),
            Compared("program", "harris-218"),
            Compared("program", "openjones", "load|angle"),
            Compared("program", "balls-calculix"),
        ),
    ),
    Row(
        FAST,
        "life",
        (
            Compared("program", "iso16281-balls", "life"),
            Compared("closed form", "nsk-catalogue", "life"),
        ),
    ),
    Row(FAST, "torque", (Compared("closed form", "rivera-torque"),)),
    Row(FAST, "stiffness", ()),
    Row(FAST, "cage slip", (), ("skid-120-mm", "skid-over-speed")),
    Row(
        SLOW,
        "load, strain",
        (),
        ("slewing-strain",),
    ),
    Row(SLOW, "motion of the balls", (Compared("program", "heras-motion"),)),
    Row(
        SLOW,
        "torque",
        (
            Compared("measured", "joshi-measured"),
            Compared("program", "joshi-four-point"),
            Compared("program", "heras-stick-slip"),
        ),
        ("torque-dip", "unloaded-torque"),
    ),
    Row(
        ALL,
        "films",
        (Compared("closed form", "film-formulas"), Compared("closed form", "line-contact", "film")),
    ),
    Row(
        ALL,
        "rolling friction of a contact",
        (Compared("closed form", "carter"), Compared("program", "contact-program")),
    ),
    Row(
        ALL,
        "deflection of rings",
        (
            Compared("closed form", "ring-pinched"),
            Compared("program", "ring-calculix"),
            Compared("program", "planet-rim"),
        ),
        ("ring-in-bending",),
    ),
    Row(
        ALL,
        "squirrel cage",
        (Compared("closed form", "cage-rigid-ring"),),
        ("squirrel-cage-and-bearing",),
    ),
    Row(ALL, "clearance by fits and heat", (Compared("closed form", "lame"),)),
)
MOST_ROWS = 25  # of one screen


def largest(row: Row, kind: Kind, findings: Mapping[str, Findings]) -> tuple[float, str] | None:
    """Largest misfit [-] of a kind, and its page."""
    sizes = [
        (abs(number.misfit), compared.page)
        for compared in row.compared
        if compared.kind == kind
        for number in compared.numbers(findings)
    ]
    return max(sizes, default=None)


def _misfit(found: tuple[float, str] | None) -> str:
    if found is None:
        return "none"
    size, name = found
    return f"[{'below 0.01' if size < 1e-4 else shown(100 * size, 2)} %]({name}.md)"


def _measured(row: Row, findings: Mapping[str, Findings], registered: Mapping[str, Registered]) -> str:
    """Misfit from what was measured, and verdicts of the measurements with a band."""
    number = largest(row, "measured", findings)
    bands = [f"[{verdict(*registered[name])}]({name}.md)" for name in row.measured if name in registered]
    return "; ".join([*([_misfit(number)] if number else []), *bands]) or "none"


HEAD = """<!-- written by python -m evidence; do not edit -->
# How far to trust each number

Largest misfit of the evidence, by bearing and output. A misfit from a closed form or another program says how
exactly the program solves its own equations, no more; only *measured* says how well they describe a bearing.
[What numerics and your inputs add](../howto/trust.md).

|bearing|output|measured|program, printed computation|closed form, standard|
|---|---|---|---|---|
"""


def page(
    findings: Mapping[str, Findings], registered: Mapping[str, Registered], rows: Sequence[Row] = ROWS
) -> str:
    """The table."""
    lines = [
        cells(
            row.family,
            row.output,
            _measured(row, findings, registered),
            *(_misfit(largest(row, kind, findings)) for kind in ("program", "closed form")),
        )
        for row in rows
    ]
    return HEAD + "\n".join(lines) + "\n"
