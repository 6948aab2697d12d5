"""Random balls and contacts that stick and slip: `python -m benchmarks.random_rolling`.

`--errors N` compares the estimated error of N balls with that against a far finer grid, `--robustness N`
solves N cases, each fifth a single contact at a given creep, the others balls on two to four, and checks what
comes out. Seeds begin at `--first`.
"""

import argparse
import statistics
import time
from collections import Counter
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from quasidynamic.contact.rolling.kalker import kalker
from quasidynamic.contact.rolling.rolling_contact import Rolled
from quasidynamic.errors import NotSolved, OutOfRange
from quasidynamic.solve.balls.refined_rolling import STICKING_ORDER, RefinedRolling
from quasidynamic.solve.balls.rolling_motion import TOLERANCE
from tests import random_contacts
from tests.random_rolling_balls import drawn

CELLS = (20, 40)
FINER = 4  # times as many cells of the reference in each direction
CONTACTS = 5  # each fifth case is a single contact
SMALL = 1e-4  # of the largest traction: what the contacts' tolerance leaves of Coulomb's law
ABOVE = 1e-5  # of the power of full sliding, by rounding


class Judged(NamedTuple):
    """A told error beside the true one, over the torque."""

    seed: int
    told: float
    true: float
    unsure: float  # told error of the reference
    sticks: bool


def main() -> None:
    options = argparse.ArgumentParser()
    options.add_argument("--errors", type=int, default=0, metavar="N")
    options.add_argument("--robustness", type=int, default=0, metavar="N")
    options.add_argument("--first", type=int, default=0, metavar="SEED")
    options.add_argument("--cells", type=int, nargs=2, default=CELLS)
    wanted = options.parse_args()
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"):
        if wanted.errors:
            errors(range(wanted.first, wanted.first + wanted.errors), tuple(wanted.cells))
        if wanted.robustness:
            robustness(range(wanted.first, wanted.first + wanted.robustness), tuple(wanted.cells))


def errors(seeds: range, cells: tuple[int, int]) -> None:
    finer = FINER * cells[0], FINER * cells[1]
    print(f"{cells[0]} by {cells[1]} cells against {finer[0]} by {finer[1]}, in parts of the torque")
    judged = []
    for seed in seeds:
        each = judge(seed, cells, finer)
        judged.append(each)
        words = "" if each.told >= each.true else ", not held"
        print(
            f"    seed {seed}: told {each.told:.2e}, true {each.true:.2e}, reference +- {each.unsure:.0e}, "
            f"{'sticks' if each.sticks else 'slides'}{words}",
            flush=True,
        )
    held = sum(each.told >= each.true for each in judged)
    print(f"the estimated error holds for {held} of {len(judged)}")
    for name, chosen in (
        ("all", judged),
        ("that stick", [each for each in judged if each.sticks]),
        ("that slide", [each for each in judged if not each.sticks]),
    ):
        ratio = np.array([each.told / each.true for each in chosen])
        low, middle, high = np.quantile(ratio, [0.1, 0.5, 0.9]) if chosen else 3 * [np.nan]
        print(
            f"estimated over true, {len(ratio)} {name}: median {middle:.2f}, 80 % in {low:.2f} to {high:.2f}"
        )


def judge(seed: int, cells: tuple[int, int], finer: tuple[int, int]) -> Judged:
    ball, reference = rolled(seed, cells), rolled(seed, finer)
    limit, size = reference.extrapolated_torque, reference.torque
    true, sticks = abs(ball.torque - limit) / size, ball.order == STICKING_ORDER
    return Judged(seed, ball.grid_error / size, true, reference.grid_error / size, sticks)


def rolled(seed: int, cells: tuple[int, int]) -> RefinedRolling:
    bearing, sliding = drawn(seed)
    (ball,) = bearing.roll(sliding, "kalker", cells).rolled
    assert ball is not None  # every ball drawn here is loaded
    return ball


def robustness(seeds: range, cells: tuple[int, int]) -> None:
    endings: dict[int, Counter[str]] = {number: Counter() for number in (1, 2, 3, 4)}
    remarkable, seconds = [], []
    for seed in seeds:
        contacts, solve = case(seed, cells)
        began = time.process_time()
        try:
            ending, words = "solved", solve()
        except (NotSolved, OutOfRange) as error:
            ending, words = type(error).__name__, str(error)
        seconds.append(time.process_time() - began)
        if words and ending == "solved":
            ending = "wrong"
        endings[contacts][ending] += 1
        remarkable += [f"    seed {seed}, {contacts} contacts: {ending}: {words}"] if words else []
    print(f"{len(seeds)} cases from seed {seeds.start} on {cells[0]} by {cells[1]} cells")
    for number, counts in endings.items():
        print(f"    {number} contacts: {dict(counts)}")
    print("\n".join(remarkable) or "    none is remarkable")
    print(f"    mean {1e3 * statistics.mean(seconds):.0f} ms, most {1e3 * max(seconds):.0f} ms", flush=True)


def case(seed: int, cells: tuple[int, int]) -> tuple[int, Callable[[], str]]:
    """Number of contacts, and what solves the case and tells what is wrong with the answer."""
    if seed % CONTACTS == 0:
        contacts, creep = random_contacts.drawn(seed, cells)
        return 1, lambda: against_coulomb(kalker(contacts, creep))
    bearing, sliding = drawn(seed)
    start = np.append(sliding.sliding.motion[0], 0.0)

    def solve() -> str:
        (ball,) = bearing.roll(sliding, "kalker", cells).rolled
        assert ball is not None  # every ball drawn here is loaded
        return against_balance(ball, start) or against_coulomb(ball.fine.rolled)

    return int((sliding.load > 0.0).sum()), solve


def against_balance(ball: RefinedRolling, sliding: np.ndarray) -> str:
    """What is wrong with the balance of a ball, empty if nothing is."""
    state, most = ball.fine, ball.fine.ball.full_sliding_power(sliding)
    left = state.ball.imbalance(state.motion, state.rolled)
    if not left <= TOLERANCE:
        return f"{left:.1e} of the power is unbalanced"
    if not 0.0 < ball.torque <= most * (1 + ABOVE):
        return f"torque {ball.torque:.6g} N m is above {most:.6g} of full sliding"
    return "" if np.isfinite(ball.grid_error) else "the estimated error is not finite"


def against_coulomb(rolled: Rolled) -> str:
    """What is against Coulomb's law: stress beyond its limit, slip along it, or slip where it is below."""
    limit = rolled.contacts.limit
    most = limit.max((1, 2), keepdims=True)
    touching, creep = limit > 0.0, np.abs(rolled.creep).max((1, 2, 3))[:, None, None]
    size, slip = (np.hypot(field[:, 0], field[:, 1]) for field in (rolled.traction, rolled.slip))
    power = (rolled.traction * rolled.slip).sum(1)
    below = touching & (size < limit - SMALL * most)
    for fault, share in (
        ("stress beyond the limit", (size - limit) / most),
        ("slip along the stress", power / (most * creep)),
        ("slip below the limit", np.where(below, slip / creep, 0.0)),
        ("slip not against the stress", np.where(touching, (power + size * slip) / (most * creep), 0.0)),
    ):
        if not np.all(share <= SMALL):
            return f"{fault}: {share.max():.1e}"
    return ""


if __name__ == "__main__":
    main()
