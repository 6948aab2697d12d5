"""How many random tapered roller bearings are solved: `python -m benchmarks.random_tapered [--number N]`.

Between rigid rings, or between elastic ones with `--elastic`; `--pairs` are two rows, also in one body.
Rollers and rings are summed up again. With `--friction` those at speed move in balance with it.
"""

import argparse
import time
from collections import Counter

import numpy as np
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from quasidynamic import NotSolved, TaperedLoads, tapered_loads
from quasidynamic.balance.rollers.inclined import InclinedRollers
from quasidynamic.tapered_friction import TaperedFriction
from tests.random_tapered import compliance, drawn, drawn_friction, drawn_pair, drawn_rings

SHAPES = 4


def summed_again(found: TaperedLoads) -> float:
    """Largest unbalanced force of rollers and ring over the largest force [-], from the loads of slices."""
    bearing = found.bearing
    cone, cup, rib = bearing.cone_angle, bearing.cup_angle, bearing.rib
    inner, outer, on_rib = *found.loads, found.rib_loads
    along = inner * np.sin(cone) - outer * np.sin(cup) + on_rib * np.cos(rib.angle)
    across = outer * np.cos(cup) - inner * np.cos(cone) + on_rib * np.sin(rib.angle)
    moments = found.slice_loads * found.slices.widths @ found.slices.centres
    turning = moments[1] - moments[0] + on_rib * rib.lever - found.speeds.gyroscopic_moment
    towards = np.array([np.sin(bearing.azimuths), np.cos(bearing.azimuths)])
    sides = np.repeat(bearing.sides, bearing.rollers)
    on_ring = [-(sides * (inner * np.sin(cone) + on_rib * np.cos(rib.angle))).sum()]
    on_ring += [*towards @ (on_rib * np.sin(rib.angle) - inner * np.cos(cone))]
    left = [along, across - found.speeds.centrifugal_force, turning / (bearing.roller.length / 2)]
    largest = max(outer.max(), np.abs(found.load[:3]).max())
    return float(max(np.abs(left).max(), np.abs(np.array(on_ring) + found.load[:3]).max()) / largest)


def shape_again(found: TaperedLoads, raceways: list[np.ndarray | None]) -> float:
    """Largest difference of raceways from the shape that the loads of slices make, over the largest [-]."""
    modes = found.slices.with_axial_modes(SHAPES)
    rib = InclinedRollers.of(found.bearing, found.slices, np.zeros(3)).rib_readings(SHAPES)
    worst = 0.0
    for raceway, deflection, loads in zip(raceways, found.deflection, found.slice_loads, strict=True):
        if raceway is not None and deflection is not None:
            forces = loads @ modes.weights
            if raceway.shape[1] > SHAPES:
                forces = np.pad(forces, ((0, 0), (0, 1))) + np.outer(found.rib_loads, rib)
            shape = np.einsum("jmkn,kn->jm", raceway, forces)[:, :SHAPES] @ modes.modes.T
            worst = max(worst, float(np.abs(shape - deflection).max() / np.abs(shape).max()))
    return worst


def power_again(friction: TaperedFriction) -> float:
    """Difference of the power that rings put in from the heat of all causes, over it [-]."""
    causes = ("sliding", "rolling", "rib", "drag", "churning", "pocket", "land")
    heat = sum(getattr(friction, f"{cause}_heat").sum() for cause in causes)
    return float(abs(friction.power - friction.transport.sum() - heat) / heat)


def options() -> argparse.Namespace:
    """What the command line asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--number", type=int, default=500)
    for name in ("--elastic", "--pairs", "--friction"):
        parser.add_argument(name, action="store_true")
    return parser.parse_args()


def main() -> None:
    asked_for = options()
    outcomes, named, times, checks = Counter[str](), [], [], [[0.0, 0.0, 0.0]]
    with threadpool_limits(1):
        for seed in range(asked_for.number):
            bearing, asked = drawn(seed)
            bearing = drawn_pair(seed, bearing) if asked_for.pairs else bearing
            rings = drawn_rings(seed, bearing) if asked_for.elastic else [None, None]
            raceways = [ring and compliance(bearing, ring, SHAPES) for ring in rings]
            began = time.process_time()
            try:
                found = tapered_loads(bearing, asked, raceways=raceways)
                moving = asked_for.friction and asked.relative_speed
                power = power_again(drawn_friction(seed, found)) if moving else 0.0
                checks.append([summed_again(found), shape_again(found, raceways), power])
                outcomes["converged"] += 1
            except NotSolved as failure:
                outcomes[failure.outcome] += 1
                named.append(f"{seed}: {failure}")
            times.append(time.process_time() - began)
    left, shapes, powers = map(max, zip(*checks, strict=True))
    print(describe())
    print(f"{asked_for.number} bearings: {dict(outcomes)}")
    print(f"processor time: median {1e3 * np.median(times):.0f} ms, largest {1e3 * max(times):.0f} ms")
    print(f"unbalanced force of rollers and ring over the largest one: at most {left:.1e}")
    if asked_for.elastic:
        print(f"raceways against the shape that their loads make: at most {shapes:.1e}")
    if asked_for.friction:
        print(f"power of the rings against heat of all causes: at most {powers:.1e}")
    print(*named, sep="\n")


if __name__ == "__main__":
    main()
