r"""A bearing in a clamped flexible ring, monolithic in CalculiX: `python -m benchmarks.calculix_bearing`.

The 209 bearing of `configs/nu209.toml` (14 rollers, 10 slices each) in an outer ring of 12 x 4 mm with one
side face clamped, on a rigid inner ring. With `--ring "two rows"` it has two rows 14 mm apart in a ring of
28 x 4 mm, where the row at the clamp carries more; with `--ring rim` this ring is a rim that tangential
forces at 90 and 270 degrees hold, free to tilt, and one row has 20 um more clearance. Both programs start
from the same case file.

CalculiX takes the whole at once, as `benchmarks.calculix_springs` tells: a given displacement of the inner
ring leads it to a solution, a given force does not, and flexbearing gets the force that this takes. Its three
runs also settle how unevenly the slices of a roller indent the raceway; the last one changes loads by 0.02 %.

flexbearing has friction, film and mass: at 1 rpm they move the largest load by less than is printed for
2 rpm. Both use one thread. Times are medians of three, of flexbearing those of `run` with nothing in the
cache, of CalculiX those of its process without making its input; on a busy machine trust the processor's.
Needs the program `ccx`, on Debian in the package `calculix-ccx`.
"""

import argparse
import os
import shutil
import statistics
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

import fem
from benchmarks.calculix import Hexahedra, printed
from benchmarks.calculix_springs import MOVED, SLICES, Springs, deck, found, meshed
from benchmarks.machine import describe
from flexbearing import run
from flexbearing.api import read_case
from flexbearing.build import ring_parts, roller_bearing
from flexbearing.cache.store import VARIABLE
from flexbearing.case.roller import Case

CASE = "configs/nu209.toml"
SETTINGS = [
    "outer.kind=ring", "outer.thickness=4 mm", f"accuracy.slices={SLICES}", "operation.inner_speed=1 rpm",
]  # fmt: skip
TWO_ROWS = ["outer.width=28 mm", "bearing.second_row.distance=14 mm"]
RINGS = {
    "one row": ["outer.width=12 mm"],
    "two rows": TWO_ROWS,
    "rim": [
        *TWO_ROWS, "bearing.second_row.clearance=20 um", "operation.tilt=free", "operation.moment=0 N m",
        "outer.support=planet", 'outer.tooth_azimuths=["90 deg", "270 deg"]',
        'outer.tooth_radial=["0 N", "0 N"]',
    ],
}  # fmt: skip
VARIANTS = {
    "order 3": ["accuracy.element_order=3"],
    "as usual": [],
    "finest": ["accuracy.axial_shapes=6", "accuracy.element_order=7"],
    "at 2 rpm": ["operation.inner_speed=2 rpm"],
}
RIM_MOVED = 0.15  # [mm] inner ring in a rim
LOADED = 5e3  # [N] a load for a run that does not count
# elements along the roller, on the shoulder at the clamp, along the radius, around; width of the patches [mm]
MESHES = (
    (5, 1, 1, 56, 1.0),
    (5, 1, 2, 84, 1.0),
    (5, 1, 2, 84, 0.7),
    (5, 2, 3, 84, 1.0),
)
RUNS = 3


@dataclass(frozen=True)
class Seconds:
    """Medians of the runs of one program."""

    wall: float
    processor: float

    def __str__(self) -> str:
        return f"{self.wall:.2f} s of the wall, {self.processor:.2f} s of the processor"


def medians(seconds: list[tuple[float, float]]) -> Seconds:
    """Of pairs of wall and processor."""
    return Seconds(*map(statistics.median, zip(*seconds, strict=True)))


def monolithic(program: str, springs: Springs, mesh: Hexahedra) -> tuple[list[NDArray], float, Seconds]:
    """Roller loads (Z) [N] of each run, force on the inner ring in the last one [N], and times."""
    dead, loads, force, seconds = springs.uneven(np.zeros((springs.bearing.all_rollers, SLICES))), [], 0.0, []
    for _ in range(RUNS):
        text = deck(springs, mesh, dead)
        began = time.perf_counter()
        answer, processor = printed(program, text)
        seconds.append((time.perf_counter() - began, processor))
        load, force = found(springs, dead, answer)
        loads.append(load.sum(axis=1))
        dead = springs.uneven(load)
    return loads, force, medians(seconds)


def loaded(settings: list[str], load: float) -> list[str]:
    """Settings with a radial load [N], of a rim also with the forces of its teeth."""
    teeth = [f'outer.tooth_tangential=["{load / 2} N", "{-load / 2} N"]']
    return [
        *settings,
        f"operation.radial_load={load} N",
        *(teeth if "outer.support=planet" in settings else ()),
    ]


def ours(load: float, settings: list[str]) -> tuple[NDArray, float, Seconds]:
    """Loads of the outer raceway (Z) [N] and way of the inner ring [m] under a radial load [N], and times.

    Nothing is taken from the cache.
    """
    loads, moved, seconds = np.empty(0), 0.0, []
    for _ in range(RUNS):
        with tempfile.TemporaryDirectory() as folder:
            began, processor = time.perf_counter(), time.process_time()
            result = run(CASE, loaded(settings, load), output=Path(folder) / "out.h5")
            seconds.append((time.perf_counter() - began, time.process_time() - processor))
        if result.attributes["status"] != "converged":
            raise RuntimeError(f"flexbearing: {result.attributes['status']}")
        loads = result.flexible["outer_load"]
        moved = result.flexible["ring_displacement"][1] + result.flexible["support_translation"][1, 1]
    return loads, float(moved), medians(seconds)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ring", choices=RINGS, default="one row")
    settings = SETTINGS + RINGS[parser.parse_args().ring]
    program = shutil.which("ccx")
    if program is None:
        print("CalculiX is not installed: there is no program `ccx`. On Debian: apt install calculix-ccx")
        return
    os.environ[VARIABLE] = "off"
    print(f"{describe()}, {release(program)}")
    case = read_case(CASE, loaded(settings, LOADED))
    assert isinstance(case, Case)
    bearing, ring = roller_bearing.bearing(case).bearing, ring_parts.outer_part(case)
    assert isinstance(ring, fem.OuterRing)
    ours(LOADED, settings)  # loads modules
    with threadpool_limits(limits=1, user_api="blas"):
        for *counts, width in MESHES:
            springs = Springs(
                bearing, ring, width, RIM_MOVED if isinstance(ring.support, fem.PlanetGear) else MOVED
            )
            print(f"{counts}, patches of {width} mm: ", end="")
            beside(program, springs, meshed(springs, *counts), settings)


def release(program: str) -> str:
    """Name and version of CalculiX."""
    said = subprocess.run([program, "-v"], capture_output=True, text=True).stdout
    return f"CalculiX {said.split()[-1]}"


def beside(program: str, springs: Springs, mesh: Hexahedra, settings: list[str]) -> None:
    """Print loads and times of both programs."""
    runs, force, other = monolithic(program, springs, mesh)
    loads = runs[-1]
    print(f"{3 * mesh.number.max()} unknowns, inner ring moved by {1e3 * springs.moved:g} um: {force:.1f} N")
    print(f"  ccx: {other}; largest load {', '.join(f'{load.max():.2f}' for load in runs)} N run by run")
    print(f"    {listed(springs, loads)}")
    for label, further in VARIANTS.items():
        own, moved, seconds = ours(force, settings + further)
        largest, any_load = own.max() / loads.max() - 1, np.abs(own - loads).max() / loads.max()
        print(
            f"  flexbearing, {label}: {seconds}; ccx takes {other.wall / seconds.wall:.1f} x (wall), "
            f"{other.processor / seconds.processor:.1f} x (processor)\n    largest load {own.max():.2f} N, "
            f"{100 * largest:+.3f} %; no load further off than {100 * any_load:.3f} % of the largest; "
            f"inner ring moved by {1e6 * moved:.3f} um"
        )
        print(f"    {listed(springs, own)}", flush=True)


def listed(springs: Springs, loads: NDArray) -> str:
    """Loads of each row from under the load to the far side; the other rollers mirror them."""
    rows = loads.reshape(springs.bearing.row_count, -1)[:, : springs.bearing.rollers // 2 + 1]
    return "; ".join(", ".join(f"{load:.1f}" for load in row) for row in rows) + " N"


if __name__ == "__main__":
    main()
