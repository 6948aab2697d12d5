"""Balls between elastic rings of any proportions: `python -m benchmarks.elastic_balls --n 400 --seed S`.

Deep groove, angular contact and four-point bearings of balls of 3 to 60 mm, grooves of 0.505 to 0.54, every
support, cages, shafts, bolted faces, rings of 4 to 60 % of a ball thick at the bottom of the groove (cages 20
to 60), loads over three decades up to about the static rating. The first two turn with 10 to 25 000 rpm, the
balls of the third have no inertia. Each is checked, and what passes is run; the forces of the contacts are
added up again, and fast balls are solved once more by a fixed-point iteration with their rings. `--only K`
repeats design K alone.
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
from flexbearing import run
from flexbearing.api import check
from flexbearing.case import BadCase
from flexbearing.results import Result
from tests.sound_results import forces_left_by_balls

CASES = {
    "deep_groove_ball": "configs/6209.toml",
    "angular_contact_ball": "configs/harris218.toml",
    "four_point_ball": "configs/joshi2015_fourpoint.toml",
}
SUPPORTS = ("side", "seat", "foundation", "housing", "cage", "shaft", "shaft in housing")
BOLTED = ("outer", "inner", "both rings", "both rings on springs")
STEEL = ("youngs_modulus=206 GPa", "poisson_ratio=0.3", "density=7800 kg/m^3")
SUMMED = 1e-6  # of the largest load: forces added up again from what is stored
SAME = 1e-6  # of the largest load: loads by both methods
FIXED_POINT = "iqn-ils"
NO_BALANCE = "no balance"
ENDS = ("too soft", "over the shoulder")  # beyond a limit point of softer and softer rings, of cut contacts


class Row(NamedTuple):
    """How a design ended."""

    number: int
    support: str
    status: str  # of the run, "refused" by check, "internal error", or `NO_BALANCE`
    message: str
    imbalance: float  # of forces added up again, over the largest load
    seconds: float
    methods: float = np.nan  # difference of a load by the fixed point; infinite where that did not end [-]


def settings(seed: int, number: int) -> tuple[str, str, list[str]]:
    """Case, support and settings of a design; lengths in mm, forces in N."""
    rng = np.random.default_rng([seed, number])
    kind = tuple(CASES)[number % len(CASES)]
    ball = _log(rng, 3, 60)
    pitch = ball / rng.uniform(0.08, 0.3)
    most = int(np.pi / np.arcsin(ball / pitch) * 0.98)
    size = most * ball**2 * _log(rng, 0.015, 15)  # of a load, up to about the static rating
    inner, outer = rng.uniform(0.505, 0.54, 2)
    given = [
        f"bearing.ball.diameter={ball:.4f} mm", f"bearing.pitch_diameter={pitch:.4f} mm",
        f"bearing.balls={int(rng.integers(max(5, most // 2), most + 1))}",
        "bearing.inner.radius=", f"bearing.inner.conformity={inner:.4f}",
        "bearing.outer.radius=", f"bearing.outer.conformity={outer:.4f}",
    ]  # fmt: skip
    if kind == "four_point_ball":
        support, further = BOLTED[number % len(BOLTED)], _slow(rng, ball, pitch, size)
        return CASES[kind], support, given + further + _bolted(rng, support, ball, pitch)
    support = SUPPORTS[number % len(SUPPORTS)]
    angle = 0.0 if kind == "deep_groove_ball" else rng.uniform(12, 40)
    lean = np.radians(rng.uniform(0, 80 if angle == 0 else 60))
    shoulder, width = ball * rng.uniform(0.17, 0.3), ball * rng.uniform(1.3, 2.2)
    thickness = ball * _log(rng, 0.2 if support == "cage" else 0.04, 0.6)
    given += [
        f"bearing.outer.shoulder={shoulder:.4f} mm", f"bearing.inner.shoulder={shoulder:.4f} mm",
        f"bearing.first_ball_azimuth={rng.uniform(0, 360):.2f} deg",
        f"operation.inner_speed={min(_log(rng, 10, 25000), 1.2e6 / pitch):.1f} rpm",
        f"operation.load.axial={size * np.sin(lean if angle == 0 else np.pi / 2 - lean):.5g} N",
        f"operation.load.radial_z={size * np.cos(lean if angle == 0 else np.pi / 2 - lean):.5g} N",
    ]  # fmt: skip
    if angle:
        given += [f"bearing.contact_angle={angle:.2f} deg"]
        given += [f"operation.displacement.{name}=" for name in ("tilt_y", "tilt_z")]
    else:
        given += [f"bearing.clearance={1e3 * ball * rng.uniform(-2e-4, 2e-3):.3f} um"]
    return CASES[kind], support, given + _rings(rng, support, pitch, thickness, width)


def _slow(rng: np.random.Generator, ball: float, pitch: float, size: float) -> list[str]:
    """Angle, clearance and loads of balls without inertia."""
    lean, moment = rng.uniform(0, np.pi / 2), size * pitch / 4 * rng.uniform(-1, 1)
    return [
        f"bearing.contact_angle={rng.uniform(30, 50):.2f} deg",
        f"bearing.clearance={1e3 * ball * rng.uniform(-4e-4, 1e-3):.3f} um",
        f"operation.load.axial={size * np.sin(lean):.5g} N", "operation.load.radial_y=0 N",
        f"operation.load.radial_z={size * np.cos(lean):.5g} N",
        f"operation.load.moment_y={1e-3 * moment:.5g} N m", "operation.load.moment_z=0 N m",
    ]  # fmt: skip


def _bolted(rng: np.random.Generator, support: str, ball: float, pitch: float) -> list[str]:
    """Rings on one of their faces; those of a bearing on opposite ones."""
    given = []
    for ring, side, face, far in (("outer", 1, "-x", "outside_diameter"), ("inner", -1, "+x", "bore")):
        if "both" not in support and ring != support:
            continue
        bottom = pitch + 1.1 * side * ball  # where both arcs meet, about
        given += [
            f"rings.{ring}.kind=bolted", f"rings.{ring}.face={face}",
            f"rings.{ring}.{far}={bottom + 2 * side * ball * _log(rng, 0.04, 0.6):.4f} mm",
            f"rings.{ring}.width={ball * rng.uniform(1.6, 2.6):.4f} mm",
            f"rings.{ring}.face_distance={ball * rng.uniform(0.7, 0.95):.4f} mm",
        ]  # fmt: skip
        if "springs" in support:
            names = ("face_stiffness", "face_shear_stiffness")
            given += [f"rings.{ring}.{name}={_log(rng, 30, 1e4):.4g} N/mm^3" for name in names]
    return given


def _rings(rng: np.random.Generator, support: str, pitch: float, thickness: float, width: float) -> list[str]:
    ring = [f"outer.thickness={thickness:.4f} mm", f"outer.width={width:.4f} mm"]
    if support == "cage":
        bars = int(rng.integers(12, 60))
        return [
            *ring, "outer.kind=squirrel_cage", f"outer.bars={bars}",
            f"outer.bar_width={0.4 * np.pi * pitch / bars:.4f} mm",
            f"outer.bar_thickness={thickness * rng.uniform(0.6, 0.95):.4f} mm",
            f"outer.bar_length={width * rng.uniform(0.5, 3):.4f} mm",
            f"outer.flange_length={0.3 * width:.4f} mm",
        ]  # fmt: skip
    shaft = []
    if "shaft" in support:
        bore = pitch * rng.uniform(0.3, 0.6)
        shaft = [
            "inner.kind=ring_on_shaft", f"inner.bore={bore:.4f} mm", f"inner.width={width:.4f} mm",
            f"inner.shaft_length={width * rng.uniform(1.1, 3):.4f} mm",
            f"inner.shaft_thickness={bore * rng.uniform(0.05, 0.3):.4f} mm", *_steel("shaft"),
        ]  # fmt: skip
    if support == "shaft":
        return shaft
    held = "housing" if "housing" in support else support
    given = [*ring, "outer.kind=ring", f"outer.support={held}", *shaft]
    if held == "foundation":
        ways = ("radial", "tangential", "axial")
        given += [f"outer.foundation_{way}={_log(rng, 30, 1e4):.4g} N/mm^3" for way in ways]
    if held == "housing":
        given += [
            f"outer.housing_thickness={thickness * _log(rng, 0.3, 5):.4f} mm",
            f"outer.housing_width={width * rng.uniform(0.7, 1.3):.4f} mm",
            f"outer.housing_support={rng.choice(['seat', 'side'])}", *_steel("housing"),
        ]  # fmt: skip
    return given


def _steel(part: str) -> list[str]:
    return [f"materials.{part}.{value}" for value in STEEL]


def _log(rng: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


def ended(seed: int, number: int) -> Row:
    """Check a design, run what passes, add up its forces."""
    began = time.perf_counter()
    case, support, given = settings(seed, number)

    def row(status: str, message: str, imbalance: float = 0.0, methods: float = np.nan) -> Row:
        first, *_ = [*message.splitlines(), ""]
        return Row(number, support, status, first, imbalance, time.perf_counter() - began, methods)

    with tempfile.TemporaryDirectory() as folder, threadpool_limits(limits=1, user_api="blas"):
        try:
            check(case, given)
        except BadCase as problem:
            return row("refused", str(problem))
        try:
            result = run(case, given, output=f"{folder}/design.h5")
        except Exception as problem:  # what the benchmark looks for
            return row("internal error", f"{type(problem).__name__}: {problem}")
        status, message = result.attributes["status"], result.attributes["message"]
        if status != "converged":
            return row(NO_BALANCE if result.attributes["ending"] in ENDS else status, message)
        fast = result.flexible["contact_load"].ndim == 2
        return row(status, message, summed(result), by_fixed_point(case, given, result) if fast else np.nan)


def by_fixed_point(case: str, given: list[str], result: Result) -> float:
    """Largest difference of a load from that of a fixed-point iteration, over the largest load."""
    other = run(case, [*given, f"coupling.method={FIXED_POINT}", "coupling.fallback=false"])
    if other.attributes["status"] != "converged":
        return np.inf
    loads = result.flexible["contact_load"]
    return float(np.abs(other.flexible["contact_load"] - loads).max() / loads.max())


def summed(result: Result) -> float:
    """Force left on the worst ball, or on the inner ring along x, y and z, over the largest load."""
    block = result.flexible
    load = block["contact_load"]
    if load.ndim == 2:
        return forces_left_by_balls(block) / load.max()
    across, azimuth = np.exp(-1j * block["contact_angle"]), block["ball_azimuth"]
    force = ((load * 1j + block["section_force"]) * across)[..., 0].T  # of diagonals, to their own side
    force = (force.real * np.array([[1], [-1]]) + 1j * force.imag).sum(0)
    carried = [force.real.sum(), force.imag @ np.sin(azimuth), force.imag @ np.cos(azimuth)]
    return float(np.abs(carried - block["ring_load"][:3]).max() / load.max())


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=400)
    parser.add_argument("--seed", type=lambda text: int(text, 16), default=1)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", type=int)
    asked = parser.parse_args()
    print(describe())
    if asked.only is not None:
        case, _, given = settings(asked.seed, asked.only)
        print("flexbearing run", case, *(f"--set '{each}'" for each in given))
        print(ended(asked.seed, asked.only))
        return
    rows = []
    with ProcessPoolExecutor(asked.jobs, mp_context=get_context("spawn")) as pool:
        for row in pool.map(ended, repeat(asked.seed), range(asked.n)):
            rows.append(row)
            if row.status != "converged" or row.imbalance > SUMMED or row.methods > SAME:
                numbers = f"{row.imbalance:.1e}", f"{row.seconds:.1f} s", f"{FIXED_POINT} {row.methods:.1e}"
                print(*row[:4], *numbers, flush=True)
            if len(rows) % 20 == 0:
                worst = max(each.imbalance for each in rows)
                print(f"{len(rows)} of {asked.n}, forces within {worst:.1e}", flush=True)
    possible = [row for row in rows if row.status not in ("refused", NO_BALANCE)]
    good = [row for row in possible if row.status == "converged"]
    print(Counter(row.status for row in rows))
    print(f"converged {len(good)} of {len(possible)}, {len(good) / len(possible):.2%} (wanted 99.5 %)")
    print(f"forces added up again: {max(row.imbalance for row in good):.1e} of the largest load")
    both = [row.methods for row in good if np.isfinite(row.methods)]
    fast = len([row for row in good if not np.isnan(row.methods)])
    print(
        f"{FIXED_POINT} ended in {len(both)} of {fast} of fast balls, loads within {max(both):.1e} of newton"
    )
    seconds = [row.seconds for row in rows]
    print(f"seconds of a design: median {np.median(seconds):.2f}, largest {max(seconds):.1f}")


if __name__ == "__main__":
    main()
