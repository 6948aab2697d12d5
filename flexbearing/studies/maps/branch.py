"""Equilibria of a case followed over its load or speed, around folds: a map of one axis."""

from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from math import pi
from pathlib import Path

import numpy as np

from flexbearing.api import check, read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase, Head
from flexbearing.case.roller import Case
from flexbearing.coupled.coupled import BearingPartner, equilibrium
from flexbearing.coupling import PartnerFailed, RacewayPair
from flexbearing.coupling.partners import Compliance
from flexbearing.findings.words import of_note
from flexbearing.printable import excerpt
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.program.worker_processes import Processes
from flexbearing.progress import Logged
from flexbearing.quantities.roller import CAGE_SLIP
from flexbearing.rings.condensed import condensed_raceways
from flexbearing.runs import notes
from flexbearing.studies.engine import DIED, completed
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.table import Table
from flexbearing.studies.table.table import Column
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange
from quasidynamic.note import Note
from quasidynamic.trace import Branch, BranchEnd, logarithms, trace as follow

RPM = 2 * pi / 60


@dataclass(frozen=True)
class Axis:
    """A key along which equilibria are followed."""

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
class FollowedMap:
    """The branch that was followed."""

    title: str
    axis: Axis
    branch: Branch
    notes: tuple[Note, ...]
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

    def table(self) -> Table:
        """The same as a table."""
        columns = (Column(name, "", values.tolist()) for name, values in self.columns().items())
        return Table(self.title, tuple(columns), ())

    def text(self) -> str:
        """The branch in words."""
        values = self.branch.values / self.axis.size
        lines = [f"{self.title}: {len(values)} equilibria between {self.raceways}"]
        for point in self.branch.folds:
            value = point.value / self.axis.size
            lines.append(f"fold at {value:.6g} {self.axis.unit}, cage slip {100 * point.slip:.4g} %")
        if self.branch.folds:
            lines.append("between two folds there are several equilibria: the slip depends on the history")
        lines.append(f"end: {self.branch.end} at {values[-1]:.6g} {self.axis.unit}")
        if self.complete and values[-1] == values[0]:
            lines.append("the branch came back to where it began: a wider range shows the rest of it")
        return "\n".join([*lines, *(f"{note.grade}: {of_note(note.record())}" for note in self.notes)]) + "\n"


def is_followed(over: Sequence[str]) -> bool:
    """Whether `--over` names a branch: one load or speed, without a number of points."""
    return len(over) == 1 and "," not in over[0] and over[0].partition("=")[0].strip() in AXES


def ends(case: str | Path, over: str, overrides: Sequence[str] = ()) -> Range:
    """Where a branch begins and how far it is followed.

    Raises `BadCase` when key, range or case make no sense.
    """
    axis, texts = _parsed(over)
    settings = [[*overrides, f"operation.{axis.name}={end}"] for end in texts]
    first, last = _rollers(check(case, settings[0])), _rollers(read_case(case, settings[1]))
    span = getattr(first.operation, axis.name), getattr(last.operation, axis.name)
    return Range(first, axis, span)


def followed(wanted: Range) -> FollowedMap:
    """Follow the equilibria of a case over its load or speed.

    Raises `BadCase` when the range makes no sense; `NotSolved` when there is no equilibrium to begin with, or
    the process that follows the branch dies.
    """
    case = wanted.case
    try:
        found = _followed(wanted)
    except (ImpossiblePart, OutOfRange) as problem:
        raise BadCase(f"--over operation.{wanted.axis.name}: {problem}") from problem
    return FollowedMap(case.title, wanted.axis, found, notes.of_case(case), _raceways(case))


def _rollers(case: Head) -> Case:
    if isinstance(case, Case):
        return case
    raise BadCase(f'{case.source.path}: only roller bearings have maps; this case has kind = "{case.kind}"')


def _raceways(case: Case) -> str:
    return "rigid raceways" if _is_rigid(case) else "flexible rings"


def _is_rigid(case: Case) -> bool:
    return case.inner.kind == case.outer.kind == "rigid"


def _followed(wanted: Range) -> Branch:
    """The branch over a range, a call of its own: that of flexible rings in a process that may die."""
    with closing(Serial() if _is_rigid(wanted.case) else Processes(1)) as engine:
        (done,) = completed([wanted], branch, engine)
    if done.died:
        raise NotSolved(DIED)
    if done.raised:
        raise done.raised
    return done.answer


def branch(wanted: Range) -> Branch:
    """The branch that begins at the equilibrium of a case, with its rings in one system."""
    with linear_algebra_alone():
        return _branch(wanted.case, wanted.axis, wanted.span)


def _branch(case: Case, axis: Axis, span: tuple[float, float]) -> Branch:
    model = roller_bearing.bearing(case)
    logarithms(model, axis.name, span)  # before anything is meshed
    if _is_rigid(case):
        return follow(model, over=axis.name, span=span)
    if case.outer.kind == "ring" and case.outer.support == "planet" and axis.name == "radial_load":
        raise BadCase(
            f"{case.source.path}: a planet gear is not followed over operation.radial_load, as its tooth "
            "forces stay as they are and carry one load only; allowed is operation.inner_speed"
        )
    rings = condensed_raceways(case, model.bearing.azimuths, Logged())
    start = equilibrium(BearingPartner(model), rings, case.coupling)
    return follow(model, over=axis.name, span=span, start=start, tangents=partial(_tangent, rings))


def _tangent(rings: RacewayPair, forces: np.ndarray) -> tuple[Compliance, np.ndarray | None]:
    """Both raceways near roller forces (2, Z, M) [N]; not a number where they have no solution."""
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
    first, dots, last = span.partition("..")
    if not (first.strip() and dots and last.strip()):
        raise BadCase(
            f"--over {excerpt(over)}: a range is KEY=FROM..TO, such as operation.radial_load=500 N..20 kN"
        )
    return AXES[key.strip()], (first.strip(), last.strip())
