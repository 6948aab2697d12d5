"""All coupling methods on hard cases: `python -m benchmarks.coupling_hard [WORD ...] [--picture FILE]`.

With words only the cases whose names hold one of them are run.
"""

import argparse
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from statistics import median

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.bearings import CASE
from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.coupled.coupled import BearingPartner
from flexbearing.coupling import RULES, RacewayPair, StoppingCriterion, fixed_point, newton, relaxed
from flexbearing.progress import Logged
from flexbearing.rings.condensed import condensed_raceways
from flexbearing.rings.raceways import CondensedRaceway, RigidRaceway
from quasidynamic.balance.rollers.unknowns import LARGE_DEVIATION
from quasidynamic.solve.rollers import bordered_system

METHODS = ("newton", *RULES, "relaxed")
TOLERANCE, LIMIT = 1e-8, 250
MOST, USUAL, SAME = 15, 7, 1e-7  # newton: most iterations, median; difference of loads over the largest
SOFTNESS = (0.044, 0.47, 1.6)  # of the squirrel cage, times its own

HELD = ["operation.tilt=fixed"]
STIFF_INNER = ["inner.kind=rigid"]
CAGE = [*STIFF_INNER, "accuracy.slices=10"]
SECTION = ["accuracy.element_order=3", "accuracy.slices=10"]
RING = [*STIFF_INNER, "outer.kind=ring", *SECTION]
THIN = [*RING, "outer.thickness=1 mm"]
FIT = ["outer.kind=rigid", "inner.fit=friction", "inner.fit_friction=0.1", *SECTION]
TEETH = ['outer.tooth_azimuths=["90 deg", "270 deg"]', 'outer.tooth_radial=["0 N", "0 N"]']

CASES: dict[str, list[str]] = {
    "cage and shaft": ["accuracy.slices=10"],
    **{f"{bars} bars": [*CAGE, f"outer.bars={bars}"] for bars in (1, 2, 3, 6, 24)},
    **{f"24 bars, clearance {c} um": [*CAGE, f"bearing.clearance={c} um"] for c in (-40, 0, 150, 300)},
    **{f"24 bars, {f}": [*CAGE, f"operation.radial_load={f}"] for f in ("5 N", "50 N", "500 N", "100 kN")},
    **{f"24 bars, {n} rpm": [*CAGE, f"operation.inner_speed={n} rpm"] for n in (100, 10000, 80000)},
    "24 bars, 5 arcmin": [*CAGE, *HELD, "operation.misalignment=5 arcmin"],
    "24 bars, 60 N m": [*CAGE, "operation.moment=60 N m"],
    **{f"ring {t} mm": [*RING, f"outer.thickness={t} mm"] for t in (0.8, 1, 1.5, 2, 3.6, 8, 20)},
    **{f"ring 1 mm, {f}": [*THIN, f"operation.radial_load={f}"] for f in ("5 N", "500 N", "100 kN")},
    **{f"ring 1 mm, clearance {c} um": [*THIN, f"bearing.clearance={c} um"] for c in (-40, 300)},
    "ring 1 mm, 80000 rpm": [*THIN, "operation.inner_speed=80000 rpm"],
    "ring 1 mm, 10 arcmin": [*THIN, *HELD, "operation.misalignment=10 arcmin"],
    "ring 2 mm, seat": [*RING, "outer.thickness=2 mm", "outer.support=seat"],
    "ring 2 mm, 10 N/mm3": [
        *RING, "outer.thickness=2 mm", "outer.support=foundation", "outer.foundation_radial=10 N/mm^3",
    ],
    "ring 2 mm, housing": [
        *RING, "outer.thickness=2 mm", "outer.support=housing", "outer.housing_thickness=4 mm",
        "outer.housing_width=12 mm",
    ],
    "ring 3.6 mm, three lines": [
        *RING, "outer.support=lines", 'outer.line_azimuths=["60 deg", "180 deg", "300 deg"]',
    ],
    "planet rim 3.6 mm": [
        *RING, "outer.support=planet", *TEETH, 'outer.tooth_tangential=["9800 N", "-9800 N"]',
    ],
    "shaft 0.8 mm": ["outer.kind=rigid", "inner.shaft_thickness=0.8 mm", *SECTION],
    "fit of 60 um": [*FIT, "bearing.fits.shaft_interference=60 um"],
    "fit near lift-off": [*FIT, "bearing.fits.shaft_interference=20 um"],
    "fit lifted off, 50 kN": [*FIT, "bearing.fits.shaft_interference=10 um", "operation.radial_load=50 kN"],
}  # fmt: skip


@dataclass(frozen=True)
class Run:
    """How a method ended on a case."""

    iterations: int
    status: str
    seconds: float
    apart: float  # largest difference of a load from newton's over the largest load
    note: str = ""


@dataclass(frozen=True)
class Row:
    """A case with all methods."""

    name: str
    radius: float  # spectral radius of the exchange at newton's solution
    runs: dict[str, Run]


@dataclass(frozen=True)
class Pair:
    """Both partners of a case and its equilibrium between rigid raceways."""

    bearing: BearingPartner
    rings: object
    rigid: object
    methods: tuple[str, ...] = METHODS

    def run(self, method: str, start=None):
        """Last iteration of a method, and the seconds that it took."""
        began, ending = time.perf_counter(), StoppingCriterion(tolerance=TOLERANCE, limit=LIMIT)
        given = self.bearing, self.rings, start or self.rigid, ending
        rule = partial(relaxed, relaxation=0.1) if method == "relaxed" else RULES.get(method)
        *_, last = newton(*given) if rule is None else fixed_point(*given, rule)
        return last, time.perf_counter() - began


def pairs(words: list[str]) -> Iterator[tuple[str, Pair]]:
    for name, settings in CASES.items():
        if words and not any(word in name for word in words):
            continue
        case = read_case(CASE, settings)
        bearing = BearingPartner(roller_bearing.bearing(case))
        rings = condensed_raceways(case, bearing.model.bearing.azimuths, Logged())
        # Every iteration of a fit solves its contact: too long for a constant relaxation.
        methods = METHODS[:-1] if "fit" in name else METHODS
        yield name, Pair(bearing, rings, bearing.solve(), methods)


def compared(name: str, pair: Pair) -> Row:
    last, seconds = pair.run("newton")
    runs = {"newton": Run(last.number, last.status, seconds, 0.0)}
    for method in pair.methods[1:]:
        other, seconds = pair.run(method)
        apart = difference(other.state, last.state)
        note = ""
        if other.status == last.status == "converged" and apart > SAME:
            again, _ = pair.run("newton", other.state)
            stays = again.status == "converged" and difference(again.state, other.state) <= SAME
            note = "another equilibrium" if stays else "newton leaves it"
        runs[method] = Run(other.number, other.status, seconds, apart, note)
    radius = spectral_radius(last.state) if last.status == "converged" else np.nan
    return Row(name, radius, runs)


def difference(state, other) -> float:
    return float(np.abs(state.loads - other.loads).max() / other.loads.max())


def spectral_radius(state) -> float:
    r"""Of the plain exchange at a state that newton found, C dQ/dw.

    The bearing's own matrix, solved for residuals of the deviations, answers with (1 - C dQ/dw)^-1.
    """
    balance = state.balance
    first = balance.layout.fields_end
    count = balance.layout.size - first
    sides = np.zeros((1, balance.layout.size, count))
    sides[0, first:] = np.eye(count) / LARGE_DEVIATION
    answer = bordered_system.solve(balance, state.system, sides)[0, first:]
    return float(np.abs(1 - 1 / np.linalg.eigvals(answer)).max())


def softened() -> list[Row]:
    """The same bearing on cages of growing softness."""
    case = read_case(CASE, CAGE)
    bearing = BearingPartner(roller_bearing.bearing(case))
    azimuths = bearing.model.bearing.azimuths
    cage = condensed_raceways(case, azimuths, Logged()).outer.linearised(np.zeros(0))
    rows = []
    for factor in SOFTNESS:
        softer = replace(cage, absolute=factor * cage.absolute, translation=factor * cage.translation)
        pair = Pair(bearing, RacewayPair(RigidRaceway(azimuths), CondensedRaceway(softer)), bearing.solve())
        rows.append(compared(f"24 bars, {factor:g} times as soft", pair))
    return rows


def line(row: Row) -> str:
    words = [f"{row.name:29s} {row.radius:7.2g}"]
    for run in row.runs.values():
        count = str(run.iterations) if run.status == "converged" else run.status
        apart = f" {run.apart:.0e}" if run.apart else ""
        words.append(
            f"{count:>4} {1e3 * run.seconds:5.0f} ms{apart}" + (f" ({run.note})" if run.note else "")
        )
    return " | ".join(words)


def verdict(rows: list[Row]) -> str:
    counts = [row.runs["newton"].iterations for row in rows if row.runs["newton"].status == "converged"]
    others = [
        run for row in rows for run in list(row.runs.values())[1:]
        if run.status == row.runs["newton"].status == "converged"
    ]  # fmt: skip
    same = [run.apart for run in others if run.note != "another equilibrium"]
    tried, elsewhere = sum(len(row.runs) - 1 for row in rows), len(others) - len(same)
    return (
        f"newton: {len(counts)} of {len(rows)} converge, median {median(counts):g} iterations "
        f"(wanted {USUAL}), at most {max(counts)} (wanted {MOST})\n"
        f"others: {len(others)} of {tried} converge, at most {max(same):.1e} of the "
        f"largest load from newton (wanted {SAME:g}); {elsewhere} at another equilibrium"
    )


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("words", nargs="*")
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    print(describe())
    print(f"{'case':29s} {'rho':>7} | " + " | ".join(METHODS))
    with threadpool_limits(limits=1, user_api="blas"):
        rows = []
        for name, pair in pairs(asked.words):
            rows.append(compared(name, pair))
            print(line(rows[-1]), flush=True)
        print(verdict(rows))
        if not asked.words:
            print("growing softness:", *map(line, softened()), sep="\n")
    if asked.picture:
        draw(rows, asked.picture)


def draw(rows: list[Row], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(figsize=(8, 5), layout="constrained")
    colours = ("#4477aa", "#228833", "#ccbb44", "#ee6677", "#aa3377")
    top = max(run.iterations for row in rows for run in row.runs.values() if run.status == "converged")
    for place, (method, colour) in enumerate(zip(METHODS, colours, strict=True)):
        tried = [row for row in rows if method in row.runs]
        good = [row for row in tried if row.runs[method].status == "converged"]
        bad = [row for row in tried if row.runs[method].status != "converged"]
        counts = [row.runs[method].iterations for row in good]
        axes.scatter([row.radius for row in good], counts, color=colour, s=22, label=method)
        high = [top * 1.6 * 1.2**place] * len(bad)  # failures in rows of their own
        axes.scatter([row.radius for row in bad], high, color=colour, marker="x", s=30)
    axes.axhline(top * 1.35, color="0.7", lw=0.8)
    axes.text(0.01, 0.985, "not converged", transform=axes.transAxes, va="top", color="0.4")
    axes.set(xscale="log", yscale="log", xlabel="spectral radius of the exchange", ylabel="iterations")
    axes.legend(loc="center left", bbox_to_anchor=(0.02, 0.52), ncols=2, fontsize=9)
    figure.savefig(path, dpi=130)


if __name__ == "__main__":
    main()
