"""One slow ball between two grooves on one page: slow, plain, with nothing from the package.

Everything is written as the papers print it; the contact is a mesh of points, the balance a search by SciPy.
"""

import numpy as np
from scipy.optimize import brentq, minimize
from scipy.special import ellipe, ellipk

POINTS = 160  # rings and rays of the mesh in a contact
U = (np.arange(POINTS) + 0.5) / POINTS
RHO, PHI = np.meshgrid(U, 2 * np.pi * U, indexing="ij")


def hertz(case, side, angle, load):
    """Semi-axes of the contact ellipse, from F(rho) of Harris."""
    gamma = case["D"] * np.cos(angle) / case["dm"]
    race = 2 / case["D"] * (gamma / (1 - gamma) if side < 0 else -gamma / (1 + gamma))
    total = 4 / case["D"] + race - 1 / case["r"]
    difference = (race + 1 / case["r"]) / total

    def printed(k):
        m = 1 - 1 / k**2
        return ((k**2 + 1) * ellipe(m) - 2 * ellipk(m)) / ((k**2 - 1) * ellipe(m)) - difference

    k = brentq(printed, 1.001, 1000)
    E = ellipe(1 - 1 / k**2)
    c = (3 * load * (1 - 0.3**2) / case["E"] / total) ** (1 / 3)
    return c * (2 * k**2 * E / np.pi) ** (1 / 3), c * (2 * E / (np.pi * k)) ** (1 / 3)


def contacts(case):
    """Each contact as (side, normal, mesh, tilt of the surface, pressure times area), loaded ones only."""
    found = []
    for diagonal, (angle, load) in enumerate(zip(case["angle"], case["load"], strict=True)):
        for side in (-1, 1):
            if load == 0:
                continue
            a, b = hertz(case, side, angle, load)
            normal = side * np.array([(1, -1)[diagonal] * np.sin(angle), np.cos(angle)])
            x, y = a * RHO * np.cos(PHI), b * RHO * np.sin(PHI)
            area = a * b * RHO / POINTS * 2 * np.pi / POINTS
            pressure = 1.5 * load / (np.pi * a * b) * np.sqrt(1 - RHO**2)
            R = 2 * case["r"] * (case["D"] / 2) / (case["r"] + case["D"] / 2)
            h = np.sqrt(R**2 - x**2) - np.sqrt(R**2 - a**2) + np.sqrt((case["D"] / 2) ** 2 - a**2)
            tilt = np.arcsin(x / R) if case.get("spin") == "local" else 0.0
            found.append((side, normal, x, y, h, tilt, case["friction"] * pressure * area))
    return found


def slip(case, contact, motion):
    """Velocity of the ball against the race along the orbit and along the groove section."""
    side, (nx, nr), x, y, h, tilt, _ = contact
    outer, wx, wr = motion
    race = outer + 1 if side < 0 else outer
    px, pr = h * nx - x * nr, h * nr + x * nx
    along = wx * pr - wr * px - race * (case["dm"] / 2 + pr)
    spin = (wx - race) * (nx * np.cos(tilt) - nr * np.sin(tilt)) + wr * (
        nr * np.cos(tilt) + nx * np.sin(tilt)
    )
    return along, -spin * y


def heat(case, mesh, motion):
    return sum((contact[-1] * np.hypot(*slip(case, contact, motion))).sum() for contact in mesh)


def joshi(case, mesh, motion):
    """Force along the orbit and moments about the axial and the radial direction, on the ball."""
    force, axial, radial = 0.0, 0.0, 0.0
    for contact in mesh:
        _, (nx, nr), x, y, h, tilt, weight = contact
        along, across = slip(case, contact, motion)
        size = np.hypot(along, across)
        t, s = -weight * along / size, -weight * across / size
        rolling = (t * h + s * y * np.sin(tilt)).sum()
        spinning = (t * x - s * y * np.cos(tilt)).sum()
        force += t.sum()
        axial += nr * rolling + nx * spinning
        radial += -nx * rolling + nr * spinning
    return np.array([force, axial, radial])


def guided(case, attitude):
    """Least heat of one diagonal about an axis at an angle to the shaft: the torque under race control."""
    mesh, ratio = contacts(case), case["dm"] / case["D"]
    inner = (ratio + np.cos(case["angle"][0])) / (2 * ratio)
    start = np.array([inner - 1, inner * (ratio - np.cos(case["angle"][0]))])

    def about(m):
        return heat(case, mesh, (m[0], -m[1] * np.cos(attitude), m[1] * np.sin(attitude)))

    for size in (1e-2, 1e-3):
        options = {
            "xatol": 1e-9,
            "fatol": 1e-13,
            "initial_simplex": start + size * np.array([[0, 0], [1, 0], [0, start[1]]]),
        }
        start = minimize(about, start, method="Nelder-Mead", options=options).x
    return about(start)


def solve(case):
    """Motion of least heat, and that heat: the torque of the ball."""
    mesh, ratio = contacts(case), case["dm"] / case["D"]
    best = None
    rolling = list(zip(case["angle"], (1, -1), strict=False))
    for angle, lean in [*rolling, (np.mean(case["angle"]), 0)]:
        inner = (ratio + np.cos(angle)) / (2 * ratio)
        ball = inner * (ratio - np.cos(angle)) / (1 if lean else np.cos(angle))
        start = np.array([inner - 1, -ball * np.cos(lean * angle), ball * np.sin(lean * angle)])
        for size in (1e-2, 1e-3):
            simplex = np.vstack([start, start + size * np.diag([1, ball, ball])])
            options = {"xatol": 1e-10, "fatol": 1e-14, "maxiter": 2000, "initial_simplex": simplex}
            result = minimize(lambda m: heat(case, mesh, m), start, method="Nelder-Mead", options=options)
            start = result.x
        best = result if best is None or result.fun < best.fun else best
    return best.x, best.fun
