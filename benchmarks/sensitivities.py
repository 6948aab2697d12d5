"""Derivatives against cases that are solved again, and what they cost: `python -m benchmarks.sensitivities`.

Sixty cases drawn from a seed about six bearings, rigid and flexible, and fifteen keys of each; every
derivative against central differences of equilibria that are solved again, as far as Newton's method goes.
Where a key does not reach an output, by the derivative and by these differences, both are rounding. Then
the time of derivatives of the unknowns and of outputs by a key, over a flexible solve from the rigid start
without files, side by side in one run.
"""

import sys
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from flexbearing.api import read_case
from flexbearing.case import BadCase
from flexbearing.case.roller import Case
from flexbearing.derivatives.keys import RELATIVE_STEP, Key, given_keys, with_value
from flexbearing.derivatives.ring_slopes import shape_of
from flexbearing.derivatives.roller_slopes import Difference, RollerSlopes, numbers
from flexbearing.derivatives.roller_state import SolvedState, solved
from flexbearing.derivatives.rollers import difference, differentiated, requested_of
from flexbearing.derivatives.sides import STENCILS, Stencil
from flexbearing.derivatives.table import NEGLIGIBLE
from flexbearing.outputs import RequestedOutput
from flexbearing.rings.condensed import RACES
from quasidynamic import Equilibrium, ImpossiblePart, NotSolved, OutOfRange

Answer = TypeVar("Answer")
SEED, CASES, KEYS, RUNS = 20261123, 60, 15, 15
OF = ("life_L10", "max_roller_load", "cage_slip", "stiffness_zz", "peak_pressure.inner", "minimum_film.inner")
ACCURATE = 1e-5  # relative difference of derivatives
# Cases solved again: farther away for the tolerance of Newton's method, hence differences of fourth order.
FARTHER = 5  # steps
FOURTH_ORDER = Stencil((-2.0, -1.0, 1.0, 2.0), (1 / 12, -2 / 3, 2 / 3, -1 / 12))
SMALLEST = 1e-3  # elasticity: derivatives below are measured against it
RIGID = ("inner.kind=rigid", "outer.kind=rigid")
KINDS = {  # settings by name of the kind
    "paper, rigid": ("configs/mao2016.toml", RIGID),
    "paper, flexible": ("configs/mao2016.toml", ()),
    "NU 209, rigid": ("configs/nu209.toml", RIGID),
    "NU 209 in fits, rigid": ("configs/nu209_fits.toml", ()),
    "ring of a beam": (
        "configs/mao2016.toml", ("inner.kind=rigid", "outer.kind=ring", "accuracy.structure=beam"),
    ),
    "paper, tilted": ("configs/mao2016.toml", ("operation.tilt=fixed", "operation.misalignment=1 mrad")),
}  # fmt: skip


@dataclass(frozen=True)
class Compared:
    """Derivatives of a case and how far they are from those of cases solved again."""

    kind: str
    errors: np.ndarray  # (K, O)
    flagged: np.ndarray  # (K, O)


def main() -> None:
    print(describe())
    count = int(sys.argv[1]) if len(sys.argv) > 1 else CASES
    with threadpool_limits(limits=1, user_api="blas"):
        found = [compared(kind, case) for kind, case in drawn(count)]
        told(found)
        cost()


def drawn(count: int) -> Iterator[tuple[str, Case]]:
    """Cases about those of `KINDS`, in turn; what cannot be or does not converge is drawn again."""
    random = np.random.default_rng(SEED)
    for number in range(count):
        kind = list(KINDS)[number % len(KINDS)]
        path, settings = KINDS[kind]
        base = read_case(path, settings)
        while True:
            changed = {
                "operation.radial_load": (base.operation.radial_load * random.uniform(0.2, 1.3), "N"),
                "operation.inner_speed": (base.operation.inner_speed * random.uniform(0.2, 1.1), "rad/s"),
                "bearing.roller.drop": (base.bearing.roller.drop * random.uniform(0.5, 4), "m"),
            }
            if base.bearing.clearance is not None:
                changed["bearing.clearance"] = (base.bearing.clearance * random.uniform(0.2, 1.2), "m")
            texts = [f"{key}={float(value)!r} {unit}" for key, (value, unit) in changed.items()]
            try:
                case = read_case(path, [*settings, *texts])
                solved(case)
            except (BadCase, NotSolved, ImpossiblePart, OutOfRange):
                continue
            yield kind, case
            break


def apart_from_rings(case: Case) -> list[Key]:
    """Keys that a case states and that leave its meshes as they are; others: `benchmarks.ring_dimensions`."""

    def leaves_rings(key: Key) -> bool:
        changed = with_value(case, key.path, key.value + key.step)
        return all(shape_of(changed, race) == shape_of(case, race) for race in RACES)

    return [key for key in given_keys(case) if leaves_rings(key)]


def compared(kind: str, case: Case) -> Compared:
    """Derivatives of a case by fifteen keys that reach its outputs, against equilibria solved again."""
    state, wanted = solved(case), requested_of(case, OF)
    found = differentiated(state, wanted, apart_from_rings(case))
    reaching = [key.path for key in found.keys if any(found[each.name, key.path].reaches for each in wanted)]
    chosen = np.random.default_rng(SEED).permutation(len(reaching))[:KEYS]
    errors, flagged = [], []
    for key in (key for key in found.keys if key.path in {reaching[place] for place in chosen}):
        slopes = [found[output.name, key.path] for output in wanted]
        slope = np.array([each.slope for each in slopes]) / key.size
        values = np.array([each.output.value for each in slopes])
        again = solved_again(state, key, wanted)
        size = np.abs(values) / max(abs(key.value), key.step / RELATIVE_STEP)
        error = np.abs(slope - again) / np.maximum(np.abs(again), SMALLEST * size)
        unreached = ~np.array([each.reaches for each in slopes]) & (np.abs(again) <= NEGLIGIBLE * size)
        errors.append(np.where(unreached, 0.0, error))
        flagged.append([each.one_sided or each.jumps for each in slopes])
    return Compared(kind, np.array(errors), np.array(flagged))


def solved_again(state: SolvedState, key: Key, wanted: Sequence[RequestedOutput]) -> np.ndarray:
    """Derivatives (O) by a key in SI, by differences of equilibria that Newton's method finds."""
    for stencil in (FOURTH_ORDER, *STENCILS):
        places = [FARTHER * place for place in stencil.places]
        if all(map(key.allows, places)):
            try:
                ends = [state.moved(key, place) for place in places]
            except (ImpossiblePart, OutOfRange):
                continue
            values = [numbers(end, wanted, aligned=end.base.aligned) for end in ends]
            return np.tensordot(stencil.weights, np.array(values), 1) / (FARTHER * key.step)
    raise ValueError(f"{key.path}: no differences")


def told(found: Sequence[Compared]) -> None:
    """Print how many derivatives agree, by kind and together."""
    print(f"{len(found)} cases, {KEYS} keys at most, {len(OF)} outputs: {', '.join(OF)}")
    for kind in (*KINDS, "all"):
        some = [each for each in found if kind in (each.kind, "all")]
        errors = np.concatenate([each.errors.ravel() for each in some])
        flagged = np.concatenate([each.flagged.ravel() for each in some])
        good, rest = errors[~flagged] <= ACCURATE, errors[~flagged]
        print(
            f"{kind}: {len(errors)} derivatives, {flagged.sum()} flagged; of the others "
            f"{100 * good.mean():.2f} % within {ACCURATE:g}, median {np.median(rest):.1e}, "
            f"99 % {np.quantile(rest, 0.99):.1e}, largest {rest.max():.1e}; "
            f"not within and not flagged: {(~good).sum()}"
        )


def cost() -> None:
    """Print times by a key over that of a flexible solve from the rigid start."""
    case = read_case("configs/mao2016.toml")
    state = solved(case)
    by = [key for key in apart_from_rings(case) if isinstance(difference(state, key), Difference)]
    main, every = requested_of(case, ()), requested_of(case, ("all",))
    rows = []
    for _ in range(RUNS):
        rigid = state.base.model.solve()
        *_, solve = timed(lambda start=rigid: flexible(state, start))
        differences, building = timed(lambda: [difference(state, key) for key in by])
        slopes = RollerSlopes(state, [each for each in differences if isinstance(each, Difference)])
        _, unknowns = timed(lambda one=slopes: one.by_step)
        _, of_main = timed(lambda one=slopes: one.outputs(main))
        _, of_all = timed(lambda one=slopes: one.outputs(every))
        each = np.array([building + unknowns, of_main, of_all]) / len(by)
        rows.append([solve, *each])
    solve, unknowns, of_main, of_all = np.median(rows, axis=0)
    print(
        f"{len(by)} keys, {RUNS} runs, medians: flexible solve {1e3 * solve:.1f} ms; by a key: unknowns "
        f"{1e3 * unknowns:.2f} ms, {100 * unknowns / solve:.1f} %; with the four main outputs "
        f"{100 * (unknowns + of_main) / solve:.1f} %, with all {len(every)} outputs "
        f"{100 * (unknowns + of_all) / solve:.1f} %"
    )


def flexible(state: SolvedState, start: Equilibrium) -> Equilibrium:
    """Newton's method between the rings of a state, from between rigid raceways."""
    pair = state.base.pair
    *_, last = state.base.model.iterate(pair.compliance, start, pair.initial_deviation)
    return last


def timed(job: Callable[[], Answer]) -> tuple[Answer, float]:
    """What a job returns, and its processor time [s]."""
    began = time.process_time()
    return job(), time.process_time() - began


if __name__ == "__main__":
    main()
