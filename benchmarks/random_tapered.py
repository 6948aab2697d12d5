"""How many random tapered roller bearings are solved: `python -m benchmarks.random_tapered [--number N]`."""

import argparse
import time
from collections import Counter

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from quasidynamic import NotSolved, tapered_loads
from tests.random_tapered import drawn


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--number", type=int, default=500)
    number = parser.parse_args().number
    outcomes, times, imbalances = Counter[str](), [], []
    with threadpool_limits(1):
        for seed in range(number):
            bearing, asked = drawn(seed)
            began = time.process_time()
            try:
                imbalances.append(tapered_loads(bearing, asked).solution.imbalance)
                outcomes["converged"] += 1
            except NotSolved as failure:
                outcomes[failure.outcome] += 1
            times.append(time.process_time() - began)
    print(describe())
    print(f"{number} bearings: {dict(outcomes)}")
    print(f"processor time: median {1e3 * np.median(times):.0f} ms, largest {1e3 * max(times):.0f} ms")
    print(f"unbalanced force on the ring over the largest one: at most {max(imbalances):.1e}")


if __name__ == "__main__":
    main()
