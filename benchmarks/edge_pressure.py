"""Peak pressures of misaligned rollers by half-spaces and by slices: `python -m benchmarks.edge_pressure`.

Against an independent solution on cells that are finer at the ends, `plain_roller_pressure.py` of the tests,
at equal tilt of the contact. Roller and raceway are those of `benchmarks.slicing`.
"""

from collections.abc import Callable

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from benchmarks.pressed_ends import Drawn
from benchmarks.slicing import ARCMIN, DIAMETER, MODULUS, RADIUS, SLICES, Case
from flexbearing.findings.running import PRESSED_ENDS
from quasidynamic.contact.line import fujiwara_kawase, johns_gohar, peak_pressure
from quasidynamic.outcome.life import edge_stress_factor
from quasidynamic.outcome.sliced_peak import CELLS, SlicedPeak
from quasidynamic.parts.profile import Crowned, Logarithmic, Profile, Straight, TangentCrowned
from tests.reference.plain_roller_pressure import PlainPressure, plain_pressure

FINE = (16, 96)
LENGTH = DIAMETER
LOAD = 2 * np.pi * RADIUS * 2e9**2 / MODULUS * LENGTH  # [N] design load, 2 GPa if it were spread evenly
PROFILES: dict[str, Callable[[], Profile]] = {
    "straight": Straight,
    "rounded ends": lambda: TangentCrowned(straight_length=LENGTH - 1.6e-3, crown_radius=40e-3),
    "crowned": lambda: Crowned(straight_length=0.0, crown_radius=LENGTH**2 / 8 / 15e-6),
    "tangent crowned": lambda: TangentCrowned(straight_length=0.5 * LENGTH, crown_radius=0.15625),
    "iso16281": lambda: Logarithmic(amplitude=0.00035 * DIAMETER),
    "johns_gohar": lambda: johns_gohar(LOAD, LENGTH, MODULUS, RADIUS),
    "fujiwara_kawase": lambda: fujiwara_kawase(
        LOAD, LENGTH, MODULUS, load_factor=1.5, crowned_share=0.8, end_drop=30e-6
    ),
}
RESOLVED = 0.02  # of the peak pressure, by cells of twice the size: no note
PRESSURES = (1.0, 1.5, 2.5)  # [GPa] of the load spread evenly
PLACES = (0.5, 0.9, 0.95, 0.98)  # of half of the length
TILTS = (0, 4)  # [arcmin] of the contact


class Tried(Case):
    """A roller of `PROFILES` under a load at a tilt."""

    def drop(self, position: np.ndarray) -> np.ndarray:
        """Drop of the profile [m]."""
        return PROFILES[self.name]().drop(position, self.length)

    def plain(self, cells: tuple[int, int] = FINE) -> PlainPressure:
        """The independent solution."""
        return plain_pressure(
            force=self.force, tilt=self.tilt * ARCMIN, radius=RADIUS, length=self.length, modulus=MODULUS / 2,
            drop=self.drop, cells=cells,
        )  # fmt: skip


def row(case: Tried) -> str:
    """Peaks of a case, and which notes are told."""
    plain, whole = case.plain(), case.whole()
    sliced = float(peak_pressure(case.sliced.max(), RADIUS, MODULUS))
    checked = SlicedPeak(0, 0, sliced, case.whole(CELLS))
    told = "end" if checked.at_end else "" if checked.holds else "peak"
    drawn = Drawn(PROFILES[case.name](), case.length, RADIUS, case.force, case.tilt * ARCMIN, SLICES)
    if drawn.indicated(case.sliced) > PRESSED_ENDS.limit:
        told = "pressed"
    cells = [f"{case.pressure / 1e9:g}", f"{case.tilt}'"]
    if plain.at_end:
        cells += ["no bound", "-", "-", "-", "-"]
    else:
        edged = float(peak_pressure((case.sliced * edge_stress_factor(SLICES)).max(), RADIUS, MODULUS))
        errors = (f"{100 * (each / plain.peak - 1):+.1f}" for each in (whole.peak_pressure, sliced, edged))
        cells += [f"{plain.peak / 1e9:.2f}", f"{2 * abs(plain.place) / case.length:.2f}", *errors]
    unresolved = abs(whole.peak_pressure / checked.whole.peak_pressure - 1) > RESOLVED
    of_whole = "end" if any(whole.at_ends) else "cells" if unresolved else ""
    return f"| {case.name} | " + " | ".join([*cells, of_whole or "-", told or "-"]) + " |"


def near_a_sharp_end(pressure: float, tilt: int) -> str:
    """Pressures near the pressed end of a straight roller, and the load of its last slice."""
    case = Tried("straight", LENGTH / DIAMETER, pressure * 1e9, tilt)
    plain, whole = case.plain((16, 128)), case.whole()
    known, found = plain.pressure[0], whole.largest_along
    cells = []
    for place in PLACES:
        at = place * case.length / 2
        of_plain, of_whole = np.interp(at, plain.y, known), np.interp(at, whole.positions, found)
        sliced = float(peak_pressure(np.interp(at, case.places, case.sliced), RADIUS, MODULUS))
        errors = 100 * (of_whole / of_plain - 1), 100 * (sliced / of_plain - 1)
        cells.append(f"{of_plain / 1e9:.2f}, {errors[0]:+.1f}, {errors[1]:+.0f}")
    border = (0.5 - 1 / SLICES) * case.length
    carried = np.cumsum(plain.line_load * plain.widths)
    last = case.force - np.interp(border, plain.y + plain.widths / 2, carried)
    loads = whole.slice_loads(SLICES)[-1], case.sliced[-1]
    of_last = (f"{100 * (load * case.length / SLICES / last - 1):+.1f}" for load in loads)
    return f"| {pressure:g} | {tilt}' | " + " | ".join([*cells, ", ".join([f"{last:.0f}", *of_last])]) + " |"


def main() -> None:
    print(describe())
    columns = ["profile", "GPa", "tilt", "peak [GPa]", "at", "half_space", "slices", "f_k"]
    print("| " + " | ".join([*columns, "note: half_space", "slices"]) + " |")
    print("|---" * 10 + "|")
    with threadpool_limits(limits=1):
        for name in PROFILES:
            for pressure in PRESSURES:
                for tilt in TILTS:
                    print(row(Tried(name, LENGTH / DIAMETER, pressure * 1e9, tilt)), flush=True)

        print("\nStraight: pressure [GPa] at places, errors of half-spaces and slices [%]; last slice [N]")
        places = [f"at {place:g}" for place in PLACES]
        print("| " + " | ".join(["straight, GPa", "tilt", *places, "last slice"]) + " |")
        print("|---" * (len(PLACES) + 3) + "|")
        for pressure in PRESSURES:
            for tilt in TILTS:
                print(near_a_sharp_end(pressure, tilt), flush=True)


if __name__ == "__main__":
    main()
