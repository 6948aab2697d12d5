"""Equilibria of a case over its load or speed, as a table and a picture."""

from collections.abc import Sequence
from contextlib import closing
from csv import writer
from dataclasses import dataclass
from functools import partial
from io import StringIO
from math import pi
from pathlib import Path

import numpy as np

from flexbearing.api import check, read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase, Head
from flexbearing.case.excerpt import excerpt
from flexbearing.case.roller import Case
from flexbearing.coupled.coupled import BearingPartner, equilibrium
from flexbearing.coupling import PartnerFailed, RacewayPair
from flexbearing.coupling.partners import Compliance
from flexbearing.files import require_output, write
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.progress import Logged
from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.rings.condensed import condensed_raceways
from flexbearing.runs import notes
from flexbearing.runs.run_case import stem_of_outputs
from flexbearing.studies.engine import DIED, completed
from flexbearing.studies.engine.apart import Apart
from flexbearing.studies.engine.serial import Serial
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.note import Note
from quasidynamic.trace import Branch, BranchEnd, logarithms, trace as follow

RPM = 2 * pi / 60


@dataclass(frozen=True)
class Axis:
    """A key that a case can be traced over."""

    name: str  # among the keys of [operation]
    column: str
    label: str
    unit: str
    size: float  # of the unit, in SI


AXES = {
    "operation.radial_load": Axis("radial_load", "radial_load_N", "radial load [N]", "N", 1.0),
    "operation.inner_speed": Axis("inner_speed", "inner_speed_rpm", "inner speed [rpm]", "rpm", RPM),
}


@dataclass(frozen=True)
class Range:
    """Where a branch begins and over what it is followed."""

    case: Case
    axis: Axis
    span: tuple[float, float]  # in SI

    @property
    def name(self) -> str:
        """That of the axis."""
        return self.axis.name


@dataclass(frozen=True)
class Traced:
    """The branch that was followed, and where it is written."""

    title: str
    axis: Axis
    branch: Branch
    notes: tuple[Note, ...]
    table: Path
    picture: Path
    raceways: str = "rigid raceways"

    @property
    def complete(self) -> bool:
        """Whether the branch was followed until it left the range."""
        return self.branch.end is BranchEnd.RANGE_LEFT

    def columns(self) -> dict[str, np.ndarray]:
        """Columns of the table."""
        points = self.branch.points
        return {
            self.axis.column: self.branch.values / self.axis.size,
            CAGE_SLIP.name: self.branch.slip,
            "largest_roller_load_N": self.branch.largest_load,
            "stable": self.branch.stable.astype(int),
            "fold": np.array([point.fold for point in points], int),
            "growth_rate_1_per_s": np.array([point.growth for point in points]),
        }

    def text(self) -> str:
        """The branch in words."""
        values = self.branch.values / self.axis.size
        lines = [f"{self.title}: {len(values)} equilibria between {self.raceways}"]
        for point in self.branch.folds:
            value = point.value / self.axis.size
            lines.append(f"fold at {value:.6g} {self.axis.unit}, cage slip {100 * point.slip:.4g} %")
        if self.branch.folds:
            lines.append(
                "between two folds there are several equilibria: the slip depends on what was before"
            )
        lines.append(f"end: {self.branch.end} at {values[-1]:.6g} {self.axis.unit}")
        if self.complete and values[-1] == values[0]:
            lines.append("the branch came back to where it began: a wider range shows the rest of it")
        return "\n".join([*lines, *(f"{note.grade}: {note.text}" for note in self.notes)]) + "\n"


def trace(
    case: str | Path, over: str, output: str | Path | None = None, overrides: Sequence[str] = ()
) -> Traced:
    """Follow the equilibria of a case between rigid raceways over its load or speed.

    Parameters
    ----------
    case : path
        case file
    over : str
        KEY=FROM..TO, such as "operation.radial_load=500 N..20 kN"
    output : path, optional
        table (CSV), beside it a picture of the same name; default `results/<case>_trace.csv`, with the
        settings in its name
    overrides : sequence of str
        `"key=value"` settings that replace those of the file

    Returns
    -------
    Traced
        also when the branch was not followed to the end of the range

    Raises
    ------
    BadCase
        when key, range or case make no sense
    BadOutput
        when table or picture cannot be written; nothing is computed then
    NotStored
        if there is no room for them; a note says that the table is there when only the picture is missing
    NotSolved
        when there is no equilibrium to begin with, or the process that follows the branch dies
    """
    from flexbearing.report.picture import picture_bytes
    from flexbearing.report.studies.branch_figure import draw_branch

    axis, ends = _parsed(over)
    path = Path(output) if output else Path("results") / f"{stem_of_outputs(case, overrides)}_trace.csv"
    if path.suffix != ".csv":
        raise BadCase(f"--output {path}: the table is written as CSV; name it {path.with_suffix('.csv')}")
    key = f"operation.{axis.name}"
    settings = [[*overrides, f"{key}={end}"] for end in ends]
    first, last = _rollers(check(case, settings[0])), _rollers(read_case(case, settings[1]))
    for name in (path, path.with_suffix(".png")):
        require_output(name, first.input_files)
    span = getattr(first.operation, axis.name), getattr(last.operation, axis.name)
    try:
        found = _followed(Range(first, axis, span))
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"--over {excerpt(over)}: {problem}") from problem
    traced = Traced(
        first.title, axis, found, notes.of_case(first), path, path.with_suffix(".png"), _raceways(first)
    )
    write(path.resolve(), _csv(traced.columns()).encode())
    try:
        figure = draw_branch(first.title, axis.label, traced.columns(), traced.raceways)
        write(traced.picture.resolve(), picture_bytes(figure))
    except BaseException as problem:  # only a note is added
        problem.add_note(f"the table is complete: {path}")
        raise
    return traced


def _rollers(case: Head) -> Case:
    if isinstance(case, Case):
        return case
    raise BadCase(f'{case.source.path}: only roller bearings are traced; this case has kind = "{case.kind}"')


def _raceways(case: Case) -> str:
    return "rigid raceways" if _is_rigid(case) else "flexible rings"


def _is_rigid(case: Case) -> bool:
    return case.inner.kind == case.outer.kind == "rigid"


def _followed(wanted: Range) -> Branch:
    """The branch over a range, a call of its own: that of flexible rings in a process that may die."""
    with closing(Serial() if _is_rigid(wanted.case) else Apart()) as engine:
        (done,) = completed([wanted], branch, engine)
    if done.died:
        raise NotSolved(DIED)
    if done.raised:
        raise done.raised
    return done.answer


def branch(wanted: Range) -> Branch:
    """The branch that begins at the equilibrium of a case, with its rings in one system.

    Parameters
    ----------
    wanted : Range
        what a worker process is given

    Returns
    -------
    Branch
    """
    with linear_algebra_alone():
        return _branch(wanted.case, wanted.axis, wanted.span)


def _branch(case: Case, axis: Axis, span: tuple[float, float]) -> Branch:
    model = roller_bearing.bearing(case)
    logarithms(model, axis.name, span)  # before anything is meshed
    if _is_rigid(case):
        return follow(model, over=axis.name, span=span)
    if case.outer.kind == "ring" and case.outer.support == "planet" and axis.name == "radial_load":
        raise BadCase(
            f"{case.source.path}: a planet gear is not traced over operation.radial_load, as its tooth "
            "forces stay as they are and carry one load only; allowed is operation.inner_speed"
        )
    rings = condensed_raceways(case, model.bearing.azimuths, Logged())
    start = equilibrium(BearingPartner(model), rings, case.coupling)
    return follow(model, over=axis.name, span=span, start=start, tangents=partial(_tangent, rings))


def _tangent(rings: RacewayPair, forces: np.ndarray) -> tuple[Compliance, np.ndarray | None]:
    """Both raceways near roller forces (2, Z, M) [N]; not a number where they have no answer."""
    try:
        linear = rings.linearised(forces)
    except PartnerFailed:  # such a state is no solution: the branch takes a shorter step, or ends there
        nothing = np.full(forces.shape[1:] * 2, np.nan)
        inner, outer = (None if ring.rigid else nothing for ring in (rings.inner, rings.outer))
        return (inner, outer), None
    return linear.compliance, linear.initial_deviation


def _parsed(over: str) -> tuple[Axis, tuple[str, str]]:
    """Key and both ends of KEY=FROM..TO."""
    key, _, span = over.partition("=")
    if key.strip() not in AXES:
        raise BadCase(f"--over {excerpt(over)}: the key is one of {', '.join(AXES)}")
    first, dots, last = span.partition("..")
    if not (first.strip() and dots and last.strip()):
        raise BadCase(
            f"--over {excerpt(over)}: a range is KEY=FROM..TO, such as operation.radial_load=500 N..20 kN"
        )
    return AXES[key.strip()], (first.strip(), last.strip())


def _csv(columns: dict[str, np.ndarray]) -> str:
    file = StringIO(newline="")
    table = writer(file)
    table.writerow(columns)
    table.writerows(zip(*(column.tolist() for column in columns.values()), strict=True))
    return file.getvalue()
