"""A compiled kernel of the roller's laws against NumPy: `python -m benchmarks.compiled_kernel` (needs `cc`).

Load law, traction of 4109 oil, their derivatives and their sums over slices in C, and the elimination of a
roller's own unknowns, on the arrays of the last evaluation of the paper's bearing; one case and many.
"""

import ctypes
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from unittest.mock import patch

import numpy as np
from numpy.typing import NDArray
from threadpoolctl import threadpool_limits

from benchmarks.bearings import CASE
from benchmarks.machine import describe, median_seconds
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from quasidynamic.contact.raceways import Raceways
from quasidynamic.solve.rollers import bordered_system

CASES, RUNS, SUMS = (1, 16, 200), 101, 6
SOURCE = r"""
#include <math.h>
void laws(int places, int slices, const double *approach, const double *sliding, const double *entrainment,
          const double *coefficient, const double *drop, const double *widths, double rounding,
          const double *per_load, const double *powers, const double *slopes, double *sums) {
  for (int r = 0; r < 2; r++) for (int i = r * places; i < (r + 1) * places; i++) {
    double u = entrainment[i], slip = fabs(sliding[i]) / u, sign = (sliding[i] > 0) - (sliding[i] < 0);
    double base[3], *sum = sums + 6 * i;
    for (int j = 0; j < 3; j++) base[j] = powers[4 * j + r] + powers[4 * j + 2] * log(u);
    for (int k = 0; k < slices; k++) {
      double g = approach[i] - drop[2 * k + r], root = sqrt(g * g + rounding * rounding);
      double closed = (g > 0 ? g : 0) + rounding * rounding / 2 / (root + fabs(g));
      double q = coefficient[r] * exp(log(closed) / 9) * closed, stiff = 10. / 9 * q / root;
      double share = q * per_load[r], squared = share * share, load = log(1 + squared);
      double d = exp(base[0] + powers[3] * load), b = exp(base[1] + powers[7] * load);
      double c = exp(base[2] + powers[11] * load), decay = exp(-c * slip), fading = d * decay;
      double steep = b * decay, climb = steep * slip, plateau = d - fading, falling = (fading - climb) * c;
      double curve = plateau + climb, w = widths[k];
      double by_load = slopes[0] * plateau + slopes[1] * climb + slopes[2] * falling * slip;
      double by_speed = slopes[3] * plateau + slopes[4] * climb + slopes[5] * falling * slip;
      sum[0] += w * q;
      sum[1] += w * stiff;
      sum[2] += w * sign * q * curve;
      sum[3] += w * sign * (curve + by_load * squared / (1 + squared)) * stiff;
      sum[4] += w * q / u * (falling + steep);
      sum[5] += w * sign * q / u * by_speed;
    }
  }
}
void eliminate(double *table, int rows, int columns, int places, int pivots) {
  for (int p = 0; p < pivots; p++) for (int a = p + 1; a < rows; a++) for (int c = p + 1; c < columns; c++) {
    double *to = table + (a * columns + c) * places, *from = table + (p * columns + c) * places;
    double *left = table + (a * columns + p) * places, *pivot = table + (p * columns + p) * places;
    for (int i = 0; i < places; i++) to[i] -= left[i] / pivot[i] * from[i];
  }
}
"""


def main() -> None:
    print(describe())
    if (compiler := shutil.which("cc")) is None:
        raise SystemExit("a C compiler `cc` is needed")
    raceways, inputs, table, pivots = last_evaluation()
    with TemporaryDirectory() as folder, threadpool_limits(limits=1, user_api="blas"):
        code, library = Path(folder) / "kernel.c", Path(folder) / "kernel.so"
        code.write_text(SOURCE)
        options = [
            "-O3",
            "-march=native",
            "-ffast-math",
            "-shared",
            "-fPIC",
            "-o",
            str(library),
            str(code),
            "-lm",
        ]
        subprocess.run([compiler, *options], check=True)
        compiled = ctypes.CDLL(str(library))
        for cases in CASES:
            approach, *others = (np.repeat(each, cases, axis=-2) for each in inputs)
            numpy, kernel = laws(compiled, raceways, approach, *others[:2], others[2])
            rows = np.repeat(table, cases, axis=2)
            gauss, kernel_gauss = elimination(compiled, rows, pivots)
            print(
                f"{cases} cases: laws and sums {numpy * 1e6:.0f} us by NumPy, {kernel * 1e6:.0f} us in C; "
                f"elimination {gauss * 1e6:.0f} and {kernel_gauss * 1e6:.0f} us"
            )
        alone = roller_bearing.bearing(read_case(CASE))
        solve = seconds(lambda: replace(alone).solve())
        print(f"a solve of {replace(alone).solve().number} evaluations: {solve * 1e6:.0f} us")


def last_evaluation() -> tuple[Raceways, tuple[NDArray, ...], NDArray, int]:
    """Raceways, their inputs, and the table of a Newton step with its pivots, of the paper's bearing."""
    states, tables = [], []
    state, eliminate = Raceways.state, bordered_system.eliminate
    with (
        patch.object(Raceways, "state", lambda *given: states.append(given) or state(*given)),
        patch.object(
            bordered_system,
            "eliminate",
            lambda table, pivots: tables.append((table.copy(), pivots)) or eliminate(table, pivots),
        ),
    ):
        roller_bearing.bearing(read_case(CASE)).solve()
    raceways, *inputs = states[-1]
    return raceways, tuple(inputs), *tables[-1]


def laws(
    compiled: ctypes.CDLL,
    raceways: Raceways,
    approach: NDArray,
    sliding: NDArray,
    speed: NDArray,
    film: NDArray,
) -> tuple[float, float]:
    """Seconds of laws and sums by NumPy and in C, of aligned rollers, whose loads must be equal."""
    slices, traction, law = raceways.slices, raceways.traction, raceways.law
    places, sums = sliding[0].size, np.zeros((*sliding.shape, SUMS))
    powers = np.array([[*np.ravel(ln), by_speed, by_load] for ln, by_speed, by_load in traction._logarithmic])
    drop = raceways.drop.reshape(len(slices.widths), 2)
    arrays = approach[:, 0], sliding, speed, np.ravel(law.coefficient), drop, slices.widths
    constants = np.ravel(traction._per_smallest_load), powers, traction._LOG_SLOPES
    kept = [np.ascontiguousarray(each) for each in (*arrays, *constants, sums)]
    given = [each.ctypes.data_as(ctypes.c_void_p) for each in kept]
    count, rounding = len(slices.widths), ctypes.c_double(law.rounding)

    def in_c() -> None:
        compiled.laws(places, count, *given[:6], rounding, *given[6:])

    def by_numpy() -> NDArray:
        load, stiffness = law(slices.spread(approach.swapaxes(0, 1)) - raceways.drop)
        pull = traction(load, sliding, speed, film)
        slices.paired(stiffness), slices.summed(pull.by_load * stiffness)
        for each in (pull.force, pull.by_sliding, pull.by_entrainment, pull.by_film):
            slices.total(each)
        return slices.summed(load)[0]

    in_c()
    np.testing.assert_allclose(kept[-1][..., 0], by_numpy(), rtol=1e-12)
    return seconds(by_numpy), seconds(in_c)


def elimination(compiled: ctypes.CDLL, table: NDArray, pivots: int) -> tuple[float, float]:
    """Seconds of an elimination by NumPy and in C, less those of copying the table (rows, columns, C, Z)."""
    rows, columns, *places = table.shape

    def in_c() -> None:
        changed = table.copy()
        compiled.eliminate(
            changed.ctypes.data_as(ctypes.c_void_p), rows, columns, int(np.prod(places)), pivots
        )

    copying = seconds(table.copy)
    by_numpy = seconds(lambda: bordered_system.eliminate(table.copy(), pivots))
    return by_numpy - copying, seconds(in_c) - copying


def seconds(work: Callable[[], object]) -> float:
    """Shortest time of some work [s]; both ways are as long as nobody else computes."""
    return median_seconds(work, RUNS)[1]


if __name__ == "__main__":
    main()
