"""Random bearings between flexible rings: `python -m benchmarks.random_coupled --n 600 --seed S [--only K]`.

Each design is run as `flexbearing run` does, with the default order of methods, and its file is read back.
Its first attempt says how newton ends alone; `iqn-ils` solves the same bearing and rings once more. Where
both converge their loads are compared; where these differ, each state is solved again by the other method.
The first designs, `--solids` of them, are full solids. `--only K` repeats design K alone.
"""

import argparse
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from itertools import repeat
from multiprocessing import get_context
from os import environ
from typing import get_args

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from flexbearing import read, run
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.case import BadCase
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupling.loop import Status
from flexbearing.progress import Logged
from flexbearing.rings.condensed import condensed_raceways
from tests.random_coupled import Design, design
from tests.two_methods import AGAIN, SAME, difference, iterated, solved_again

SOLIDS = 30  # of 600
TOLERANCE = 1e-8
CONVERGED, NEWTON = 0.995, 0.98  # wanted
PROGRESS = 50  # designs between words on how far it has come


@dataclass(frozen=True)
class Row:
    """How a design ended."""

    number: int
    status: str = ""
    message: str = ""
    newton: str = ""  # how newton ended alone
    by: str = ""  # the method that solved it
    other: str = ""  # how iqn-ils ended
    iterations: tuple[int, int] = (0, 0)  # of newton and iqn-ils
    apart: float = 0.0  # largest difference of a load over the largest load
    again: tuple[float, float] = (0.0, 0.0)  # iqn-ils from newton's state, newton from the other's
    equilibria: str = ""  # where there are two
    fault: str = ""  # of the ending or the file
    impossible: str = ""  # why no such bearing can exist
    seconds: tuple[float, float] = (0.0, 0.0)  # the run, the comparison


def solved(seed: int, number: int, solids: int) -> Row:
    """Run a design, read its file, solve it again."""
    chosen = design(seed, number, number < solids)
    began = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder, threadpool_limits(limits=1, user_api="blas"):
        try:
            run(chosen.case, chosen.settings, output=f"{folder}/design.h5")
        except BadCase as problem:
            return Row(number, impossible=str(problem).splitlines()[0])
        except Exception as problem:  # what the benchmark looks for
            return Row(number, "internal error", fault=f"internal error: {type(problem).__name__}: {problem}")
        result = read(f"{folder}/design.h5")
        seconds = time.perf_counter() - began
        fault = incomplete(result)
        attempts = result.attributes["attempts"]
        first = attempts.get("newton", {"status": result.attributes["status"], "iterations": 0})
        row = Row(
            number,
            result.attributes["status"],
            result.attributes["message"],
            newton=first["status"],
            by=list(attempts)[-1] if attempts else "",
            fault=fault,
        )
        return compared(row, chosen, result, seconds, first["iterations"])


def incomplete(result) -> str:
    """What a file lacks or says wrongly; empty where it is complete."""
    attributes, status = result.attributes, result.attributes["status"]
    if status not in get_args(Status) or not status:
        return f"status {status!r} is none"
    if not attributes["message"]:
        return "no message"
    if not result.rigid and not attributes["ending"]:
        return "no rigid state, and no word why"
    if result.rigid and len(result.iterations) != attributes["iterations"]:
        return "iterations are missing"
    if status == "converged" and not result.flexible:
        return "converged without a flexible state"
    same = result.flexible and np.array_equal(result.flexible["outer_load"], result.rigid["outer_load"])
    return "the flexible state is the rigid one" if same else ""


def compared(row: Row, chosen: Design, result, seconds: float, iterations: int) -> Row:
    """The row with iqn-ils beside it."""
    began = time.perf_counter()
    if not result.rigid:
        return replace(row, seconds=(seconds, 0.0))
    case = read_case(chosen.case, chosen.settings)
    bearing = BearingPartner(roller_bearing.bearing(case))
    try:
        rings = condensed_raceways(case, bearing.model.bearing.azimuths, Logged())
        rigid = bearing.solve()
        *_, last = iterated(bearing, rings, rigid, "iqn-ils", TOLERANCE)
    except Exception as problem:
        return replace(row, other=f"{type(problem).__name__}: {problem}", seconds=(seconds, 0.0))
    row = replace(row, other=last.status, iterations=(iterations, last.number))
    if last.status == row.newton == "converged":
        loads = np.array([result.flexible["inner_load"], result.flexible["outer_load"]])
        row = replace(row, apart=difference(last.state.loads, loads))
        if row.apart > SAME:
            *_, ours = iterated(bearing, rings, rigid, "newton", TOLERANCE)
            two = solved_again(bearing, rings, ours.state, last.state)
            row = replace(row, again=(two.by_other, two.by_newton), equilibria=two.names)
    return replace(row, seconds=(seconds, time.perf_counter() - began))


def line(row: Row, seed: int) -> str:
    words = row.fault or row.impossible or f"{row.status}: {row.message}"
    return (
        f"design {row.number}: newton {row.newton}, iqn-ils {row.other}, solved by {row.by}, "
        f"apart {row.apart:.1e}, "
        f"again {row.again[0]:.1e} {row.again[1]:.1e}, {sum(row.seconds):.1f} s; {words} {row.equilibria}\n"
        f"    python -m benchmarks.random_coupled --seed {seed:x} --only {row.number}"
    )


def remarkable(row: Row) -> bool:
    if row.impossible:
        return False
    return bool(row.fault) or row.status != "converged" or row.newton != "converged" or row.apart > SAME


def verdict(rows: list[Row], seconds: float) -> str:
    possible = [row for row in rows if not row.impossible]
    converged = [row for row in possible if row.status == "converged"]
    alone = [row for row in possible if row.newton == "converged"]
    two = [row for row in possible if row.newton == row.other == "converged"]
    several = [row for row in two if row.apart > SAME]
    unexplained = [row for row in several if max(row.again) > AGAIN]
    faults = [row for row in possible if row.fault]
    counts = [row.iterations[0] for row in alone]
    return "\n".join(
        [
            f"{len(rows)} designs, {len(rows) - len(possible)} of them refused; {seconds:.0f} s in all",
            f"typed endings with a complete file: {len(possible) - len(faults)} of {len(possible)} "
            "(wanted all)",
            f"converged: {len(converged)} of {len(possible)}, {len(converged) / len(possible):.2%} "
            f"(wanted {CONVERGED:.1%}); by "
            + ", ".join(f"{by} {count}" for by, count in Counter(row.by for row in converged).most_common()),
            f"newton alone: {len(alone)} of {len(possible)}, {len(alone) / len(possible):.2%} "
            f"(wanted {NEWTON:.0%}), {np.median(counts):g} iterations in the median, at most {max(counts)}",
            f"iqn-ils alone: {sum(row.other == 'converged' for row in possible)}",
            f"both: {len(two)}; loads agree to {SAME:g} in {len(two) - len(several)}, "
            f"two equilibria in {len(several) - len(unexplained)}, unexplained {len(unexplained)}",
            f"endings: {dict(Counter(row.status for row in possible))}",
            f"seconds of a run: median {np.median([row.seconds[0] for row in possible]):.2f}, "
            f"largest {max(row.seconds[0] for row in possible):.1f}",
        ]
    )


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=600)
    parser.add_argument("--seed", type=lambda text: int(text, 16), default=1, help="hexadecimal")
    parser.add_argument("--only", type=int, help="this design alone")
    parser.add_argument("--solids", type=int, default=SOLIDS, help="how many of the first are full solids")
    parser.add_argument("--workers", type=int, default=2)
    asked = parser.parse_args()
    print(describe(), f"seed {asked.seed:x}", sep="\n")
    if asked.only is not None:
        print(design(asked.seed, asked.only, asked.only < asked.solids).command())
        print(line(solved(asked.seed, asked.only, asked.solids), asked.seed))
        return
    for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):  # one thread for each worker
        environ[name] = "1"
    began, rows = time.perf_counter(), []
    with ProcessPoolExecutor(asked.workers, mp_context=get_context("spawn")) as pool:
        for row in pool.map(solved, repeat(asked.seed), range(asked.n), repeat(asked.solids)):
            rows.append(row)
            if remarkable(row):
                print(line(row, asked.seed), flush=True)
            if len(rows) % PROGRESS == 0:
                print(f"... {len(rows)} designs, {time.perf_counter() - began:.0f} s", flush=True)
    print(verdict(rows, time.perf_counter() - began))
    print(*(f"refused: {row.number}: {row.impossible}" for row in rows if row.impossible), sep="\n")


if __name__ == "__main__":
    main()
