"""A thrust-loaded angular-contact bearing in oil on one page: slow, from Newton and Euler.

The bearing of `plain_coulomb_ball`, its friction that of an isothermal Eyring film with a limiting stress,
summed as vectors over points of each contact, the shear and the pressure of the inlets, and drag.
"""

from math import cos, exp, log, pi, sin, sqrt

import numpy as np

from tests.reference.plain_angular_contact import NU, E
from tests.reference.plain_coulomb_ball import COSINE, SHARES, semi_axes

MODULUS = E / (1 - NU**2)
T, W = np.polynomial.legendre.leggauss(120)
PLACES, WEIGHTS = np.sin(pi / 2 * T), W * pi / 2 * np.cos(pi / 2 * T)  # across, over the semi-axis


def contact(p, race, angle, load, ball, ring):  # noqa: PLR0915
    """Force and moment (x, r, t) of a race in oil on a ball; speeds are seen from the orbit."""
    side, D, f = (-1, p["D"], p["fi"]) if race == "inner" else (1, p["D"], p["fo"])
    g, Rc = D / p["dm"] * cos(p["alpha"]), p["dm"] / 2
    flat, steep = 2 / D - 1 / (f * D), 2 / D - side * 2 / D * g / (1 + side * g)
    a, b = (s * load ** (1 / 3) for s in semi_axes(flat, steep))
    R, Rx, eta = 2 * f * D / (2 * f + 1), 1 / steep, p["eta"]
    n, c = np.array([side * sin(angle), side * cos(angle), 0.0]), sqrt(R * R - a * a)
    t1, t = np.array([-n[1], n[0], 0.0]), np.array([0.0, 0.0, 1.0])
    turn = np.array([ring, 0.0, 0.0])
    x = a * PLACES
    h = np.sqrt(R * R - x * x) - c + sqrt(D * D / 4 - a * a)
    h0 = R - c + sqrt(D * D / 4 - a * a)

    # speeds of both surfaces through the middle, and the film there
    of_ball = np.cross(np.array(ball), h0 * n) @ t
    of_race = np.cross(turn, h0 * n) @ t + ring * Rc
    mean = (of_ball + of_race) / 2
    U, G, k = eta * abs(mean) / (MODULUS * Rx), p["thick"] * MODULUS, a / b
    film = 2.69 * Rx * U**0.67 * G**0.53 * (load / (MODULUS * Rx**2)) ** -0.067 * (1 - 0.61 * exp(-0.73 * k))

    # traction: the coefficient of each strip's mean pressure at the slip of each point, of the pressure there
    p0 = 1.5 * load / (pi * a * b)
    pressure = pi / 4 * p0 * np.sqrt(1 - PLACES**2)[:, None]
    span = log(eta) + 9.67
    viscosity = eta * np.exp(span * ((1 + pressure / 1.962e8) ** (p["thick"] * 1.962e8 / span) - 1))
    slip = np.cross(np.array(ball) - turn, h[:, None] * n + x[:, None] * t1)
    y = b * np.sqrt(1 - PLACES**2)[:, None] * COSINE
    along = (slip @ t - ring * Rc)[:, None] + 0 * y
    across = (slip @ t1)[:, None] - y * ((np.array(ball) - turn) @ n)
    size = np.hypot(along, across)
    stress = p["eyring"] * np.arcsinh(viscosity * size / (p["eyring"] * film))
    coefficient = np.minimum(stress / pressure, p["limit"])
    push = -coefficient * load * 1.5 / pi * (WEIGHTS * (1 - PLACES**2))[:, None] * SHARES / size
    force = (push * along)[..., None] * t + (push * across)[..., None] * t1
    arm = (h[:, None] * n + x[:, None] * t1)[:, None] + y[..., None] * t
    F, M = force.sum((0, 1)), np.cross(arm, force).sum((0, 1))

    # inlet: shear on the ball at the contact, pressure at its centre
    U2, beta = 2 * U, 2 * a * b * b * MODULUS / (3 * load * Rx)
    heavy, light = 1.8 * beta**-0.25, 0.77 * beta ** (-1 / 3) * (b / a) ** 0.12 * U2 ** (-1 / 12)
    m = beta**0.25 * b / a * load / (MODULUS * Rx**2) * U2**-0.75
    ellipse, line = (
        heavy + (light - heavy) / (1 + m / 6.6),
        1.42 * sqrt(load / (2 * a * MODULUS * Rx * sqrt(U2))),
    )
    shear = 2 * a * MODULUS * Rx * U2**0.75 * (ellipse**-10 + line**-10) ** -0.1
    shear *= mean / abs(mean)
    return F + (2 * (Rc + n[1] * h0) / Rc - 1) * shear * t, M + np.cross(h0 * n, -shear * t)


def drag(p, orbit):
    """Force of the mixture against the orbit."""
    return p["Cd"] / 2 * p["rho"] * pi / 4 * p["D"] ** 2 * (orbit * p["dm"] / 2) ** 2
