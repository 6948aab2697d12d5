"""Balls between two elastic rings on one page: slow, plain, with nothing from the package.

Along normals n = (sin, cos) of the contact angle the rings take w(alpha) of the distance d of opposite groove
centres: the length l = d n - w is left. A ball is where l is largest, with 2/5 K (l - A)^(5/2) of energy.
Through the displacements u of stations w goes as a sum of waves. They are those of both rings in series, with
u C^-1 u/2 of energy, C the sum of theirs; u = G y with C = G G^T. Place of the ring and y are those of the
lowest potential, found by SciPy.
"""

import numpy as np
from scipy.optimize import minimize


def waves(angles, count, order):
    """Derivatives (..., count) of cos, sin, 1, cos 2a, sin 2a, ... ; count is odd."""
    a, i = np.asarray(angles, dtype=float)[..., None], 1j
    n = np.arange(1, count // 2 + 1)
    terms = (i * n) ** order * np.exp(i * n * a)
    pairs = np.stack([terms.real, terms.imag], axis=-1).reshape(*a.shape[:-1], -1)
    return np.concatenate([pairs, np.full(a.shape, float(order == 0))], axis=-1)


def shares(stations, angles, order=0):
    """Shares (..., K) of stations in a displacement at contact angles, or their derivatives."""
    K = len(stations)
    return waves(angles, K, order) @ np.linalg.inv(waves(stations, K, 0))


def solve(balls, pitch, angle, touching, clearance, coefficient, stations, compliance, load):
    """Loads of the diagonals (Z, 2) [N] and place of the inner ring (5) [m, rad]."""
    phi, side = np.repeat(2 * np.pi * np.arange(balls) / balls, 2), np.tile([1.0, -1.0], balls)
    zero, arm = np.zeros(2 * balls), side * pitch / 2
    axial = np.stack([side, zero, zero, arm * np.cos(phi), -arm * np.sin(phi)], 1)
    radial = np.stack([zero, np.sin(phi), np.cos(phi), zero, zero], 1)
    weight = np.array([1, 1, 1, 2 / pitch, 2 / pitch])  # of moments as forces
    unit = np.abs(load * weight).max()  # [N]; with lengths in micrometres energies are of the order of one
    size = 2 * balls * len(stations)
    root = np.linalg.cholesky(1e-6 * unit * compliance.reshape(size, size))

    def potential(x):
        place, u = 1e-6 * weight * x[:5], (root @ x[5:]).reshape(2 * balls, -1)
        across = (touching - clearance) * np.sin(angle) + axial @ place
        up = (touching - clearance) * np.cos(angle) + radial @ place

        def length(a, order):
            quarter, lost = order * np.pi / 2, (shares(stations, a, order) * u).sum(1)
            return across * np.sin(a + quarter) + up * np.cos(a + quarter) - lost

        a = np.arctan2(across, up)
        for _ in range(20):
            a = a - length(a, 1) / length(a, 2)
        approach = np.maximum(length(a, 0) - touching, 0.0)
        Q = coefficient * approach**1.5
        excess = axial.T @ (Q * np.sin(a)) + radial.T @ (Q * np.cos(a)) - load
        pressed = (Q[:, None] * shares(stations, a)).ravel()
        total = 1e6 / unit * (0.4 * (Q * approach).sum() - load @ place) + 0.5 * x[5:] @ x[5:]
        gradient = np.append(weight * excess / unit, x[5:] - 1e6 / unit * root.T @ pressed)
        return total, gradient, Q, place

    found = minimize(
        lambda x: potential(x)[:2], np.zeros(5 + size), jac=True, method="BFGS",
        options={"gtol": 1e-9, "maxiter": 5000},
    )  # fmt: skip
    _, gradient, loads, place = potential(found.x)
    assert np.abs(gradient).max() < 5e-6, found.message  # rounding ends it; loads are known to 1e-6 then
    return loads.reshape(balls, 2), place
