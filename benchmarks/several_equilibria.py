"""Bearings with cold or thick oil: `python -m benchmarks.several_equilibria --n 200 --seed S`.

Envelope: 8 to 40 rollers, oils of 0.15 to 2.5 Pa s, loads of C0/500 to C0/25, 200 to 6000 rpm, clearance of 0
to 1e-3 of the pitch diameter, four traction laws, one design in five tilted by a moment. What a run tells of
other equilibria is compared with an exhaustive search from 60 random starts for each design, and from 600
where something is told that those do not have.
"""

import argparse
import time
from functools import partial
from multiprocessing import Pool

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from flexbearing.runs.several import between_rigid_raceways
from quasidynamic import SolverOutcome, solve_many
from quasidynamic.several import several_likely
from tests.bearings import paper_bearing
from tests.random_rollers import imbalance
from tests.thick_films import DIFFERENT, apart, decays, design, others_by_search

STARTS, MORE_STARTS = 60, 600
CHECKED_TO = 1e-8  # of the largest force


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--n", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_args()
    print(describe())
    with threadpool_limits(limits=1, user_api="blas"), Pool(asked.jobs) as pool:
        found = pool.imap_unordered(partial(examine, seed=asked.seed), range(asked.n))
        report([row for row in found if row is not None], asked)


def examine(number: int, seed: int) -> dict | None:
    rng = np.random.default_rng([seed, number])
    model = design(rng)
    solve, state = timed(lambda: solve_many([model])[0])
    if state.status is not SolverOutcome.CONVERGED:
        print(f"design {number}: {state.status}", flush=True)
        return None
    state.loads  # noqa: B018  evaluated before: every run stores them
    indicate, likely = timed(lambda: several_likely(state))
    search, told = timed(lambda: between_rigid_raceways(model, state))
    exhaustive, others = timed(lambda: others_by_search(state, rng, STARTS))
    if bool(others) != bool(told):
        told_of = len(told.others) if told else 0
        print(f"design {number}: {len(others)} by random starts, {told_of} reported", flush=True)
    beyond = bool(told) and not others
    confirmed = beyond and bool(others_by_search(state, rng, MORE_STARTS))
    loads = [one.loads[0].max() for one in (state, *others)]
    known = [one.loads[0].max() for one in (state, *(told.others if told else ()))]
    common = min(max(loads), max(known)) - max(min(loads), min(known))
    return {
        "others": len(others),
        "told": len(told.others) if told else 0,
        "confirmed": confirmed,
        "proven": bool(told) and any(proves(other, state) for other in told.others),
        "likely": likely,
        "spread": common / np.ptp(loads) if others else np.nan,
        "settled": told is not None and told.passing is not None and told.passing.settled,
        "life": passing_life(told, state),
        "seconds": (solve, indicate, search, exhaustive),
    }


def proves(other, state) -> bool:
    """Whether a state that is told is a second one: forces summed again from what is reported, and stable."""
    return imbalance(other) < CHECKED_TO and apart(other, state) > DIFFERENT and bool(decays(other))


def timed(work):
    start = time.process_time()
    answer = work()
    return time.process_time() - start, answer


def passing_life(told, state) -> float:
    passing = told and told.passing
    return passing.state.life / state.life if passing else np.nan


def report(rows: list[dict], asked) -> None:
    several, one = [r for r in rows if r["others"]], [r for r in rows if not r["others"]]
    told, beyond = sum(r["told"] > 0 for r in several), [r for r in one if r["told"]]
    false = sum(not r["proven"] for r in rows if r["told"])
    print(f"{asked.n} designs, seed {asked.seed}: {len(rows)} solved, {len(several)} with several equilibria")
    print(f"reported: {told} of {len(several)} ({told / len(several):.1%})")
    print(
        f"reported where {STARTS} random starts found none: {len(beyond)} of {len(one)} "
        f"({len(beyond) / len(one):.1%}), {sum(r['confirmed'] for r in beyond)} found by {MORE_STARTS}"
    )
    print(
        "false alarms, without a second state that is stable and whose forces balance: "
        f"{false} of {told + len(beyond)}"
    )
    spread = np.array([r["spread"] for r in several if r["told"]])
    print(
        f"spread of the largest load that the reported ones cover: mean {spread.mean():.0%}, "
        f"lowest tenth {np.quantile(spread, 0.1):.0%}"
    )
    life = np.array([r["life"] for r in rows if np.isfinite(r["life"])])
    print(
        f"rollers that pass pitches settle in {sum(r['settled'] for r in rows)} of "
        f"{sum(r['told'] > 0 for r in rows)}; life over that of the run: median {np.median(life):.2f}, "
        f"{life.min():.2f} to {life.max():.2f}"
    )
    quiet = [r for r in rows if not r["likely"]]
    seconds = np.array([r["seconds"] for r in rows])
    solve, indicate, _, exhaustive = np.median(seconds, axis=0) * 1e3
    print(
        f"processor time, medians: solve {solve:.2f} ms, indicator {indicate:.2f} ms "
        f"({indicate / solve:.0%} of it), exhaustive search {exhaustive:.0f} ms"
    )
    for name, chosen in (("nothing found", [r for r in rows if r["likely"] and not r["told"]]),
                         ("several found", [r for r in rows if r["told"]])):  # fmt: skip
        if chosen:
            print(f"restarts, {name}: {np.median([r['seconds'][2] for r in chosen]) * 1e3:.0f} ms")
    print(f"indicator does not fire: {len(quiet)} of {len(one)} without several")
    cost_beside_a_rigid_solve()


def cost_beside_a_rigid_solve() -> None:
    """The bearing of Mao et al., whose films are thin: the indicator does not fire."""
    model = paper_bearing()
    state = model.solve()
    state.loads  # noqa: B018
    assert not several_likely(state)
    times = np.array([(timed(model.solve)[0], timed(lambda: several_likely(state))[0]) for _ in range(101)])
    solve, indicate = np.median(times, axis=0) * 1e3
    print(f"main bearing: rigid solve {solve:.2f} ms, indicator {indicate:.2f} ms ({indicate / solve:.0%})")


if __name__ == "__main__":
    main()
