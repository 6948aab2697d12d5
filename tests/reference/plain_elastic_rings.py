"""Balls between two elastic rings on one page: slow, plain, with nothing from the package.

The forces of the diagonals are those of the lowest complementary energy among all that carry the load,
found by SciPy: contacts 3/5 K^(-2/3) Q^(5/3) + A Q, rings F C F/2, less the distance that is there, v0 F.
"""

import numpy as np
from scipy.optimize import minimize


def solve(balls, pitch, angle, touching, clearance, coefficient, compliance, load):
    """Loads of the diagonals (Z, 2) [N] and place of the inner ring (5) [m, rad]."""
    C = np.zeros((balls, 2, 2, balls, 2, 2))
    carry = np.zeros((5, balls, 2, 2))
    start = np.zeros((balls, 2, 2))
    for j in range(balls):
        phi = 2 * np.pi * j / balls
        for k in range(balls):
            C[j, :, :, k] = compliance[(j - k) % balls]
        for diagonal, lean in enumerate((1, -1)):
            start[j, diagonal] = (touching - clearance) * np.array([np.cos(angle), lean * np.sin(angle)])
            carry[0, j, diagonal, 1] = 1
            carry[1, j, diagonal, 0], carry[2, j, diagonal, 0] = np.sin(phi), np.cos(phi)
            carry[3, j, diagonal, 1], carry[4, j, diagonal, 1] = (
                np.cos(phi) * pitch / 2,
                -np.sin(phi) * pitch / 2,
            )
    C, carry, start = C.reshape(4 * balls, -1), carry.reshape(5, -1), start.ravel()
    weight = np.array([1, 1, 1, 2 / pitch, 2 / pitch])  # moments as forces
    unit = np.abs(load * weight).max()  # [N], with lengths in micrometres energies are of the order of one

    def energy(x):
        F = unit * x
        Q = np.sqrt((F.reshape(-1, 2) ** 2).sum(1) + 1e-14 * unit**2)  # rounded at zero load
        own = touching * Q + 0.6 * coefficient ** (-2 / 3) * Q ** (5 / 3)
        slope = (touching + (Q / coefficient) ** (2 / 3)) / Q
        total = own.sum() + F @ C @ F / 2 - start @ F
        gradient = (slope[:, None] * F.reshape(-1, 2)).ravel() + C @ F - start
        return 1e6 * total / unit, 1e6 * gradient

    constraint = {
        "type": "eq",
        "fun": lambda x: weight * (carry @ x - load / unit),
        "jac": lambda x: weight[:, None] * carry,
    }
    first = np.linalg.lstsq(carry, load / unit, rcond=None)[0]
    found = minimize(
        energy, first, jac=True, method="SLSQP", constraints=[constraint],
        options={"ftol": 1e-15, "maxiter": 3000},
    )  # fmt: skip
    assert found.success, found.message
    # the place of the ring is what the constraint resists with
    place = np.linalg.lstsq(carry.T, 1e-6 * energy(found.x)[1], rcond=None)[0]
    return unit * np.linalg.norm(found.x.reshape(-1, 2), axis=1).reshape(balls, 2), place
