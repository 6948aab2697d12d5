"""Random rolling contacts of steel on steel, with creep, spin, curvature and layers of every size."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.half_space import ElasticPair, grid_over
from quasidynamic.contact.rolling.full_sliding import hertz_pressure
from quasidynamic.contact.rolling.rolling_contact import MID_STEP, RollingContacts

STEEL = ElasticPair(shear=1 / 80e9, poisson=0.3 / 80e9)


def drawn(seed: int, shape=(12, 24), layers=False) -> tuple[RollingContacts, NDArray]:
    """One contact and its creep."""
    random = np.random.default_rng(seed)

    def between(low, high):
        return float(np.exp(random.uniform(np.log(low), np.log(high))))

    b = between(1e-4, 1e-2)
    a = b * between(0.03, 3.0)
    load = 2 / 3 * np.pi * a * b * between(0.2e9, 4e9)
    friction, grid = between(0.005, 0.5), grid_over((a, b), shape)
    limit = friction * hertz_pressure(grid, (a, b), load)[None]
    contacts = RollingContacts((grid,), (STEEL,), limit)
    x, y = contacts.places(MID_STEP)
    size = limit.max() * STEEL.shear * between(0.02, 50.0)  # creep at which about everything slides
    parts = random.normal(size=5) * (random.random(5) < 0.6)
    parts[random.integers(5)] += 1.0
    along = parts[0] + parts[1] * (2 * (y / b) ** 2 - 0.5) - parts[2] * y / b + 0 * x
    across = parts[3] + (parts[2] + parts[4] * (y / b)) * x / b
    if layers:
        layer = between(0.01, 10.0) * a * STEEL.shear * random.random(limit.shape)
        contacts = replace(contacts, compliance=layer)
    return contacts, size * np.stack([along, across], 1)
