"""Largest stresses of a plain ring, squirrel cages and an inner ring on its shaft against finer meshes.

Every part is solved as `outputs.stresses` does, then by displacements of two orders more on elements of half
the size; only at the feet of the bars, close to their sharp edges, they are larger in the reference, which
needs 16 GB as it is. Printed is the largest value of each measure and body, the error that is printed beside
it, and the deviation from the reference, in value and azimuth.

    python -m benchmarks.largest_stresses            # minutes
    python -m benchmarks.largest_stresses "24" shaft # some parts only
"""

import sys
from dataclasses import replace
from time import perf_counter, process_time

import numpy as np

import fem
from benchmarks.machine import describe
from fem.section.loaded_section import loaded_section
from fem.solid.clearing import clearing
from fem.solid.extremes import BodyExtremes, extremes
from fem.squirrel_cage.loaded_cage import feet_size, loaded_cage
from flexbearing.runs.fields import FOR_STRESSES

STEEL = fem.Elastic(youngs_modulus=203e9, poisson_ratio=0.28)
CAGE = fem.SquirrelCage(
    raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, bars=24, bar_width=4e-3, bar_thickness=2.6e-3,
    bar_length=10.25e-3, flange_length=5e-3, elastic=STEEL,
)  # fmt: skip
PARTS = {
    "ring": fem.OuterRing(
        raceway_diameter=75e-3, thickness=3.6e-3, width=10e-3, elastic=STEEL, support=fem.ClampedFace()
    ),
    "cage of 24 bars": CAGE,
    "cage of 12 bars": replace(CAGE, bars=12, bar_width=6e-3),
    "cage with fillets": replace(CAGE, bar_thickness=2e-3, fillet=0.7e-3),
    "ring on shaft": fem.RingOnShaft(
        raceway_diameter=65e-3, track_width=6e-3, rib_diameter=69.6e-3, bore=59.6e-3, width=12e-3,
        shaft_bore=51.6e-3, shaft_length=40e-3, ring=STEEL,
        shaft=fem.Elastic(youngs_modulus=179e9, poisson_ratio=0.281),
    ),
}  # fmt: skip
LENGTH, ROLLERS, LOAD = 5e-3, 30, 2500.0  # of the rollers [m], their number, the largest load [N]
MEASURES = "von_mises", "tension", "compression"


def loads(inwards: bool) -> tuple[fem.Patches, np.ndarray]:
    """Rollers of the main case, loaded like a cosine on 200 degrees, a little more on one side and end."""
    azimuths = 2 * np.pi * np.arange(ROLLERS) / ROLLERS
    zone = np.clip(np.cos(0.9 * np.angle(np.exp(1j * azimuths))), 0, None) * (1 + 0.1 * np.sin(azimuths))
    forces = LOAD * zone[:, None] * [1.0, 0.05, 0.0] * (-1 if inwards else 1)
    return fem.Patches(azimuths=tuple(azimuths), length=LENGTH, axial_modes=3, width=0.1 * LENGTH), forces


def solved(part, mesh: fem.MeshSize, feet: float) -> dict[str, BodyExtremes]:
    """Largest values of every body."""
    patches, forces = loads(isinstance(part, fem.RingOnShaft))
    if isinstance(part, fem.SquirrelCage):
        sampled = loaded_cage(part, patches, forces, mesh, feet)
    else:
        sampled = loaded_section(part, patches, forces, mesh)
    clear = clearing(part, patches, forces, part.raceway_diameter / 2)
    return {body: extremes(sampled, body, clear) for body in part.materials}


def compared(name: str) -> bool:
    """Print a part beside its reference; whether deviations, errors and places are as promised."""
    part = PARTS[name]
    order, size, raceway_size = FOR_STRESSES[type(part)]
    usual = fem.MeshSize(order=order, size=size * LENGTH, raceway_size=raceway_size * LENGTH)
    finer = replace(usual, order=order + 2, size=usual.size / 2, raceway_size=usual.raceway_size / 2)
    feet = feet_size(part) if isinstance(part, fem.SquirrelCage) else 0.0
    began, used = perf_counter(), process_time()
    found = solved(part, usual, feet)
    cost = f"{perf_counter() - began:.1f} s, {process_time() - used:.1f} s of processor"
    print(f"{name}: {cost}", flush=True)
    reference, good = solved(part, finer, FINER_FEET * feet), True
    for body, most in found.items():
        for measure in MEASURES:
            value, exact = getattr(most, measure), getattr(reference[body], measure)
            off = abs(value.value - exact.value)
            turned = abs(np.degrees(np.angle(np.exp(1j * (value.azimuth - exact.azimuth)))))
            error = value.error / abs(value.value)
            holds = off <= value.error and error <= LARGEST_ERROR and turned <= LARGEST_TURN
            good &= holds
            print(
                f"  {body:7s} {measure:12s} {value.value / 1e6:9.1f} +- {value.error / 1e6:5.1f} MPa "
                f"({100 * error:4.1f} %), reference {exact.value / 1e6:9.1f}, "
                f"deviation {100 * off / abs(exact.value):4.2f} %, {turned:5.1f} deg"
                + ("" if holds else "  OUTSIDE"),
                flush=True,
            )
    return good


FINER_FEET = 1.6  # size of elements at the feet over the usual one: the order does the rest, and is dear
LARGEST_ERROR, LARGEST_TURN = 0.05, 3.0  # printed error over the value; between places [deg]


def main() -> int:
    """Compare the parts that are named, or all."""
    print(describe(), flush=True)
    names = [name for name in PARTS if not sys.argv[1:] or any(word in name for word in sys.argv[1:])]
    return 0 if all([compared(name) for name in names]) else 1


if __name__ == "__main__":
    sys.exit(main())
