"""Static load distribution beside the package tribology: `python -m benchmarks.static_solve`.

Its `fcylrolbear` and ours solve ISO/TS 16281 (DIN 26281) slices between rigid rings in the same run:
the job of the other package's own demonstration, and a profiled bearing of 14 rollers and 30 slices.
That demonstration places 13 rollers at `linspace(0, 2 pi, 13)`, so that the one at 360 degrees stands in
the one at zero and is counted twice; here the 13 rollers are spread evenly, as its text says.

Its lamina law takes the displacement along the load alone, in a loop over rollers and slices; ours
takes both radial directions, so that the load need not point at a roller or between two.
"""

import sys
from importlib.metadata import version

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe, median_seconds
from quasidynamic import Cage, CylindricalRollerBearing, Logarithmic, Material, Roller, Straight
from quasidynamic.contact.line import Slices
from quasidynamic.static import static_loads

INSTALL = "pip install --no-deps tribology==0.5.16 numexpr opencv-python-headless"
STEEL = Material(youngs_modulus=206e9, poisson_ratio=0.3, density=7850)
MM = 1e3
RUNS, ITS_RUNS = 201, 21


def bearing(rollers, outer_raceway, diameter, length, clearance, profile):
    """A bearing of steel, lengths in metres; its cage carries nothing here."""
    return CylindricalRollerBearing(
        rollers=rollers,
        outer_raceway_diameter=outer_raceway,
        clearance=clearance,
        roller=Roller(diameter=diameter, length=length, material=STEEL, profile=profile),
        cage=Cage(guidance="rollers", pocket_friction=0.0, thickness=diameter / 2, mass=0.1),
        inner_ring=STEEL,
        outer_ring=STEEL,
        contact_law="iso16281",
    )


JOBS = {
    "its demonstration": (bearing(13, 80e-3, 10e-3, 10e-3, 18.4e-6, Straight()), 3000.0, 31),
    "14 profiled rollers": (
        bearing(14, 75.032e-3, 10e-3, 9.601e-3, 41e-6, Logarithmic(amplitude=3.5e-6)),
        4450.0,
        30,
    ),
}


def main() -> None:
    print(describe())
    try:
        from tribology.roller_bearings import fcylrolbear
    except ImportError as missing:
        sys.exit(f"the other package is not here ({missing}); install it apart from this project: {INSTALL}")
    print(f"tribology {version('tribology')}")
    with threadpool_limits(limits=1, user_api="blas"):
        for name, (part, load, slices) in JOBS.items():
            beside(name, part, load, slices, fcylrolbear)


def beside(name, part, load, slices, fcylrolbear):
    length = part.roller.length
    drop = part.roller.profile.drop(Slices(slices, length).centres, length)
    # Its axis only sets the number and the whole length of the slices, as long as nothing tilts.
    axis = np.linspace(-length / 2, length / 2, slices)

    def ours():
        return static_loads(part, load, slices=slices)

    def theirs(tolerance=0.0005):
        return fcylrolbear(
            part.azimuths, drop * MM, axis * MM, load, rad_clear=part.clearance * MM, max_dif=tolerance
        )

    own, other = median_seconds(ours, RUNS), median_seconds(theirs, ITS_RUNS)
    found, usual, fine = ours().loads, theirs()[0], theirs(1e-11)[0]
    print(f"{name}: {part.rollers} rollers, {slices} slices, {load:.0f} N")
    print(f"  static_loads {timing(own)}, largest load {found.max():.4f} N")
    print(f"  fcylrolbear  {timing(other)}, largest load {usual.max():.4f} N")
    print(f"  ratio of the medians {other[0] / own[0]:.1f}")
    print(
        f"  largest difference of a roller load: {np.abs(found - usual).max() / load:.1e} of the load at "
        f"its usual tolerance, {np.abs(found - fine).max() / load:.1e} at 1e-11"
    )


def timing(seconds) -> str:
    median, fastest, slowest = (1e3 * second for second in seconds)
    return f"median {median:7.3f} ms ({fastest:.3f} to {slowest:.3f})"


if __name__ == "__main__":
    main()
