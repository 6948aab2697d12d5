"""Hard cases, what must happen and what does: `python -m benchmarks.hard_cases [--picture FILE]`."""

import argparse
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.bearings import RPM, changed, paper_bearing
from benchmarks.machine import describe
from quasidynamic import FourPointCurve, NotSolved, RollerBearing, SolverOutcome, solve_many
from quasidynamic.contact.traction import Traction

LOADED = 3e-4  # of the largest inner load


@dataclass(frozen=True)
class Row:
    """One hard case."""

    name: str
    model: RollerBearing
    expected: str
    holds: Callable  # of the equilibrium


@dataclass(frozen=True, kw_only=True)
class NearlyCoulomb:
    """Friction that rises with a slope of 50 per slide-to-roll ratio to 0.05: nearly a sign function."""

    slope: float = 50.0
    limit: float = 0.05

    def __call__(self, line_load, sliding, entrainment, film):
        steep = self.slope * sliding / (entrainment * self.limit)
        root = np.sqrt(1 + steep**2)
        friction, slope = self.limit * steep / root, self.limit / root**3
        zero = np.zeros_like(line_load * friction)
        by_sliding = line_load * slope * self.slope / (entrainment * self.limit)
        by_entrainment = -line_load * slope * steep / entrainment
        return Traction(line_load * friction, friction, by_sliding, by_entrainment, zero)


def loaded(state) -> int:
    return int((state.loads[0] > LOADED * state.loads[0].max()).sum())


def rows() -> list[Row]:
    paper = paper_bearing()
    few = {"first_roller_azimuth": 0.0}
    wide = changed(
        paper,
        rollers=300,
        outer_raceway_diameter=0.6,
        inner_speed=4000 * RPM,
        radial_load=1e5,
    )
    return [
        *(
            Row(
                f"{load:g} N at 38 000 rpm",
                changed(paper, radial_load=load),
                "slip 80 to 97 % (within 1), 2 to 3 rollers loaded",
                lambda s: 0.79 < s.cage_slip < 0.98 and 2 <= loaded(s) <= 3,
            )
            for load in (5.0, 50.0, 200.0, 500.0)
        ),
        *(
            Row(
                f"{count} rollers, one of them under the load",
                changed(paper, rollers=count, **few),
                "ring moves aside until a second roller is loaded",
                lambda s: loaded(s) >= 2 and abs(s.ring_displacement[0]) > 1e-6,
            )
            for count in (3, 4)
        ),
        Row(
            "4 rollers, load between two",
            changed(paper, rollers=4, first_roller_azimuth=np.pi / 4),
            "both loaded alike",
            lambda s: loaded(s) == 2 and np.ptp(np.sort(s.loads[0])[-2:]) < 0.05 * s.loads[0].max(),
        ),
        Row(
            "30 rollers, load between two",
            changed(paper, first_roller_azimuth=np.pi / 30),
            "10 loaded",
            lambda s: loaded(s) == 10,
        ),
        Row("300 rollers", wide, "solves", lambda s: loaded(s) > 30),
        Row(
            "nearly Coulomb friction, slope 50",
            changed(paper, traction=lambda **pair: NearlyCoulomb()),
            "slip about 1e-4 to 1e-3",
            lambda s: 1e-5 < s.cage_slip < 2e-3,
        ),
        Row(
            "preload of 40 um, no load",
            changed(paper, clearance=-40e-6, radial_load=0.0),
            "all 30 loaded, slip about 1.7 %",
            lambda s: loaded(s) == 30 and abs(s.cage_slip - 0.017) < 0.004,
        ),
        Row("1 rpm", changed(paper, inner_speed=RPM), "slip 0", lambda s: abs(s.cage_slip) < 1e-4),
        *(
            Row(
                f"{speed / 1e3:g} 000 rpm",
                changed(paper, inner_speed=speed * RPM),
                f"slip about {slip} %",
                lambda s, slip=slip: abs(100 * s.cage_slip - slip) < 6,
            )
            for speed, slip in ((6e4, 28), (8e4, 46), (15e4, 72))
        ),
        *(
            Row(
                f"tilting moment {moment:g} N m",
                changed(paper, moment=moment, free_tilt=True),
                f"about {count} loaded",
                lambda s, count=count: abs(loaded(s) - count) <= 1,
            )
            for moment, count in ((20.0, 11), (60.0, 24), (200.0, 26))
        ),
    ]


def solve_all() -> list[tuple]:
    """Run the table; returns name, expected, found, whether it holds, evaluations, seconds."""
    found = []
    for row in rows():
        began = time.perf_counter()
        state = solve_many([row.model])[0]
        seconds = time.perf_counter() - began
        text = (
            f"slip {100 * state.cage_slip:.3g} %, {loaded(state)} loaded, "
            f"max {state.loads[0].max():.4g} N, aside {1e6 * state.ring_displacement[0]:.3g} um"
        )
        solved = state.status is SolverOutcome.CONVERGED
        found.append(
            (
                row.name,
                row.expected,
                text if solved else state.failure(),
                solved and bool(row.holds(state)),
                state.number,
                seconds,
            )
        )
    return [idle(), *found, soft_ring(), falling()]


def idle() -> tuple:
    """No load and clearance."""
    try:
        changed(paper_bearing(), radial_load=0.0).solve()
    except NotSolved as failure:
        named = failure.outcome == SolverOutcome.UNDETERMINED
        return "no load, clearance", "position undetermined, by name", failure.outcome, named, 0, 0.0
    return "no load, clearance", "position undetermined, by name", "an answer", False, 0, 0.0


def soft_ring(foundation: float = 100e6) -> tuple:
    """Outer ring, 3.6 x 5 mm, that bends on an elastic foundation [N/m per m of arc, Pa]."""
    paper = paper_bearing()
    rigid = paper.solve()
    count, m = paper.bearing.rollers, paper.axial_modes
    matrix = np.zeros((count, m, count, m))
    matrix[:, 0, :, 0] = ring_on_foundation(paper.bearing.azimuths, foundation)
    began = time.perf_counter()
    states = list(paper.iterate((None, matrix), rigid))
    seconds = time.perf_counter() - began
    last = states[-1]
    good = last.status is SolverOutcome.CONVERGED and loaded(last) == 19
    return (
        "outer ring on a foundation of 100 N/mm2",
        "19 loaded, zone beyond 180 degrees; Newton about 11 steps",
        f"{loaded(last)} loaded, max {last.loads[0].max():.4g} N, {last.number} steps, {last.status}",
        good,
        last.number,
        seconds,
    )


def ring_on_foundation(azimuth: np.ndarray, foundation: float) -> np.ndarray:
    """Radial displacement per radial force (Z, Z) [m/N]: bending harmonics on a Winkler foundation.

    The translation is left out: the support takes it.
    """
    radius, thickness, width, modulus = 39.3e-3, 3.6e-3, 5e-3, 203e9
    bending, area = modulus * width * thickness**3 / 12, width * thickness
    apart = azimuth[:, None] - azimuth
    found = np.full(apart.shape, 1 / (2 * np.pi * radius * (modulus * area / radius**2 + foundation)))
    for n in range(2, 60):
        found += np.cos(n * apart) / (np.pi * radius * (bending * (n**2 - 1) ** 2 / radius**4 + foundation))
    return found


def falling() -> tuple:
    """A traction curve that falls after its maximum: several equilibria at one load."""
    from quasidynamic.trace import equilibria_at

    curve = FourPointCurve.through(at_rest=0.0, peak=0.06, peak_slip=0.01, far=0.02)
    began = time.perf_counter()
    model = changed(paper_bearing(), traction=lambda **pair: curve)
    counts = {}
    for load in np.geomspace(1000.0, 40000.0, 15):
        found = equilibria_at(changed(model, radial_load=float(load)))
        counts[round(float(load))] = [round(100 * state.cage_slip, 2) for state in found]
    seconds = time.perf_counter() - began
    several = {load: slips for load, slips in counts.items() if len(slips) > 1}
    text = "; ".join(f"{load} N: slip {', '.join(map(str, slips))} %" for load, slips in several.items())
    return (
        "falling traction curve",
        "several equilibria in a range of loads, one outside",
        text or "one equilibrium at every load",
        any(len(slips) >= 3 for slips in several.values()),
        0,
        seconds,
    )


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--picture", type=Path)
    asked = parser.parse_args()
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"):
        table = solve_all()
    for name, expected, found, holds, evaluations, seconds in table:
        print(
            f"{'ok  ' if holds else 'MISS'} {name}: expected {expected}; found {found} "
            f"({evaluations} evaluations, {1e3 * seconds:.0f} ms)"
        )
    print(f"{sum(row[3] for row in table)} of {len(table)} as expected")
    if asked.picture:
        draw(table, asked.picture)


def draw(table: list[tuple], path: Path) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    solved = [row for row in table if row[4]]
    figure, axes = plt.subplots(figsize=(8, 0.32 * len(solved) + 1), layout="constrained")
    places = np.arange(len(solved))[::-1]
    axes.barh(
        places, [row[4] for row in solved], color=["#4477aa" if row[3] else "#cc3311" for row in solved]
    )
    axes.set_yticks(places, [row[0] for row in solved])
    axes.set(xlabel="evaluations of the bearing", xscale="log", xlim=(1, 1000))
    for place, row in zip(places, solved, strict=True):
        axes.text(row[4] * 1.1, place, f"{1e3 * row[5]:.0f} ms", va="center", fontsize=8)
    axes.set_title(f"hard cases: {sum(row[3] for row in table)} of {len(table)} as expected")
    figure.savefig(path, dpi=130)


if __name__ == "__main__":
    main()
