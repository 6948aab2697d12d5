"""Random balls in four-point bearings, on two to four contacts."""

import numpy as np

from quasidynamic.four_point import FourPointBallBearing
from quasidynamic.outcome.slow_balls import SlidingBalls
from tests.ball_bearings import slow_bearing


def drawn(seed: int) -> tuple[FourPointBallBearing, SlidingBalls]:
    """Osculation 0.9 to 0.99, friction 0.005 to 0.5, loads over four decades; one ball in full sliding.

    It is pressed on one diagonal or on both, and on the weaker one by one race alone at times.
    """
    random = np.random.default_rng(seed)

    def between(low, high):
        return float(np.exp(random.uniform(np.log(low), np.log(high))))

    diameter = between(5e-3, 60e-3)
    pitch = diameter * between(6.0, 80.0)
    bearing = slow_bearing(
        diameter,
        pitch,
        balls=3,
        angle=float(random.uniform(30, 60)),
        conformity=0.5 / random.uniform(0.9, 0.99),
        outer_conformity=0.5 / random.uniform(0.9, 0.99),
        friction=between(0.005, 0.5),
        spin="local",
    )
    angles = np.radians(random.uniform(25, 65, size=2))
    most = 80e6 * diameter**2  # [N] about 4200 MPa
    loads = most * np.array([between(1e-4, 1.0), 0.0 if random.random() < 0.4 else between(1e-4, 1.0)])
    if loads[1] and random.random() < 0.3:
        loads[1] = loads[0]
    shape = (1, 2, 2) if loads[1] else (1, 1, 2)
    angle, load = (np.broadcast_to(values[None, : shape[1], None], shape) for values in (angles, loads))
    if loads[1] and random.random() < 0.3:  # three contacts: the ball leaves a race
        load = load.copy()
        load[0, np.argmin(loads), random.integers(2)] = 0.0
    return bearing, bearing.slide(angle, load)
