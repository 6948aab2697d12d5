"""Balls between two elastic rings on one page: slow, plain, with nothing from the package.

Along normals n = (sin, cos) of the contact angle a ring takes w(alpha) of the distance d of the centres of
ball and groove: the length l = d n - w is left. A ball presses where l is largest, with 2/5 K (l - A)^(5/2).
Through the displacements u of stations w goes as a sum of waves. They have u C^-1 u/2 of energy, u = G y with
C = G G^T. Places of ring and balls and y are those of the lowest potential, found by SciPy.
"""

import numpy as np
from scipy.optimize import minimize, root


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


def solve(balls, pitch, angle, touching, clearance, coefficient, stations, compliances, load):  # noqa: PLR0915
    """Loads of the contacts (Z, 2, 2) [N] and place of the inner ring (5) [m, rad]; rigid rings are None."""
    phi, side = np.repeat(2 * np.pi * np.arange(balls) / balls, 2), np.tile([1.0, -1.0], balls)
    zero, arm = np.zeros(2 * balls), side * pitch / 2
    axial = np.stack([side, zero, zero, arm * np.cos(phi), -arm * np.sin(phi)], 1)
    radial = np.stack([zero, np.sin(phi), np.cos(phi), zero, zero], 1)
    weight = np.array([1, 1, 1, 2 / pitch, 2 / pitch])  # of moments as forces
    unit = np.abs(load * weight).max()  # [N]; with lengths in micrometres energies are of the order of one
    size = 2 * balls * len(stations)
    factors = [
        np.zeros((size, size)) if each is None else np.linalg.cholesky(1e-6 * unit * each.reshape(size, size))
        for each in compliances
    ]

    def potential(x):
        place, centres = 1e-6 * weight * x[:5], 1e-6 * x[5 : 5 + 2 * balls].reshape(-1, 2)
        centre = np.repeat(centres, 2, axis=0) * np.stack([side, 1 + zero], 1)
        total, gradient = (
            0.5 * x[5 + 2 * balls :] @ x[5 + 2 * balls :] - 1e6 / unit * (load @ place),
            x.copy(),
        )
        excess, on_balls, all_loads = -load, np.zeros((balls, 2)), []
        for race, (factor, towards) in enumerate(zip(factors, (-1, 1), strict=True)):
            part = slice(5 + 2 * balls + race * size, 5 + 2 * balls + (race + 1) * size)
            u = (factor @ x[part]).reshape(2 * balls, -1)
            half = touching / 2 - (clearance / 2)
            across = half * np.sin(angle) + towards * centre[:, 0] + (1 - race) * axial @ place
            up = half * np.cos(angle) + towards * centre[:, 1] + (1 - race) * radial @ place

            def length(a, order, across=across, up=up, u=u):
                quarter, lost = order * np.pi / 2, (shares(stations, a, order) * u).sum(1)
                return across * np.sin(a + quarter) + up * np.cos(a + quarter) - lost

            a = np.arctan2(across, up)
            for _ in range(20):
                a = a - length(a, 1) / length(a, 2)
            approach = np.maximum(length(a, 0) - touching / 2, 0.0)
            Q = coefficient[race] * approach**1.5
            total += 0.4e6 / unit * (Q * approach).sum()
            if race == 0:
                excess = excess + axial.T @ (Q * np.sin(a)) + radial.T @ (Q * np.cos(a))
            force = towards * Q[:, None] * np.stack([side * np.sin(a), np.cos(a)], 1)
            on_balls += force.reshape(balls, 2, 2).sum(1)
            gradient[part] -= 1e6 / unit * factor.T @ (Q[:, None] * shares(stations, a)).ravel()
            all_loads.append(Q.reshape(balls, 2))
        gradient[:5], gradient[5 : 5 + 2 * balls] = weight * excess / unit, on_balls.ravel() / unit
        return total, gradient, np.stack(all_loads, -1), place

    start = np.zeros(5 + 2 * balls + 2 * size)
    lowest = minimize(
        lambda x: potential(x)[:2], start, jac=True, method="BFGS", options={"gtol": 1e-6, "maxiter": 5000}
    )
    found = root(lambda x: potential(x)[1], lowest.x, tol=1e-12)  # rounding of the energy stops the search
    _, gradient, loads, place = potential(found.x)
    assert np.abs(gradient).max() < 1e-9, found.message
    return loads, place
