"""Time of studies: `python -m benchmarks.studies PART ...`, without a part all of them.

thickness: 8 thicknesses x 3 loads of the paper's bearing, rigid and flexible, no ring known, two jobs.
hypercube: 100 000 variants of the paper's bearing between rigid rings, two jobs, with the largest memory.
tolerances: 100 000 variants within tolerances, between rigid rings and flexible ones, two jobs.
slewing: a spectrum of 100 000 rows of a slewing bearing, between rigid rings and bolted ones, two jobs.
rows: 20 000 rows between rigid rings, and 402 between six known ring pairs, one job, over rigid solves.
workers: 24 distinct rings by one job and by two.
machinery: what planning, journal, table, engine and the models take of a variant that is not solved.

Studies run as commands, cold: their time holds the start of the program and of its workers.
"""

import os
import resource
import subprocess
import sys
import tempfile
import threading
import time
from dataclasses import replace
from functools import partial
from itertools import pairwise
from pathlib import Path

import numpy as np
import psutil

from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.build.roller_bearing import bearing
from flexbearing.case.variants import Variants
from flexbearing.families import FAMILIES
from flexbearing.program.worker_processes import Processes
from flexbearing.studies.engine import finished
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.plan import Row, Task
from flexbearing.studies.prepare import prepare_source
from flexbearing.studies.run import Work, run

CASE = Path(__file__).parents[1] / "configs" / "mao2016.toml"
COLLECT = """[collect]
life = "life_L10 [h]"
rigid_life = "rigid.life_L10 [h]"
load = "max_roller_load [N]"
slip = "cage_slip [%]"
stiffness = "stiffness_zz [N/um]"
"""
THICKNESS = """[over]
"outer.thickness" = "2.9 mm .. 5.1 mm, 8"
"operation.radial_load" = ["10 kN", "19621.1 N", "30 kN"]
"""
RINGS = """[over]
"outer.thickness" = "2.9 mm .. 5.1 mm, 24"
"""
HYPERCUBE = """[sample]
count = {count}
seed = 1
"operation.radial_load" = "uniform 2 kN, 30 kN"
"operation.inner_speed" = "uniform 5000 rpm, 40000 rpm"
"bearing.clearance" = "normal 75.5 um, 5 um"
"lubricant.oil_fraction" = "uniform 0.1, 0.4"
"bearing.cage.pocket_friction" = "uniform 0.02, 0.1"
"lubricant.inlet_temperature" = "uniform 180 degC, 220 degC"
"""
PAIRS = """[over]
"outer.thickness" = "2.9 mm .. 5.1 mm, 6"
"operation.radial_load" = "10 kN .. 30 kN, 67"
"""
SCATTER = """[sample]
count = {count}
seed = 1
"bearing.clearance" = "normal 75.5 um, 5 um"
"bearing.roller.drop" = "uniform 1.25 um, 2.25 um"
"operation.radial_load" = "normal 19621.1 N, 500 N"
"operation.inner_speed" = "normal 38000 rpm, 200 rpm"
"lubricant.oil_fraction" = "uniform 0.3, 0.36"
"lubricant.inlet_temperature" = "uniform 215 degC, 225 degC"
"""
SPECTRUM = """[duty]
series = "rows.csv"
bins = {bins}
[collect]
life = "life_L10 [Mrev]"
"""
MEGABYTE = 1e6


def main(parts: list[str]) -> None:
    print(describe())
    for part in parts or PARTS:
        PARTS[part]()


def thickness() -> None:
    seconds, memory, words = command(THICKNESS + COLLECT)
    print(f"8 thicknesses x 3 loads, cold, two jobs: {seconds:.1f} s, {memory:.0f} MB; {words}")
    seconds, memory, words = command(THICKNESS)
    print(f"the same with every number of the summary: {seconds:.1f} s, {memory:.0f} MB; {words}")


def hypercube() -> None:
    text = HYPERCUBE.format(count=100_000)
    for name, collect in (("life, load, slip, stiffness", COLLECT), ("every number of the summary", "")):
        seconds, memory, words = command(text + collect, rigid=True)
        print(f"100 000 variants, {name}, two jobs: {seconds:.0f} s, {memory:.0f} MB; {words}")


def tolerances(count: int = 100_000) -> None:
    text = SCATTER.format(count=count) + COLLECT.replace('rigid_life = "rigid.life_L10 [h]"\n', "")
    for rings, rigid in (("rigid", True), ("flexible", False)):
        before = processor_time()
        seconds, memory, words = command(text, rigid=rigid)
        print(
            f"{count} variants within tolerances, {rings} rings, two jobs: {seconds:.0f} s, "
            f"{processor_time() - before:.0f} s of processors, {memory:.0f} MB; {words}"
        )


def rows() -> None:
    """Rows of one job over rigid solves of the same minutes, which an interpreter of its own times."""
    with tempfile.TemporaryDirectory() as cache:
        command(PAIRS + COLLECT, jobs=1, cache=cache)
        for name, count, text, rigid in (
            ("rigid rings", 20_000, HYPERCUBE.format(count=20_000), True),
            ("six known ring pairs", 402, PAIRS, False),
        ):
            solves, before = [rigid_solve()], processor_time()
            _, memory, words = command(text + COLLECT, jobs=1, rigid=rigid, cache=cache)
            each = (processor_time() - before) / count
            solve = (solves[0] + rigid_solve()) / 2
            print(
                f"{count} rows, {name}: {each * 1e3:.2f} ms of a processor a row, {each / solve:.3f} of a "
                f"rigid solve of {solve * 1e3:.2f} ms, {memory:.0f} MB; {words}"
            )


def rigid_solve() -> float:
    """Shortest processor time of a rigid solve of the paper's bearing [s]."""
    model, times = bearing(read_case(CASE)), []
    for _ in range(60):
        began = time.process_time()
        replace(model).solve()
        times.append(time.process_time() - began)
    return min(times)


def slewing(count: int = 100_000) -> None:
    for name, bins in (("joshi2015_fourpoint", 10), ("slewing_bolted", 6)):
        before = processor_time()
        case = CASE.with_name(f"{name}.toml").read_text()
        seconds, memory, words = command(SPECTRUM.format(bins=bins), case=case, rows=blown(count))
        print(
            f"{count} rows of {name} in {bins} bins, two jobs: {seconds:.0f} s, "
            f"{processor_time() - before:.0f} s of processors, {memory:.0f} MB; {words}"
        )


def blown(count: int) -> str:
    """Rows of a bearing that the wind loads: gusts and noise on radial load and moment, a swinging thrust."""
    draw, time = np.random.default_rng(1), np.arange(count)
    wind = 1 + 0.3 * np.sin(time / 97) + 0.15 * draw.standard_normal(count)
    keys = "axial [kN]", "radial_z [kN]", "moment_y [kN m]"
    columns = [
        time,
        20 * np.sin(time / 7.3) + 30,
        40 * wind + 5 * draw.standard_normal(count),
        350 * wind**2 + 20 * draw.standard_normal(count),
        0.5 + 0.3 * abs(np.sin(time / 31)),
    ]
    head = ["time [s]", *(f"operation.load.{key}" for key in keys), "operation.speed [rpm]"]
    rows = (",".join(f"{value:.6g}" for value in row) for row in np.transpose(columns))
    return "\n".join([",".join(head), *rows])


def processor_time() -> float:
    """Of commands that have ended, with their workers [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def workers() -> None:
    one, _, words = command(RINGS + COLLECT, jobs=1)
    two, _, _ = command(RINGS + COLLECT, jobs=2)
    print(f"24 rings: one job {one:.1f} s, two jobs {two:.1f} s, {one / two:.2f} times faster; {words}")


def command(
    text: str, *, jobs: int = 2, rigid: bool = False, case: str = "", rows: str = "", cache: str = ""
) -> tuple[float, float, str]:
    """Seconds of a study as a command, its largest memory [MB] and how it ended."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        paper = between_rigid_rings() if rigid else CASE.read_text()
        (folder / "case.toml").write_text(case or paper)
        (folder / "rows.csv").write_text(rows)
        (folder / "study.toml").write_text(f'case = "case.toml"\n{text}')
        began = time.perf_counter()
        process = subprocess.Popen(
            [sys.executable, "-m", "flexbearing", "study", "study.toml", "--jobs", str(jobs), "-o", "out"],
            cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
            env=os.environ | {"FLEXBEARING_CACHE": cache or str(folder / "cache")},
        )  # fmt: skip
        largest = [0.0]
        watch = threading.Thread(target=_watch, args=(process.pid, largest))
        watch.start()
        words, _ = process.communicate()
        seconds = time.perf_counter() - began
        watch.join()
        return seconds, largest[0] / MEGABYTE, words.partition("\n")[0]


def between_rigid_rings() -> str:
    """The case of the paper without its rings and shaft."""
    head, rest = CASE.read_text().split("[materials.shaft]")
    lubricant = rest[rest.index("[lubricant]") : rest.index("[outer]")]
    rings = '[outer]\nkind = "rigid"\n[inner]\nkind = "rigid"\n'
    lines = (head + lubricant + rings + rest[rest.index("[coupling]") :]).splitlines()
    gone = '"outer.', '"inner.'
    return "\n".join(line for line in lines if not line.lstrip().startswith(gone))


def _watch(pid: int, largest: list[float]) -> None:
    """Keep the largest memory of a process and all that it started."""
    while psutil.pid_exists(pid):
        try:
            process = psutil.Process(pid)
            if process.status() == psutil.STATUS_ZOMBIE:
                return
            each = [process, *process.children(recursive=True)]
            largest[0] = max(largest[0], sum(one.memory_info().rss for one in each))
        except psutil.NoSuchProcess:
            continue
        time.sleep(0.1)


def machinery() -> None:
    with tempfile.TemporaryDirectory() as place:
        file = Path(place) / "study.toml"
        file.write_text(f'case = "{CASE}"\n' + HYPERCUBE.format(count=20_000) + COLLECT)
        times = [time.perf_counter()]
        prepared = prepare_source(file)
        times.append(time.perf_counter())
        work = Work(partial(nothing, texts=prepared.texts), no_ring)
        run(prepared, Path(place), work, lambda tasks: Serial())
        times.append(time.perf_counter())
        base = prepared.plan.base
        read = Variants(base.path, base.text, base.keys, FAMILIES)
        for variant in prepared.plan.variants:
            bearing(read.known(variant.values, variant.in_si))
        times.append(time.perf_counter())
        each = [(after - before) / 20_000 * 1e3 for before, after in pairwise(times)]
        print(
            f"a variant in a batch: plan {each[0]:.2f} ms; engine, journal, tables {each[1]:.2f} ms; "
            f"its case and bearing in a worker {each[2]:.2f} ms; together {sum(each):.2f} ms"
        )
        tasks = prepared.plan.tasks(lambda _: True)[:8]
        tasks = [replace(task, variants=(variant,)) for task in tasks for variant in task.variants]
        engine = Processes(1)
        try:
            for count in (20, len(tasks)):  # the first ones wait for the worker
                began = time.perf_counter()
                done = list(finished(tasks[:count], work.rows, engine))
                each_alone = (time.perf_counter() - began) / len(done) * 1e3
        finally:
            engine.close()
        print(f"a variant as a task of its own, {len(tasks)} of them: {each_alone:.1f} ms")


def nothing(task: Task, texts: tuple[str, ...]) -> tuple[Row, ...]:
    """Rows that cost nothing."""
    values = dict.fromkeys(texts, 1.25)
    return tuple(Row(variant.identity, "converged", "", 0.0, values) for variant in task.variants)


def no_ring(ring, *, here: bool = False) -> None:
    """Rings that cost nothing."""


PARTS = {
    "thickness": thickness,
    "hypercube": hypercube,
    "tolerances": tolerances,
    "slewing": slewing,
    "rows": rows,
    "workers": workers,
    "machinery": machinery,
}

if __name__ == "__main__":
    main(sys.argv[1:])
