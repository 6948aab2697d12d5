"""Error of a condensed raceway against time: `python -m benchmarks.structure [--picture FILE]`.

Squirrel cage, and inner ring on its shaft, of the main case; 30 rollers, 3 axial shapes. The error is the
largest of all entries of the compliance over the largest entry, against the finest row of each table. Every
row runs in a process of its own on one thread: time of the processor is what an idle machine takes.
"""

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

import fem
from benchmarks.alone import Cost, measured
from benchmarks.bearings import CASE
from benchmarks.machine import describe
from fem.condense import HARMONICS, condense_in_process
from flexbearing.api import read_case
from flexbearing.build import expansion, ring_parts
from flexbearing.build.mesh_sizes import IN_SPACE, ON_A_SECTION

SHAPES = 3


@dataclass(frozen=True)
class RowRequest:
    """Elements, sizes over the roller length."""

    order: int
    size: float
    raceway_size: float
    layers: int  # of smaller elements at sharp edges or corners
    harmonics: int | None = None

    def __str__(self) -> str:
        return f"order {self.order}, size {self.size:g} / {self.raceway_size:g}, {self.layers} layers"


CAGE = (
    RowRequest(5, 0.4, 0.2, 2, 100),
    RowRequest(4, 0.6, 0.15, 2, 90),
    RowRequest(4, 0.6, 0.2, 2, 70),
    RowRequest(4, 0.6, 0.2, 2),
    RowRequest(4, 0.4, 0.2, 1),
    RowRequest(4, 0.6, 0.3, 1),
    RowRequest(3, 0.4, 0.25, 1),
    RowRequest(*IN_SPACE, 1),
    RowRequest(2, 0.6, 0.3, 1),
    RowRequest(2, 0.8, 0.5, 1),
)
SHAFT = (
    RowRequest(8, 0.6, 0.1, 4, 200),
    RowRequest(6, 0.8, 0.15, 3),
    RowRequest(*ON_A_SECTION, 2),
    RowRequest(4, 0.6, 0.15, 2),
    RowRequest(4, 1.2, 0.25, 2),
    RowRequest(4, 2.0, 0.5, 2),
    RowRequest(3, 1.2, 0.25, 2),
)


def condensed(part, length: float, wish: RowRequest):
    """Compliance (Z, M, Z, M), support stiffness, unknowns; layers are a constant of the mesher."""
    from fem.mesh import axial_section, half_pitch

    half_pitch.LAYERS = axial_section.GRADED_LAYERS = wish.layers
    mesh = fem.MeshSize(order=wish.order, size=wish.size * length, raceway_size=wish.raceway_size * length)
    resolution = fem.Resolution(length=length, axial_modes=SHAPES, mesh_size=mesh, harmonics=wish.harmonics)
    with threadpool_limits(limits=1, user_api="blas"):
        raceway = condense_in_process(part, HARMONICS, resolution)
        found = raceway.at(2 * np.pi * np.arange(30) / 30)
    return found.absolute, found.support_stiffness, found.unknowns


def table(
    name: str, part, length: float, wishes: tuple[RowRequest, ...]
) -> list[tuple[RowRequest, float, Cost]]:
    """Print errors and costs; return those of all but the finest."""
    print(f"{name}\n{'elements':42s} unknowns  largest   load on  support   clock  processor  memory")
    exact, rows = None, []
    for wish in wishes:
        (full, support, unknowns), cost = measured(condensed, part, length, wish)
        exact = exact or (full, support)
        whole, mean = (
            float(np.abs(new - old).max() / np.abs(old).max())
            for new, old in ((full, exact[0]), (full[:, 0, :, 0], exact[0][:, 0, :, 0]))
        )
        print(
            f"{wish!s:42s} {unknowns:8d}  {100 * whole:6.3f} %  {100 * mean:6.3f} %  "
            f"{100 * (support / exact[1] - 1):+6.3f} %  {cost.seconds:5.1f} s  "
            f"{cost.processor_seconds:5.1f} s  {cost.memory:6.0f} MiB",
            flush=True,
        )
        rows.append((wish, whole, cost))
    for target in (1e-2, 1e-3):
        within = [row for row in rows[1:] if row[1] <= target]
        if within:
            wish, error, cost = min(within, key=lambda row: row[2].processor_seconds)
            print(
                f"  {100 * target:g} %: {wish}, {100 * error:.2g} % in {cost.processor_seconds:.1f} s, "
                f"{cost.memory:.0f} MiB"
            )
        else:
            print(f"  {100 * target:g} %: none of these")
    return rows[1:]


def draw(series: dict[str, list], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(6.5, 4.2), layout="constrained")
    for (name, rows), colour in zip(series.items(), ("C0", "C1"), strict=True):
        for order, marker in ((2, "v"), (3, "^"), (4, "s"), (5, "o"), (6, "D")):
            some = [(c.processor_seconds, 100 * e) for wish, e, c in rows if wish.order == order]
            if some:
                axes.loglog(*zip(*some, strict=True), marker, c=colour, label=f"{name}, order {order}")
    for seconds, percent in ((5, 1), (30, 0.1)):
        axes.plot([0.5, seconds, seconds], [percent, percent, 10], ":", c="grey", lw=1)
    axes.set(
        xlabel="time of the processor, one thread [s]", ylabel="largest error of the compliance [%]",
        xlim=(0.5, 60), ylim=(0.01, 10),
    )  # fmt: skip
    axes.legend(fontsize=8, ncols=2)
    figure.savefig(path, dpi=130)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    print(describe())
    case = read_case(CASE)
    length = expansion.roller_length(case)
    series = {
        "cage": table("squirrel cage", ring_parts.outer_part(case), length, CAGE),
        "shaft": table("inner ring on its shaft", ring_parts.inner_part(case), length, SHAFT),
    }
    if asked.picture:
        draw(series, asked.picture)


if __name__ == "__main__":
    main()
