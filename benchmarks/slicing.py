"""What slicing a roller costs in accuracy, against the whole roller: `python -m benchmarks.slicing`.

A roller on a convex raceway under a load: slices by Palmgren's law, as the bearing model has them, and both
bodies as half-spaces, at equal tilt or at equal moment. Then time against error of the whole roller.
"""

import statistics
import time
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from quasidynamic.contact.half_space import elastic_pair
from quasidynamic.contact.line import LoadLaw, palmgren, peak_pressure, reduced_radius
from quasidynamic.contact.pressure.roller import CELLS, RollerOnRaceway, RollerPressure
from quasidynamic.parts.material import Material, contact_modulus
from quasidynamic.parts.profile import Crowned, Logarithmic, Profile, Straight

STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
DIAMETER, RACEWAY = 10e-3, 27.5e-3  # [m] of the roller, radius of the raceway: the 209 bearing
RADIUS = reduced_radius(DIAMETER / 2, RACEWAY)
MODULUS = contact_modulus(STEEL, STEEL)
SLICES = 30
ARCMIN = np.pi / 180 / 60
PROFILES = ("straight", "crowned", "crowned ends", "logarithmic")
CORNER = "crowned ends"  # its circular ends meet the straight middle with a corner
FINEST = (64, 2048)
RUNS = 11


def profile(name: str, length: float) -> Profile:
    """Crown 15 um deep at the ends; crowned ends, 5 um, are the last fifths; logarithmic of ISO/TS 16281."""
    if name == "straight":
        return Straight()
    if name == "logarithmic":
        return Logarithmic(amplitude=0.00035 * DIAMETER)
    middle, deep = (0.6 * length, 5e-6) if name == CORNER else (0.0, 15e-6)
    return Crowned(straight_length=middle, crown_radius=(length**2 - middle**2) / 8 / deep)


@dataclass(frozen=True)
class Case:
    """A roller under a load at a tilt."""

    name: str
    ratio: float  # length over diameter
    pressure: float  # [Pa] of the load spread evenly
    tilt: float  # [arcmin]

    @property
    def length(self) -> float:
        """Length [m]."""
        return self.ratio * DIAMETER

    @property
    def force(self) -> float:
        """Load [N]."""
        return 2 * np.pi * RADIUS * self.pressure**2 / MODULUS * self.length

    def drop(self, position: NDArray) -> NDArray:
        """Drop of the profile [m]."""
        return profile(self.name, self.length).drop(position, self.length)

    def roller(self, cells: tuple[int, int] = CELLS) -> RollerOnRaceway:
        """The roller on half-spaces."""
        pair = elastic_pair(STEEL, STEEL)
        return RollerOnRaceway(pair=pair, radius=RADIUS, length=self.length, drop=self.drop, cells=cells)

    def whole(self, cells: tuple[int, int] = CELLS) -> RollerPressure:
        """Pressure of the whole roller at the tilt."""
        return self.roller(cells).tilted(self.force, self.tilt * ARCMIN)

    @property
    def places(self) -> NDArray:
        """Middles of the slices (K) [m]."""
        return ((np.arange(SLICES) + 0.5) / SLICES - 0.5) * self.length

    @cached_property
    def sliced(self) -> NDArray:
        """Load per length (K) of the slices [N/m]."""
        law = LoadLaw(palmgren(STEEL, STEEL, self.length), 1e-12)
        shape = self.tilt * ARCMIN * self.places - self.drop(self.places)

        def missing(approach: float) -> float:
            return law(approach + shape)[0].mean() * self.length - self.force

        return law(brentq(missing, -1e-3, 1e-3, xtol=1e-15) + shape)[0]

    def at_equal_moment(self) -> RollerPressure:
        """Pressure of the whole roller under the moment of the slices."""
        moment = float(self.sliced @ self.places) * self.length / SLICES
        return self.roller().under(self.force, moment)


def life(loads: NDArray) -> float:
    """Relative life of a contact with slices of these loads."""
    return float((loads**4.5).mean() ** (-8 / 9))


def compared(case: Case, whole: RollerPressure) -> str:
    """Error of the slices' peak pressure, share of load on the wrong slice and error of their life [%]."""
    loads = whole.slice_loads(SLICES)
    peak = float(peak_pressure(case.sliced.max(), RADIUS, MODULUS)) / whole.peak_pressure - 1
    shown = "*" if any(whole.at_ends) or case.name == CORNER else f"{100 * peak:+.1f}"
    misplaced = np.abs(case.sliced - loads).sum() / loads.sum() / 2
    return f"{shown}, {100 * misplaced:.1f}, {100 * (life(case.sliced) / life(loads) - 1):+.0f}"


def table(pressure: float, ratios: tuple[float, ...]) -> None:
    """Rows by profile and tilt, columns by length over diameter."""
    print(f"\nPressure of the load spread evenly {pressure / 1e9:g} GPa. Peak, load misplaced, life [%]")
    print(
        "| profile | tilt | " + " | ".join(f"l/D {ratio:g}" for ratio in ratios) + " | l/D 1, equal moment |"
    )
    print("|---" * (len(ratios) + 3) + "|")
    for name in PROFILES:
        for tilt in (0, 1, 2, 4, 6):
            cases = [Case(name, ratio, pressure, tilt) for ratio in ratios]
            cells = [compared(case, case.whole()) for case in cases]
            middle = cases[ratios.index(1.0)]
            cells.append(compared(middle, middle.at_equal_moment()))
            print(f"| {name} | {tilt}' | " + " | ".join(cells) + " |")


def ends() -> None:
    """What end faces of the roller that are free of shear would change."""
    print(
        "\nEnds of the roller free of shear, l/D 1, 1.5 GPa: load of the last slice over the mean, lives [%]"
    )
    print("| profile | tilt | load at the end | life | life by slices over it |\n|---|---|---|---|---|")
    for name in PROFILES:
        for tilt in (0, 4):
            case = Case(name, 1.0, 1.5e9, tilt)
            half = case.whole().slice_loads(SLICES)
            free = replace(case.roller(), free_ends=0.5).tilted(case.force, tilt * ARCMIN).slice_loads(SLICES)
            last = (free[-1] - half[-1]) / case.force * case.length
            lives = life(free) / life(half) - 1, life(case.sliced) / life(free) - 1
            print(f"| {name} | {tilt}' | {100 * last:+.0f} | {100 * lives[0]:+.0f} | {100 * lives[1]:+.0f} |")


def resolution() -> None:
    """Time and error of the cells, largest over tilts and two loads."""
    print("\nTime [ms of the processor], error of peak pressure and life [%]")
    smooth, sharp = ("crowned", "logarithmic"), ("straight",)
    cases = {
        names: [Case(name, 1.0, p, tilt) for name in names for p in (1.5e9, 2.5e9) for tilt in (0, 2, 4)]
        for names in (smooth, sharp)
    }
    finest = {case: case.whole(FINEST) for some in cases.values() for case in some}
    print("| cells | time | peak, ends apart | life, ends apart | life, straight |\n|---|---|---|---|---|")
    for cells in ((16, 64), (16, 128), (32, 256), CELLS, (32, 1024), (64, 1024)):
        found = {case: case.whole(cells) for case in finest}
        apart = [case for case in cases[smooth] if not any(finest[case].at_ends)]
        peak = max(abs(found[case].peak_pressure / finest[case].peak_pressure - 1) for case in apart)
        smooth_life, sharp_life = (
            max(
                abs(life(found[case].slice_loads(SLICES)) / life(finest[case].slice_loads(SLICES)) - 1)
                for case in some
            )
            for some in (apart, cases[sharp])
        )
        spent = 1e3 * processor_seconds(cases[smooth][-1], cells)
        print(
            f"| {cells[0]} x {cells[1]} | {spent:.0f} | {100 * peak:.2f} | {100 * smooth_life:.3f} | "
            f"{100 * sharp_life:.1f} |"
        )


def processor_seconds(case: Case, cells: tuple[int, int]) -> float:
    """Median time of the processor for one roller [s]."""
    seconds = []
    for _ in range(RUNS):
        began = time.process_time()
        case.whole(cells)
        seconds.append(time.process_time() - began)
    return statistics.median(seconds)


def main() -> None:
    print(describe())
    with threadpool_limits(limits=1):
        for pressure in (1.5e9, 2.5e9):
            table(pressure, (0.5, 1.0, 2.5))
        ends()
        resolution()


if __name__ == "__main__":
    main()
