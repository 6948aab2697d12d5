"""Raceway compliance of a clamped ring, by CalculiX and by harmonics: `python -m benchmarks.calculix`.

Ring of 75/82.2 x 10 mm, E 203 GPa, nu 0.28, one side face clamped; 30 radial lines on the raceway, a unit
load spread evenly over one, the mean displacement of the 29 others. CalculiX gets quadratic hexahedra
(C3D20) that follow the circle, its usual direct solver and a single load, as the ring looks the same from
every line; the unit load on every line in turn, as on a ring without symmetry, is timed once. Both use one
thread, times are of the processor. The error is the largest one over the largest compliance. Needs the
program `ccx`, on Debian in the package `calculix-ccx`.
"""

import os
import resource
import shutil
import subprocess
import tempfile
import time
from dataclasses import dataclass
from itertools import product
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from fem import ClampedFace, Elastic, MeshSize, OuterRing, Resolution
from fem.condense import HARMONICS, condense

LINES = 30
WIDTH, INNER, THICKNESS = 10.0, 37.5, 3.6  # [mm]
E, NU = 203e3, 0.28  # [MPa]
LOAD = 1000.0  # [N]
HEXAHEDRA = ((2, 4, 60), (2, 6, 90), (4, 6, 90), (4, 8, 120), (4, 12, 180))  # radial, axial, around
OURS = (
    (MeshSize(order=3, size=10e-3, raceway_size=4e-3), 16),
    (MeshSize(order=3, size=8e-3, raceway_size=3e-3), 22),
    (MeshSize(order=4, size=8e-3, raceway_size=3e-3), 30),
    (MeshSize(order=5, size=6e-3, raceway_size=2e-3), 40),
    (MeshSize(order=5, size=6e-3, raceway_size=1.25e-3), 80),
)
REFERENCE = MeshSize(order=8, size=3e-3, raceway_size=0.8e-3), 200
# Corners of C3D20 in (axial, radial, around), then the middles of its edges, as CalculiX counts them.
CORNERS = np.array([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)])
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]
NODES = np.concatenate([CORNERS, [(CORNERS[a] + CORNERS[b]) // 2 for a, b in EDGES]])


@dataclass(frozen=True)
class Hexahedra:
    """Numbers of nodes on a grid twice as fine as the elements, 0 where there is no node."""

    number: NDArray  # (2 axial + 1, 2 radial + 1, 2 around)
    elements: NDArray  # (elements, 20)
    axial: NDArray  # (2 axial + 1,) [mm] x
    radial: NDArray  # (2 radial + 1,) [mm] r

    @property
    def place(self) -> NDArray:
        """Coordinates (nodes, 3) of x, y, z [mm]."""
        i, j, k = np.nonzero(self.number)
        r, phi = self.radial[j], 2 * np.pi * k / self.number.shape[2]
        return np.stack([self.axial[i], r * np.cos(phi), r * np.sin(phi)], axis=1)

    @property
    def lines(self) -> NDArray:
        """Nodes (lines, nodes along a line) on the raceway."""
        return self.number[:, 0, :: self.number.shape[2] // LINES].T

    @property
    def along_a_line(self) -> NDArray:
        """Shares of the nodes in an even load, or in the mean of a displacement."""
        return simpson(self.axial)


def hexahedra(radial: int, axial: int, around: int, graded: bool) -> Hexahedra:
    """Even elements, or smaller ones towards the corners of the clamp, where stress is singular."""
    x, r = np.linspace(0, 1, axial + 1), np.linspace(0, 1, radial + 1)
    if graded:
        x, r = 1 - (1 - x) ** 2, (1 - np.cos(np.pi * r)) / 2
    return between(WIDTH * (x - 1 / 2), INNER + THICKNESS * r, around)


def between(axial: NDArray, radial: NDArray, around: int) -> Hexahedra:
    """Elements between given ends along the axis and the radius [mm], even around."""
    counts = axial.size - 1, radial.size - 1, around
    shape = 2 * counts[0] + 1, 2 * counts[1] + 1, 2 * around
    odd = sum(np.indices(shape) % 2)
    number = np.zeros(shape, dtype=int)
    number[odd <= 1] = np.arange(1, np.count_nonzero(odd <= 1) + 1)
    first = 2 * np.array(list(product(*map(range, counts))))
    i, j, k = np.moveaxis(first[:, None] + NODES, -1, 0)
    return Hexahedra(number, number[i, j, k % shape[2]], halved(axial), halved(radial))


def simpson(places: NDArray) -> NDArray:
    """Shares of ends and middles of elements in the mean over all."""
    weight = np.zeros(places.size)
    for first in range(0, weight.size - 2, 2):
        part = (places[first + 2] - places[first]) / (places[-1] - places[0])
        weight[first : first + 3] += part * np.array([1, 4, 1]) / 6
    return weight


def halved(ends: NDArray) -> NDArray:
    """Ends of elements with their middles."""
    return np.insert((ends[1:] + ends[:-1]) / 2, np.arange(ends.size), ends)[: 2 * ends.size - 1]


def rows(numbers, places) -> list[str]:
    """Nodes as lines of the input."""
    # CalculiX reads 20 characters of a number, and would take 1e-15 for 1e-1
    return [f"{n}, {x:.11f}, {y:.11f}, {z:.11f}" for n, (x, y, z) in zip(numbers, places, strict=True)]


def clamped(mesh: Hexahedra, youngs_modulus: float, poisson_ratio: float) -> list[str]:
    """Input of CalculiX for an elastic ring [MPa] whose side face at the end of x is clamped."""
    return [
        *elastic(mesh, youngs_modulus, poisson_ratio),
        "*NSET, NSET=CLAMPED", *(f"{n}," for n in mesh.number[-1][mesh.number[-1] > 0]),
        "*BOUNDARY", "CLAMPED, 1, 3",
    ]  # fmt: skip


def elastic(mesh: Hexahedra, youngs_modulus: float, poisson_ratio: float) -> list[str]:
    """Input of CalculiX for an elastic ring [MPa]."""

    def elements():
        for number, nodes in enumerate(mesh.elements, 1):
            yield f"{number}, " + ", ".join(map(str, nodes[:10])) + ","
            yield ", ".join(map(str, nodes[10:]))

    return [
        "*NODE, NSET=ALL", *rows(np.arange(1, mesh.number.max() + 1), mesh.place),
        "*ELEMENT, TYPE=C3D20, ELSET=RING", *elements(),
        "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{youngs_modulus}, {poisson_ratio}",
        "*SOLID SECTION, ELSET=RING, MATERIAL=STEEL",
    ]  # fmt: skip


def deck(mesh: Hexahedra, loaded: range) -> str:
    """Input of CalculiX with one step for each of the loaded lines."""
    lines = [*clamped(mesh, E, NU), "*NSET, NSET=LINES", *(f"{n}," for n in mesh.lines.ravel())]
    share = LOAD * mesh.along_a_line
    for line in loaded:
        phi = 2 * np.pi * line / LINES
        lines += ["*STEP", "*STATIC", "*CLOAD, OP=NEW"]
        for node, force in zip(mesh.lines[line], share, strict=True):
            lines += [f"{node}, 2, {force * np.cos(phi):.11f}", f"{node}, 3, {force * np.sin(phi):.11f}"]
        lines += ["*NODE PRINT, NSET=LINES", "U", "*END STEP"]
    return "\n".join(lines) + "\n"


def printed(program: str, text: str) -> tuple[str, float]:
    """What CalculiX prints for an input on one thread, and seconds of the processor."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "ring.inp").write_text(text)
        threads = {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run(
            [program, "ring"], cwd=folder, env=os.environ | threads, capture_output=True, text=True
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode:
            raise RuntimeError(f"ccx ended with {done.returncode}:\n{done.stdout[-2000:]}")
        found = (Path(folder) / "ring.dat").read_text()
    return found, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def calculix(program: str, mesh: Hexahedra, loaded: range) -> tuple[NDArray, float]:
    """Compliance [m/N] of all lines under the first loaded one, and seconds of the processor."""
    text, seconds = printed(program, deck(mesh, loaded))
    found = [row.split() for row in text.splitlines() if row.strip() and row.split()[0].isdigit()]
    moved = {int(row[0]): np.array(row[1:4], dtype=float) for row in found[: mesh.lines.size]}
    u = np.array([[moved[n] for n in line] for line in mesh.lines])
    phi = 2 * np.pi * np.arange(LINES) / LINES
    radial = u[:, :, 1] * np.cos(phi)[:, None] + u[:, :, 2] * np.sin(phi)[:, None]
    return 1e-3 * radial @ mesh.along_a_line / LOAD, seconds


def ours(mesh: MeshSize, harmonics: int) -> tuple[NDArray, float]:
    """Compliance [m/N] between all lines, the row of the first one; and seconds of the processor."""
    steel = Elastic(youngs_modulus=E * 1e6, poisson_ratio=NU)
    ring = OuterRing(
        raceway_diameter=2e-3 * INNER, thickness=1e-3 * THICKNESS, width=1e-3 * WIDTH, elastic=steel,
        support=ClampedFace(),
    )  # fmt: skip
    resolution = Resolution(length=1e-3 * WIDTH, mesh_size=mesh, harmonics=harmonics)
    began = time.process_time()
    raceway = condense(ring, HARMONICS, resolution)
    full = raceway.at(2 * np.pi * np.arange(LINES) / LINES).absolute
    return full[0, 0, :, 0], time.process_time() - began


def main() -> None:
    program = shutil.which("ccx")
    if program is None:
        print("CalculiX is not installed: there is no program `ccx`. On Debian: apt install calculix-ccx")
        return
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"):
        exact, _ = ours(*REFERENCE)
        print(f"finest: {', '.join(f'{1e9 * c:.5f}' for c in exact[1:5])} nm/N at 12, 24, 36, 48 degrees")
        rows = [(error(found, exact), seconds) for found, seconds in (fastest(*wish) for wish in OURS)]
    for (mesh, harmonics), (off, seconds) in zip(OURS, rows, strict=True):
        print(f"harmonics: order {mesh.order}, {harmonics:3d} harmonics: {100 * off:.4f} %, {seconds:.2f} s")
    for graded, count in product((False, True), HEXAHEDRA):
        mesh = hexahedra(*count, graded)
        found, seconds = calculix(program, mesh, range(1))
        off = error(found, exact)
        print(
            f"ccx: {' x '.join(map(str, count))} {'graded' if graded else 'even'}, "
            f"{3 * mesh.number.max():7d} unknowns: {100 * off:.4f} %, {seconds:.2f} s"
            f"{compared(rows, off, seconds)}",
            flush=True,
        )
    mesh = hexahedra(*HEXAHEDRA[0], graded=True)
    found, seconds = calculix(program, mesh, range(LINES))
    print(
        f"ccx, a step for every line, coarsest: {seconds:.1f} s{compared(rows, error(found, exact), seconds)}"
    )


def fastest(mesh: MeshSize, harmonics: int) -> tuple[NDArray, float]:
    """The fastest of three runs; the first one of all still loads modules."""
    runs = [ours(mesh, harmonics) for _ in range(3)]
    return runs[0][0], min(seconds for _, seconds in runs)


def error(found: NDArray, exact: NDArray) -> float:
    """Largest one, at other lines than the loaded one, over the largest compliance there."""
    return float(np.abs(found - exact)[1:].max() / np.abs(exact[1:]).max())


def compared(rows: list[tuple[float, float]], off: float, seconds: float) -> str:
    """In how many times the time of the harmonics at an error no larger."""
    times = [own for error, own in rows if error <= off]
    return f"; harmonics at no larger an error {seconds / min(times):.0f} x faster" if times else ""


if __name__ == "__main__":
    main()
