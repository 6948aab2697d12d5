"""Every balance of a result, summed up from its stored forces: `python -m benchmarks.balances RESULT.h5`."""

import argparse
from pathlib import Path

import numpy as np

import flexbearing
from tests.balances import UNITS, balances, largest_imbalance


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("result", type=Path)
    result = flexbearing.read(parser.parse_args().result)
    guidance = result.attributes["case_si"]["bearing"]["cage"]["guidance"]
    for name in ("rigid", "flexible"):
        block = getattr(result, name)
        if not block:
            continue
        print(f"{name}: largest {largest_imbalance(block, guidance):.1e} of the largest force")
        for balance, left in balances(block, guidance).items():
            print(f"  {balance:16} {np.abs(left).max():.1e} {UNITS.get(balance, 'N m')}")


if __name__ == "__main__":
    main()
