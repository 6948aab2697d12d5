"""Maps with several equilibria: `python -m benchmarks.maps [--points 200] [--timed] [--few]`.

Points by lot of three maps over load and speed: the bearing of Mao et al. with traction that falls with slip
and with cold oil between rigid raceways, and with falling traction between its rings. Equilibria of the map
against an exhaustive search from 40 random starts at each point, half of the points where the map has
several. With `--timed` the time of a map of 100 x 100 loads and speeds of the paper's bearing between its
rings, condensed before. With `--few` the times of a map of 1000 points between rigid rings as a command and
of maps of few points with many states, in thick oil, over a rigid solve of the paper's bearing.
"""

import argparse
import os
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from benchmarks.bearings import CASE, RPM
from benchmarks.machine import describe
from benchmarks.starting import COMMAND, RIGID as AS_RIGID, seconds
from benchmarks.studies import rigid_solve
from flexbearing.api import check, read_case
from flexbearing.build import roller_bearing
from flexbearing.program.shared_map import shared_map
from flexbearing.progress import Logged
from flexbearing.rings.condensed import condensed_raceways
from flexbearing.studies.maps.axes import axes
from flexbearing.studies.maps.solution import OUTPUTS, solved_map
from quasidynamic import RollerBearing, SolverOutcome
from quasidynamic.maps import GridPoints, SolvedGrid, folds, solve
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.solve.rollers.strategy import solve_each
from tests.cold_oil import cold_bearing
from tests.thick_films import DIFFERENT, ROUNDS, apart, decays, random_starts

SEED, STARTS = 7, 40
ALONG = 24  # points along each axis of a map that is checked
OVER = ("operation.radial_load=log 2 kN..30 kN,100", "operation.inner_speed=5000 rpm..40000 rpm,100")
THICK = "configs/nu209.toml", ("lubricant.viscosity=2 Pa s",)
FEW = (
    ("bearing.clearance=20 um..0 um,2",),
    ("bearing.roller.drop=1 um..9 um,2", "operation.inner_speed=log 1 rpm..3000 rpm,4"),
    ("bearing.clearance=0 um..-20 um,4", "operation.misalignment=0 arcmin..4 arcmin,2"),
    ("bearing.clearance=0 um..20 um,4", "bearing.roller.drop=log 9 um..1 um,2"),
    ("operation.load_direction=360 deg..0 deg,4", "bearing.clearance=20 um..0 um,4"),
    ("operation.load_direction=360 deg..0 deg,10", "bearing.clearance=20 um..0 um,4"),
)
THOUSAND = ("operation.radial_load=log 2 kN..30 kN,40", "operation.inner_speed=5000 rpm..40000 rpm,25")
FALLING = {
    "lubricant.traction": "four-point",
    "lubricant.traction_curve.peak": 0.06,
    "lubricant.traction_curve.peak_slip": 0.01,
    "lubricant.traction_curve.far": 0.02,
}
RIGID = {"outer.kind": "rigid", "inner.kind": "rigid"}


@dataclass(frozen=True)
class Checked:
    """What became of the search at a point."""

    known: int  # stable states of the map
    found: int  # of the search
    missed: int  # of these


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--points", type=int, default=200)
    parser.add_argument("--along", type=int, default=ALONG)
    parser.add_argument("--timed", action="store_true")
    parser.add_argument("--few", action="store_true")
    asked = parser.parse_args()
    print(describe())
    if asked.timed:
        timed()
        return
    if asked.few:
        few()
        return
    maps = dict(grids(asked.along))
    rows = []
    for name, points in maps.items():
        with threadpool_limits(limits=1, user_api="blas"):
            rows += checked(name, points, asked.points // len(maps))
    report("all maps", rows)


def timed() -> None:
    """Print the time of a map between elastic rings, and of its stages."""
    case, began, processor = check(CASE), time.perf_counter(), time.process_time()

    class Told(Logged):
        def stage(self, text: str, fraction: float | None) -> None:
            seconds = time.perf_counter() - began, time.process_time() - processor
            print("{:.1f} s, processor of this process {:.1f} s: {}".format(*seconds, text), flush=True)

    found = solved_map(case, axes(OVER, type(case)), OUTPUTS, Told())
    workers = getrusage(RUSAGE_CHILDREN)
    seconds = (
        time.perf_counter() - began,
        time.process_time() - processor,
        workers.ru_utime + workers.ru_stime,
    )
    print(
        "{} points in {:.1f} s, processor time {:.1f} s in this process and {:.1f} s in workers".format(
            found.points, *seconds
        )
    )
    print(
        f"{len(found.unsolved)} not converged, {found.several} with several states, "
        f"{len(found.solved.ends[0])} places where states end, {found.solved.rounds} rounds of searches"
    )


def few() -> None:
    """Print processor times of a map as a command, of maps of few points, and how many states they have."""
    solve, case = rigid_solve(), check(*THICK)
    os.environ["FLEXBEARING_THREADS"] = "1"
    with TemporaryDirectory() as folder:
        over = (word for text in THOUSAND for word in ("--over", text))
        time_of_map = seconds(folder, *COMMAND, "map", str(CASE), *AS_RIGID, *over, "-o", f"{folder}/map.csv")
    print(f"1000 points, command: {time_of_map:.2f} s, {time_of_map / solve / 1000:.2f} solves a point")
    for over in FEW:
        processor = time.process_time()
        found = solved_map(case, axes(over, type(case)), OUTPUTS[:1], Logged())
        states, ends = len(found.solved.point), len(found.solved.ends[0])
        spent = time.process_time() - processor
        print(
            f"{spent:5.1f} s, {spent / solve / found.points:.0f} solves a point: {found.points} points, "
            f"{states} states, {ends} ends "
            f"of stable ones, {found.folds.located.sum()} located, {len(found.folds.curves)} curves: {over}",
            flush=True,
        )


def grids(along: int) -> Iterator[tuple[str, GridPoints]]:
    """Maps over load and speed by their names."""
    falling = roller_bearing.bearing(read_case(CASE, FALLING | RIGID))
    loads, speeds = np.geomspace(500.0, 10e3, along), np.linspace(15e3, 40e3, along) * RPM
    yield "falling traction, rigid", grid(falling, loads, speeds)
    with TemporaryDirectory() as folder:
        cold = cold_bearing(13, folder)
    yield "cold oil, rigid", grid(cold, np.geomspace(500.0, 8e3, along), np.geomspace(1e3, 9e3, along) * RPM)
    case = read_case(CASE, FALLING)
    model = roller_bearing.bearing(case)
    linear = condensed_raceways(case, model.bearing.azimuths, Logged()).linearised(model.solve().forces)
    yield "falling traction, elastic", grid(model, loads, speeds, linear.compliance, linear.initial_deviation)


def grid(
    model: RollerBearing, loads: NDArray, speeds: NDArray, compliance=(None, None), deviation=None
) -> GridPoints:
    """Points of a bearing under all loads [N] at all speeds [rad/s]."""
    bearings = [
        replace(model, operation=replace(model.operation, radial_load=float(load), inner_speed=float(speed)))
        for load in loads
        for speed in speeds
    ]
    each = None if deviation is None else np.repeat(deviation[None], len(bearings), axis=0)
    return GridPoints.of((len(loads), len(speeds)), bearings, compliance, each)


def checked(name: str, points: GridPoints, count: int) -> list[Checked]:
    """Points of a map against searches; half of them where the map has several states."""
    began, processor = time.perf_counter(), time.process_time()
    with shared_map() as mapped:
        solved = solve(points, mapped)
    rng, several = np.random.default_rng(SEED), np.flatnonzero(solved.stable_count > 1)
    print(
        f"{name}: {len(points.bearings)} points in {time.perf_counter() - began:.0f} s (processor of this "
        f"process {time.process_time() - processor:.0f} s), {len(several)} with several states, up to "
        f"{solved.stable_count.max()}; {solved.rounds} rounds, quiet {solved.quiet}",
        flush=True,
    )
    report_folds(name, solved)
    some = rng.choice(several, min(len(several), count // 2), replace=False)
    some = np.concatenate([some, rng.choice(np.unique(solved.point), count - len(some), replace=False)])
    rows = [compared(solved, int(point), rng) for point in some]
    report(name, rows)
    return rows


def report_folds(name: str, solved: SolvedGrid) -> None:
    """Print how many ends of states are located as folds, and how their curves end."""
    processor = time.process_time()
    ended = folds(solved)
    cusps = sum(int(curve.cusps.sum()) for curve in ended.curves)
    print(
        f"{name}: {ended.located.sum()} of {len(ended.located)} ends are located as folds; "
        f"{len(ended.curves)} curves, {cusps} cusps, {ended.cut} not followed to an "
        f"end, in {time.process_time() - processor:.0f} s of processor time",
        flush=True,
    )


def compared(solved: SolvedGrid, point: int, rng: np.random.Generator) -> Checked:
    """States of a map at a point against those that random starts lead to."""
    points = solved.points
    balance = points.at(np.array([point]))
    there = [
        Equilibrium(balance, scaled, SolverOutcome.CONVERGED, 0, points.axial_modes)
        for scaled in solved.scaled[solved.point == point]
    ]
    known = [state for state in there if decays(state)]
    found: list[Equilibrium] = []
    for other in by_search(there[0], rng):
        if all(apart(other, one) > DIFFERENT for one in found) and decays(other):
            found.append(other)
    missed = [other for other in found if all(apart(other, one) > DIFFERENT for one in known)]
    return Checked(len(known), len(found), len(missed))


def by_search(state: Equilibrium, rng: np.random.Generator) -> Iterator[Equilibrium]:
    """Equilibria from random starts; those between elastic raceways begin in the shape of a known state."""
    balance, elastic = state.balance, bool(state.balance.layout.elastic_raceways)
    kept = replace(balance, compliance=(None, None), deviation=state.deviation) if elastic else balance
    with np.errstate(all="ignore"):
        _, starts = random_starts(kept, rng, STARTS)
        every = np.zeros(STARTS, int)
        many = balance.take(every)
        unknowns = kept.take(every).unpack(starts)
        if elastic:
            unknowns = unknowns._replace(deviation=state.unknowns.deviation.repeat(STARTS, axis=2))
        ended = solve_each(many, many.pack(unknowns), ROUNDS)
    for scaled, outcome in zip(ended.unknowns, ended.outcomes, strict=True):
        if outcome is SolverOutcome.CONVERGED:
            yield replace(state, scaled=scaled)


def report(name: str, rows: list[Checked]) -> None:
    several = sum(row.found > 1 or row.known > 1 for row in rows)
    known, found, missed = (sum(getattr(row, of) for row in rows) for of in ("known", "found", "missed"))
    missing = [row for row in rows if row.missed]
    print(
        f"{name}: {len(rows)} points, {several} with several states; {known} states of the map, {found} of "
        f"the searches, of which the map lacks {missed} at {len(missing)} points; regions missed, of "
        f"one state in the map and several in the search: {sum(row.known == 1 for row in missing)}",
        flush=True,
    )


if __name__ == "__main__":
    main()
