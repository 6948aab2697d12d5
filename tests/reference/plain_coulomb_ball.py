"""A thrust-loaded angular-contact bearing with full Coulomb sliding on one page: slow, from Newton and Euler.

All balls are alike: `scipy.optimize.root` finds place, orbit and spin of one under a share of the thrust.
Friction is a plain sum of vectors over strips of each contact, panels of them between the lines without slip
along; Hertz contacts are those of `plain_angular_contact`. Axes: axial x, radial r, rolling t.
"""

from math import atan, atan2, cos, hypot, pi, sin, sqrt, tan

import numpy as np
from scipy.optimize import brentq, root
from scipy.special import ellipe, ellipk

from tests.reference.plain_angular_contact import DENSITY, NU, E, hertz, thrust_angle

S, W = np.polynomial.legendre.leggauss(24)
S, W = (S + 1) / 2, W / 2
PLACES, WEIGHTS = S * S * (3 - 2 * S), W * 6 * S * (1 - S)  # of a panel, crowded at its ends
COSINE = np.cos(pi * np.arange(1, 41) / 41)  # along a strip
SHARES = pi / 41 * (1 - COSINE**2)


def semi_axes(across, along):
    """Semi-axes a, b of the contact under one newton, from the sums of curvatures across and along."""
    total, rho = across + along, (along - across) / (across + along)

    def off(k):
        m = 1 - 1 / k**2
        return ((k * k + 1) * ellipe(m) - 2 * ellipk(m)) / ((k * k - 1) * ellipe(m)) - rho

    k = brentq(off, 1.001, 1000.0, xtol=1e-13)
    a = (2 * k * k * ellipe(1 - 1 / k**2) / pi * 3 * (1 - NU**2) / E / total) ** (1 / 3)
    return a, a / k


def friction(p, race, angle, load, ball, ring):
    """Force and moment (x, r, t) of friction on a ball; speeds of ball and ring are seen from the orbit."""
    side, D, f = (-1, p["D"], p["fi"]) if race == "inner" else (1, p["D"], p["fo"])
    g = D / p["dm"] * cos(p["alpha"])
    a, b = (
        s * load ** (1 / 3) for s in semi_axes(2 / D - 1 / (f * D), 2 / D - side * 2 / D * g / (1 + side * g))
    )
    R = 2 * f * D / (2 * f + 1)
    n, c = np.array([side * sin(angle), side * cos(angle), 0.0]), sqrt(R * R - a * a)
    t1, t = np.array([-n[1], n[0], 0.0]), np.array([0.0, 0.0, 1.0])
    w = np.array(ball) - [ring, 0.0, 0.0]  # against the ring

    def slips(x):
        """Along and across the rolling direction, in the middle of a strip."""
        h = np.sqrt(R * R - x * x) - c + sqrt(D * D / 4 - a * a)
        slip = np.cross(w, h[:, None] * n + x[:, None] * t1)
        return slip @ t - ring * p["dm"] / 2, slip @ t1, h

    grid = np.linspace(-a, a, 200)
    signs = slips(grid)[0]
    zeros = [
        brentq(lambda z: slips(np.array([z]))[0][0], *grid[k : k + 2], xtol=1e-18)
        for k in np.flatnonzero(signs[:-1] * signs[1:] < 0)
    ]
    edges = np.array([-a, *zeros, a])
    x = (edges[:-1, None] + np.diff(edges)[:, None] * PLACES).ravel()
    width = (np.diff(edges)[:, None] * WEIGHTS).ravel()
    along, middle, h = slips(x)
    y = b * np.sqrt(1 - (x / a) ** 2)[:, None] * COSINE
    across = middle[:, None] - y * (w @ n)  # y bends no surface: a narrow contact
    push = -p["mu"] * load * 1.5 / pi / a * (width * (1 - (x / a) ** 2))[:, None] * SHARES
    push /= np.hypot(along[:, None], across)
    force = (push * along[:, None])[..., None] * t + (push * across)[..., None] * t1
    arm = (h[:, None] * n + x[:, None] * t1)[:, None] + y[..., None] * t
    return force.sum((0, 1)), np.cross(arm, force).sum((0, 1))


def thrust_bearing(p, thrust, contact=friction, drag=lambda p, orbit: 0.0):  # noqa: PLR0915
    """Contact angles, loads, orbit, spin (x, r, t) and torque of the inner ring under a thrust."""
    D, dm, fi, fo, alpha, Z = (p[key] for key in ("D", "dm", "fi", "fo", "alpha", "Z"))
    mass, Rc, race = DENSITY * pi / 6 * D**3, dm / 2, D / dm * cos(alpha)
    Ki = hertz(2 / D - 1 / (fi * D), 2 / D + 2 / D * race / (1 - race))
    Ko = hertz(2 / D - 1 / (fo * D), 2 / D - 2 / D * race / (1 + race))
    distance = (fi + fo - 1) * D
    inertia, radial = mass * D * D / 10, distance * cos(alpha)
    beta = atan(sin(alpha) / (cos(alpha) + D / dm))
    found, motion = {}, np.array([0.0, 0.0, beta, -0.1])

    def moved(v, ai, ao):
        """Orbit and spin that slip by given speeds D/2 above both contacts, at angles beta and yaw."""
        slips, beta, yaw = v[:2] * 1e-3 * p["omega"] * Rc, v[2], v[3] * 1e-2
        rows = [
            [D / 2 * cos(ai - beta) * cos(yaw), Rc - D / 2 * cos(ai)],
            [-D / 2 * cos(ao - beta) * cos(yaw), Rc + D / 2 * cos(ao)],
        ]
        spin, orbit = np.linalg.solve(rows, slips + np.array([p["omega"] * (Rc - D / 2 * cos(ai)), 0.0]))
        return orbit, spin * np.array([-cos(beta) * cos(yaw), sin(beta) * cos(yaw), sin(yaw)])

    def place(v):
        axial, x, y = v * 1e-4
        ai, ao = atan2(axial - x, radial - y), atan2(x, y)
        Qi = Ki * max(hypot(axial - x, radial - y) - (fi - 0.5) * D, 0.0) ** 1.5
        Qo = Ko * max(hypot(x, y) - (fo - 0.5) * D, 0.0) ** 1.5

        def frictions(u):
            orbit, ball = moved(u, ai, ao)
            on_inner = contact(p, "inner", ai, Qi, ball, p["omega"] - orbit)
            return orbit, ball, on_inner, contact(p, "outer", ao, Qo, ball, -orbit)

        def driven(u):
            orbit, ball, (Fi, Mi), (Fo, Mo) = frictions(u)
            moment = Mi + Mo - inertia * orbit * np.cross([1.0, 0.0, 0.0], ball)
            return [((Fi + Fo)[2] - drag(p, orbit)) / (p["mu"] * Qi), *(moment / (p["mu"] * Qi * D / 2))]

        solution = root(driven, motion, tol=1e-11)
        assert np.abs(driven(solution.x)).max() < 1e-8, solution.message
        motion[:] = solution.x
        orbit, ball, (Fi, Mi), (Fo, _) = frictions(solution.x)
        found.update(angles=(ai, ao), loads=(Qi, Qo), orbit=orbit, spin=ball)
        found.update(torque=Z * (Fi[2] * Rc + Mi[0]), tractions=(hypot(*Fi[:2]), hypot(*Fo[:2])))
        carried = Qi * sin(ai) + Fi[0]
        axially = carried - Qo * sin(ao) + Fo[0]
        radially = Qi * cos(ai) - Qo * cos(ao) + Fi[1] + Fo[1] + mass * Rc * orbit**2
        return np.array([carried - thrust / Z, axially, radially]) / (thrust / Z)

    angle = thrust_angle(p, thrust)
    axial, share = radial * tan(angle), (fo - 0.5) / (fi + fo - 1)
    start = np.array([axial, share * axial, share * radial])
    solution = root(place, start * 1e4, tol=1e-10)
    assert np.abs(place(solution.x)).max() < 1e-8, solution.message
    return found
