"""The whole angular-contact bearing on one page: slow, scalar, from Harris' equations.

Ball by ball with `scipy.optimize.root`, elliptic integrals by bisection; equal control (beta halves the angle
between the contacts) or outer control, thrust and radial loads, no tilt. Steel on steel.
"""

from math import asin, atan, atan2, cos, hypot, pi, sin

from scipy.optimize import brentq, root
from scipy.special import ellipe, ellipk

E, NU, DENSITY = 206e9, 0.3, 7800.0


def hertz(across, along):
    """K in Q = K delta^1.5 for the sums of curvatures across and along the rolling direction."""
    total, rho = across + along, (along - across) / (across + along)

    def off(k):
        m = 1 - 1 / k**2
        return ((k * k + 1) * ellipe(m) - 2 * ellipk(m)) / ((k * k - 1) * ellipe(m)) - rho

    k = brentq(off, 1.001, 1000.0, xtol=1e-13)
    m = 1 - 1 / k**2
    soft = 2 * (1 - NU**2) / E
    approach = (2 * ellipk(m) / pi) * (pi / (2 * k * k * ellipe(m))) ** (1 / 3) * total / 2
    return (approach * (3 * soft / (2 * total)) ** (2 / 3)) ** -1.5


def speeds(inner, outer, g, omega, control):
    beta = (inner + outer) / 2 if control == "equal" else atan(sin(outer) / (cos(outer) + g))
    top = (1 + g * cos(outer)) * cos(inner - beta)
    orbit = omega / (1 + top / ((1 - g * cos(inner)) * cos(outer - beta)))
    spin = omega / (g * (cos(outer - beta) / (1 + g * cos(outer)) + cos(inner - beta) / (1 - g * cos(inner))))
    return orbit, spin, beta


def ball(p, axial, radial, start):
    """Contact angles and loads of a ball whose inner groove centre has moved by (axial, radial)."""
    D, dm, fi, fo, alpha = p["D"], p["dm"], p["fi"], p["fo"], p["alpha"]
    g, mass = D / dm, DENSITY * pi / 6 * D**3
    race = D / dm * cos(alpha)
    Ki = hertz(2 / D - 1 / (fi * D), 2 / D + 2 / D * race / (1 - race))
    Ko = hertz(2 / D - 1 / (fo * D), 2 / D - 2 / D * race / (1 + race))
    distance = (fi + fo - 1) * D
    s = (distance * sin(alpha) + axial, distance * cos(alpha) + radial)
    share = (1.0, 1.0) if p["control"] == "equal" else (0.0, 2.0)
    found = {}

    def off(v):
        x, y = v[0] * 1e-4, v[1] * 1e-4
        inner, outer = atan2(s[0] - x, s[1] - y), atan2(x, y)
        Qi = Ki * max(hypot(s[0] - x, s[1] - y) - (fi - 0.5) * D, 0.0) ** 1.5
        Qo = Ko * max(hypot(x, y) - (fo - 0.5) * D, 0.0) ** 1.5
        orbit, spin, beta = speeds(inner, outer, g, p["omega"], p["control"])
        M = mass * D**2 / 10 * orbit * spin * sin(beta)
        Ti, To = share[0] * M / D, share[1] * M / D
        found.update(inner=inner, outer=outer, Qi=Qi, Qo=Qo, Fx=Qi * sin(inner) + Ti * cos(inner))
        found.update(Fr=Qi * cos(inner) - Ti * sin(inner))
        return (
            found["Fx"] - Qo * sin(outer) - To * cos(outer),
            found["Fr"] - Qo * cos(outer) + To * sin(outer) + mass * dm * orbit**2 / 2,
        )

    solution = root(off, start, tol=1e-13)
    off(solution.x)
    return found, solution.x


def bearing(p, thrust, radial):
    """Axial and radial displacement [m], and the state of every ball."""
    azimuth = [2 * pi * j / p["Z"] for j in range(p["Z"])]
    distance = (p["fi"] + p["fo"] - 1) * p["D"]
    middle = (0.5 * distance * sin(p["alpha"]) * 1e4, 0.5 * distance * cos(p["alpha"]) * 1e4)
    starts, balls = [middle] * p["Z"], [None] * p["Z"]

    def off(q):
        for j, angle in enumerate(azimuth):
            balls[j], starts[j] = ball(p, q[0] * 1e-5, q[1] * 1e-5 * cos(angle), starts[j])
        axial = sum(b["Fx"] for b in balls) - thrust
        return axial, sum(b["Fr"] * cos(a) for b, a in zip(balls, azimuth, strict=True)) - radial

    solution = root(off, (2.0, 0.5), tol=1e-12)
    off(solution.x)
    return solution.x * 1e-5, balls


def thrust_angle(p, thrust):
    """Contact angle of the static thrust bearing, Harris' single equation."""
    race = p["D"] / p["dm"] * cos(p["alpha"])
    K = (
        sum(
            hertz(2 / p["D"] - 1 / (f * p["D"]), 2 / p["D"] + side * 2 / p["D"] * race / (1 - side * race))
            ** (-2 / 3)
            for f, side in ((p["fi"], 1), (p["fo"], -1))
        )
        ** -1.5
    )
    distance = (p["fi"] + p["fo"] - 1) * p["D"]

    def off(angle):
        stretch = distance * (cos(p["alpha"]) / cos(angle) - 1)
        return p["Z"] * K * stretch**1.5 * sin(angle) - thrust

    return brentq(off, p["alpha"], asin(0.99), xtol=1e-14)
