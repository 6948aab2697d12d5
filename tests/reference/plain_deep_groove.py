"""The whole deep groove bearing on one page: slow, scalar, in five directions.

Each ball finds its place by `scipy.optimize.root`, the ring around them too; outer race control. Balls that
the inner race leaves rest on the outer one. Speeds and Hertz contacts are those of `plain_angular_contact`;
steel on steel, contacts as at the contact angle zero.
"""

from math import atan2, cos, hypot, pi, sin

import numpy as np
from scipy.optimize import root

from tests.reference.plain_angular_contact import DENSITY, hertz, speeds


def ball(p, axial, radial, start):
    """State of a ball whose inner groove centre stands at (axial, radial) from the outer one."""
    D, dm, fi, fo = p["D"], p["dm"], p["fi"], p["fo"]
    g, mass = D / dm, DENSITY * pi / 6 * D**3
    Ki = hertz(2 / D - 1 / (fi * D), 2 / D + 2 / D * g / (1 - g))
    Ko = hertz(2 / D - 1 / (fo * D), 2 / D - 2 / D * g / (1 + g))
    Fc = mass * dm * (p["omega"] * (1 - g) / 2) ** 2 / 2  # of a ball on the outer race alone
    bottom = (fo - 0.5) * D + (Fc / Ko) ** (2 / 3)
    if hypot(axial, radial - bottom) <= (fi - 0.5) * D:
        return {"inner": 0.0, "outer": 0.0, "Qi": 0.0, "Qo": Fc, "Fx": 0.0, "Fr": 0.0}, start
    state = {}

    def off(v):
        x, y = v[0] * 1e-4, v[1] * 1e-4
        inner, outer = atan2(axial - x, radial - y), atan2(x, y)
        Qi = Ki * max(hypot(axial - x, radial - y) - (fi - 0.5) * D, 0.0) ** 1.5
        Qo = Ko * max(hypot(x, y) - (fo - 0.5) * D, 0.0) ** 1.5
        orbit, spin, beta = speeds(inner if Qi else outer, outer, g, p["omega"], "outer")
        Fc, To = mass * dm * orbit**2 / 2, 2 * mass * D**2 / 10 * orbit * spin * sin(beta) / D
        state.update(inner=inner, outer=outer, Qi=Qi, Qo=Qo, Fx=Qi * sin(inner), Fr=Qi * cos(inner))
        return (
            (state["Fx"] - Qo * sin(outer) - To * cos(outer)),
            (state["Fr"] - Qo * cos(outer) + To * sin(outer) + Fc),
        )

    solution = root(off, start, tol=1e-13)
    off(solution.x)
    return state, solution.x


def bearing(p, load, start):
    """Ring displacements x, y, z [m], about y and z [rad] from the centred ring; state of every ball."""
    distance = (p["fi"] + p["fo"] - 1) * p["D"]
    lever = p["dm"] / 2 + (p["fi"] - 0.5) * p["D"]  # of the inner groove centres
    azimuth = [2 * pi * j / p["Z"] for j in range(p["Z"])]
    starts, balls = [None] * p["Z"], [None] * p["Z"]
    units = np.array([1e-5, 1e-5, 1e-5, 1e-5 / lever, 1e-5 / lever])

    def off(q):
        x, y, z, about_y, about_z = q * units
        carried = np.zeros(5)
        for j, a in enumerate(azimuth):
            axial = x + lever * (about_y * cos(a) - about_z * sin(a))
            radial = distance - p["Pd"] / 2 + y * sin(a) + z * cos(a)
            middle = starts[j] if starts[j] is not None else (0.5e4 * axial, 0.5e4 * radial)
            balls[j], starts[j] = ball(p, axial, radial, middle)
            Fx, Fr = balls[j]["Fx"], balls[j]["Fr"]
            carried += Fx, Fr * sin(a), Fr * cos(a), Fx * lever * cos(a), -Fx * lever * sin(a)
        return (carried - load) / [1, 1, 1, lever, lever]

    solution = root(off, np.array(start) / units, tol=1e-12)
    off(solution.x)
    return solution.x * units, balls
