"""Derivatives by ring dimensions on moved nodes against finer meshes: `python -m benchmarks.ring_dimensions`.

Slopes of largest load, life and stiffness of the paper's bearing by dimensions of its squirrel cage and
shaft, on meshes as usual; beside them those of elements of another order and of less than two thirds the
size, on moved nodes and on a mesh of its own for each end of a large step. Then how smooth compliances on
moved nodes are: what is left of a cubic through nine places within half a percent.
"""

import time
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.case.roller import Case
from flexbearing.derivatives.keys import Key, key_of, with_value
from flexbearing.derivatives.ring_slopes import numbers as numbers_of, shape_of, with_numbers
from flexbearing.derivatives.roller_slopes import numbers
from flexbearing.derivatives.roller_state import SolvedState, solved
from flexbearing.derivatives.rollers import differentiated, requested_of
from flexbearing.outputs import RequestedOutput
from flexbearing.program.threads import linear_algebra_alone

PAPER = "configs/mao2016.toml"
OF = ("max_roller_load", "life_L10", "stiffness_zz")
KEYS = (
    "outer.thickness", "outer.bar_width", "outer.bar_length", "outer.width", "inner.shaft_thickness",
    "inner.shaft_length",
)  # fmt: skip
FINE = ("accuracy.element_order=4", "accuracy.mesh_size=1.8 mm", "accuracy.raceway_mesh_size=1.0 mm")
STEP = 0.08  # of a dimension, for meshes of their own: they scatter by 1e-3
SMOOTH = {"outer": "part.bar_width", "inner": "part.rib_diameter"}
WITHIN, PLACES = 5e-3, 9


def main() -> None:
    print(describe())
    with linear_algebra_alone():
        state, fine = solved(read_case(PAPER)), solved(read_case(PAPER, FINE))
        slopes(state, fine)
        smoothness(state)


def slopes(state: SolvedState, fine: SolvedState) -> None:
    """Print elasticities on usual meshes and on finer ones, and the seconds that they take."""
    wanted = requested_of(state.base.case, OF)
    print(f"percent per percent on moved nodes, of finer meshes, of two finer meshes: {', '.join(OF)}")
    for path in KEYS:
        key, began = key_of(state.base.case, path), time.process_time()
        found = differentiated(state, wanted, [key])
        seconds = time.process_time() - began
        finer, both = differentiated(fine, wanted, [key]), meshed_again(fine.base.case, key, wanted)
        rows = [
            f"{found[name, path].elasticity:+.5f} {finer[name, path].elasticity:+.5f} {other:+.5f}"
            for name, other in zip(OF, both, strict=True)
        ]
        print(f"{path}: {'; '.join(rows)}; {seconds:.1f} s", flush=True)


def meshed_again(case: Case, key: Key, wanted: Sequence[RequestedOutput]) -> NDArray:
    """Elasticities (O) between two equilibria with meshes of their own; exact for powers of the key."""
    shares = 1 - STEP, 1 + STEP
    ends = [solved(with_value(case, key.path, key.value * share)) for share in shares]
    low, high = (numbers(end, wanted, aligned=False) for end in ends)
    return np.log(high / low) / np.log(shares[1] / shares[0])


def smoothness(state: SolvedState) -> None:
    """Print how far compliances on moved nodes are from a cubic in a dimension."""
    shares = np.linspace(-WITHIN, WITHIN, PLACES)
    for race, name in SMOOTH.items():
        shape = shape_of(state.base.case, race)
        size, of_shape = numbers_of(shape)[name], state.near.slopes[race].of_shape
        shapes = [with_numbers(shape, {name: size * (1 + share)}) for share in shares]
        values = np.array([of_shape(each).absolute.ravel() for each in shapes])
        cubic = np.polynomial.polynomial.polyfit(shares, values, 3)
        left = values - np.polynomial.polynomial.polyval(shares, cubic).T
        print(f"{race} {name}: {np.abs(left).max() / np.abs(values).max():.1e} of the largest compliance")


if __name__ == "__main__":
    main()
