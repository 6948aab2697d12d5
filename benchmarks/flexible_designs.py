"""Flexible designs of any proportions: `python -m benchmarks.flexible_designs --n 300 --seed S [--only K]`.

Rollers 0.2 to 1.2 times the raceway radius long, rings 1 to 30 % of it thick, every support, clearances and
loads over three decades, radii of 15 to 300 mm, with the accuracy that a case has of itself. Each is checked,
and what passes is run; what is neither converged nor refused by `check` is a fault.
"""

import argparse
import tempfile
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from itertools import repeat
from multiprocessing import get_context
from typing import NamedTuple

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from flexbearing import read, run
from flexbearing.api import check
from flexbearing.case import BadCase

CASE = "configs/nu209.toml"
LONG = 30.0  # [s] from which a design is printed
SUPPORTS = ("side", "seat", "foundation", "housing", "loose housing", "lines", "planet", "cage", "on shaft")
STEEL = ("youngs_modulus=207 GPa", "poisson_ratio=0.3", "density=7850 kg/m^3", "expansion=11.5e-6 1/K")


class Row(NamedTuple):
    """How a design ended."""

    number: int
    support: str
    status: str  # of the run, "refused" by check, or "internal error"
    message: str
    seconds: float


class Size(NamedTuple):
    """Lengths [mm] and load [N] of a design."""

    radius: float  # of the outer raceway
    roller: float
    width: float
    thickness: float
    load: float


def settings(seed: int, number: int) -> tuple[str, list[str]]:
    """Support and settings of a design; lengths in mm, forces in N."""
    rng = np.random.default_rng([seed, number])
    radius = _log(rng, 15, 300)
    roller = radius * _log(rng, 0.06, 0.3)
    length = radius * rng.uniform(0.2, 1.2)
    most = np.pi / np.arcsin(roller / (2 * radius - roller))
    width, thickness = length + 0.1 * radius, radius * _log(rng, 0.01, 0.3)
    load = radius * length * _log(rng, 0.02, 20)
    support = SUPPORTS[number % len(SUPPORTS)]
    size = Size(radius, roller, width, thickness, load)
    return support, [
        f"bearing.rollers={int(most * rng.uniform(0.5, 0.9))}",
        f"bearing.outer_raceway_diameter={2 * radius:.4f} mm",
        f"bearing.clearance={radius * _log(rng, 1e-5, 1e-2):.5f} mm",
        f"bearing.roller.diameter={roller:.4f} mm",
        f"bearing.roller.length={length:.4f} mm",
        f"bearing.cage.thickness={roller / 3:.4f} mm",
        f"bearing.cage.mass={7e-6 * radius * length * roller:.4g} kg",
        f"operation.radial_load={load:.5g} N",
        f"operation.inner_speed={_log(rng, 1e4, 3e5) / radius:.5g} rpm",
        *_rings(rng, support, size),
    ]


def _rings(rng: np.random.Generator, support: str, size: Size) -> list[str]:
    radius, roller, width, thickness, load = size
    ring = [f"outer.thickness={thickness:.4f} mm", f"outer.width={width:.4f} mm"]
    if support == "cage":
        bars = int(rng.integers(10, 41))
        bar = thickness * rng.uniform(0.3, 0.8)
        return [
            "outer.kind=squirrel_cage", *ring, f"outer.bars={bars}", f"outer.bar_thickness={bar:.4f} mm",
            f"outer.bar_width={2 * np.pi * radius / bars * rng.uniform(0.2, 0.6):.4f} mm",
            f"outer.bar_length={radius * rng.uniform(0.2, 1):.4f} mm",
            f"outer.flange_length={0.1 * radius:.4f} mm",
        ]  # fmt: skip
    if support == "on shaft":
        inner = radius - roller
        return [
            "outer.kind=rigid", "inner.kind=ring_on_shaft", f"inner.bore={2 * (inner - thickness):.4f} mm",
            f"inner.thickness={thickness:.4f} mm", f"inner.width={width:.4f} mm",
            f"inner.track_width={width:.4f} mm",
            f"inner.shaft_thickness={(inner - thickness) * rng.uniform(0.05, 0.6):.4f} mm",
            f"inner.shaft_length={width * rng.uniform(1.2, 3):.4f} mm", *_steel("shaft"),
        ]  # fmt: skip
    name = "housing" if support == "loose housing" else support
    return ["outer.kind=ring", *ring, f"outer.support={name}", *_held(rng, support, radius, width, load)]


def _held(rng: np.random.Generator, support: str, radius: float, width: float, load: float) -> list[str]:
    if support == "foundation":
        return [
            f"outer.foundation_{way}={_log(rng, 1, 1e3):.4g} N/mm^3"
            for way in ("radial", "tangential", "axial")
        ]
    if support in ("housing", "loose housing"):
        loose = [f"outer.housing_clearance={radius * _log(rng, 1e-5, 1e-3):.6f} mm"] * (support != "housing")
        return [
            f"outer.housing_thickness={radius * _log(rng, 0.03, 0.5):.4f} mm",
            f"outer.housing_width={width:.4f} mm",
            f"outer.housing_support={rng.choice(['seat', 'side'])}", *_steel("housing"), *loose,
        ]  # fmt: skip
    if support == "lines":
        azimuths = ", ".join(
            f'"{360 * k / count:.3f} deg"' for count in [rng.integers(3, 13)] for k in range(count)
        )
        return [f"outer.line_azimuths=[{azimuths}]"]
    if support == "planet":
        return [
            'outer.tooth_azimuths=["90 deg", "270 deg"]',
            f'outer.tooth_tangential=["{load / 2:.5g} N", "{-load / 2:.5g} N"]',
            'outer.tooth_radial=["0 N", "0 N"]',
        ]
    return []


def _steel(part: str) -> list[str]:
    return [f"materials.{part}.{value}" for value in STEEL]


def _log(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def ended(seed: int, number: int) -> Row:
    """Check a design, and run what passes."""
    began = time.perf_counter()
    support, given = settings(seed, number)

    def row(status: str, message: str) -> Row:
        return Row(number, support, status, message.splitlines()[0], time.perf_counter() - began)

    with tempfile.TemporaryDirectory() as folder, threadpool_limits(limits=1, user_api="blas"):
        try:
            check(CASE, given)
        except BadCase as problem:
            return row("refused", str(problem))
        try:
            run(CASE, ["accuracy.threads=1", *given], output=f"{folder}/design.h5")
        except Exception as problem:  # what the benchmark looks for
            return row("internal error", f"{type(problem).__name__}: {problem}")
        result = read(f"{folder}/design.h5")
        return row(result.attributes["status"], result.attributes["message"])


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=300)
    parser.add_argument("--seed", type=lambda text: int(text, 16), default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", type=int)
    given = parser.parse_args()
    numbers = range(given.n) if given.only is None else [given.only]
    print(describe())
    with ProcessPoolExecutor(given.jobs, mp_context=get_context("spawn")) as pool:
        rows = []
        for row in pool.map(ended, repeat(given.seed), numbers):
            rows.append(row)
            if row.status != "converged" or row.seconds > LONG:
                print(
                    f"{row.number} {row.support}, {row.seconds:.1f} s: {row.status}: {row.message}",
                    flush=True,
                )
    print(Counter(row.status for row in rows))
    good = sum(row.status in ("converged", "refused") for row in rows)
    times = sorted(row.seconds for row in rows)
    print(
        f"{good / len(rows):.1%} converged or refused; median {times[len(rows) // 2]:.1f} s, "
        f"longest {times[-1]:.1f} s"
    )


if __name__ == "__main__":
    main()
