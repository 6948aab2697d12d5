"""Cost of a whole solid against its unknowns: `python -m benchmarks.structure_growth [--picture FILE]`.

The squirrel cage of the main case as tetrahedra of order 3, all around; inner unknowns condensed, sparse
Cholesky on one thread, one load. Every size runs in a process of its own, which may not take more memory
than stated; the largest one needs minutes.
"""

import argparse
import time
from concurrent.futures.process import BrokenProcessPool
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

import fem
from benchmarks.alone import measured
from benchmarks.bearings import CASE
from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.build import expansion, ring_parts

SIZES = (4.0, 3.0, 2.2, 1.6, 1.2, 1.0, 0.9)  # [mm]
ORDER = 3
MEMORY = 10.0  # [GiB]
STAGES = ("mesh", "assembly, factor", "solve")


def solved(part, length: float, size: float) -> tuple[int, list[float]]:
    """Unknowns, and seconds of the processor by stage."""
    import ngsolve as ngs

    from fem.assembly.elasticity import elastic_energy
    from fem.assembly.factorisation import factorised, threads
    from fem.mesh.solid import meshed

    with threadpool_limits(limits=1, user_api="blas"), threads(1):
        clock = [time.process_time()]
        mesh = meshed(part, length, fem.MeshSize(order=ORDER, size=size * 1e-3, raceway_size=size * 1e-3))
        clock.append(time.process_time())
        space = ngs.VectorH1(mesh, order=ORDER, dirichlet="clamped")
        stiffness = factorised(space, elastic_energy(mesh, part.materials))
        clock.append(time.process_time())
        down = space.TestFunction()[2] * ngs.dx(definedon=mesh.Materials("ring"))
        stiffness.solve(ngs.LinearForm(down).Assemble().vec.FV().NumPy())
        clock.append(time.process_time())
    return space.ndof, np.diff(clock).tolist()


def rows(part, length: float) -> list[tuple[int, list[float], float]]:
    """Unknowns, seconds by stage, memory [GiB], as far as memory goes."""
    found = []
    for size in SIZES:
        try:
            (unknowns, seconds), cost = measured(solved, part, length, size, memory_limit=MEMORY)
        except (BrokenProcessPool, MemoryError) as end:
            print(f"{size:g} mm: ended, as more than {MEMORY:g} GiB of addresses were asked for ({end})")
            break
        stages = ", ".join(f"{name} {s:.1f} s" for name, s in zip(STAGES, seconds, strict=True))
        print(f"{size:g} mm: {unknowns:8d} unknowns, {stages}, {cost.memory / 1024:.2f} GiB", flush=True)
        found.append((unknowns, seconds, cost.memory / 1024))
    return found


def exponent(unknowns, cost) -> float:
    """Slope of the last three in a log-log plot."""
    return float(np.polyfit(np.log(unknowns[-3:]), np.log(cost[-3:]), 1)[0])


def draw(unknowns, seconds, memory, path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    for name, times, marker in zip(STAGES, seconds.T, "sov", strict=True):
        power = exponent(unknowns, times)
        axes.loglog(unknowns, times, f"{marker}-", label=f"{name}, ~ n^{power:.2f}")
    axes.set(xlabel="unknowns n", ylabel="time of the processor, one thread [s]")
    right = axes.twinx()
    power = exponent(unknowns, memory)
    right.loglog(unknowns, memory, "D--", c="C3", label=f"peak memory, ~ n^{power:.2f}")
    right.set(ylabel="peak memory [GiB]")
    handles = [h for side in (axes, right) for h in side.get_legend_handles_labels()[0]]
    axes.legend(handles=handles, fontsize=8)
    figure.savefig(path, dpi=130)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    print(describe())
    case = read_case(CASE)
    found = rows(ring_parts.outer_part(case), expansion.roller_length(case))
    unknowns, seconds, memory = (np.array(column) for column in zip(*found, strict=True))
    for name, cost in zip((*STAGES, "memory"), (*seconds.T, memory), strict=True):
        print(f"{name}: grows like n^{exponent(unknowns, cost):.2f}")
    if asked.picture:
        draw(unknowns, seconds, memory, asked.picture)


if __name__ == "__main__":
    main()
