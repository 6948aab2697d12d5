"""The whole cylindrical roller bearing on one page: slow loops, every equation as printed.

Written independently of the package; SI units. `evaluate(...)` returns what must vanish at equilibrium and
what follows from it. Azimuth from z towards y, weights along z, index i inner and o outer raceway;
slopes are dz/dx and dy/dx of the inner ring, moments those that hold it there, in the same two planes.
"""

from itertools import pairwise
from math import asinh, cos, exp, log, log10, pi, sin, sqrt

PAPER = {
    "Z": 30, "D": 5e-3, "l": 5e-3, "outer_race": 75e-3, "clearance": 75.5e-6, "slices": 20,
    "E_roller": 209e9, "nu_roller": 0.3, "density": 7860.0, "E_ring": 203e9, "nu_ring": 0.28,
    "load": 19621.1, "inner_speed": 38000 * 2 * pi / 60, "mu_pocket": 0.05, "t_cage": 2.5e-3,
    "land": (37.3e-3, 3e-3, 0.2e-3), "oil_fraction": 0.16, "traction": "4109", "direction": 0.0,
    "roller_deviations": (),  # of the diameter of each roller
    "rows": ((0.0, 0.0, 0.0),),  # place along the axis, further clearance and azimuth of each
    "waves": (),  # amplitude towards the rollers, number, azimuth of a crest; of either raceway
}  # fmt: skip

DRAG = [(0.1, 60), (1, 10), (10, 3), (100, 1.8), (1e3, 1.0), (1e4, 1.2), (1e5, 1.2), (2e5, 1.2),
        (3e5, 0.9), (4e5, 0.65), (5e5, 0.3), (1e6, 0.3)]  # fmt: skip


def mu_4109(p, oil, Q, u, U, R, E):
    load = sqrt(Q**2 + (1e-7 * p["l"] * E * R) ** 2)
    P, Ub, Th = load / (E * R**2), oil["eta"] * U / (E * R), oil["k"] * oil["T"] / (oil["eta"] * U**2)
    A = -6.96e2 * P**-0.163 * Ub**0.577 * Th**0.308
    B = 5.19e6 * P**-0.373 * Ub**1.000 * Th**0.687
    C = 6.826e5 * P**-0.170 * Ub**0.578 * Th**0.373
    S = abs(u) / U
    return ((A + B * S) * exp(-C * S) - A) * (1 if u > 0 else -1)


def mu_eyring(p, oil, Q, u, h, R, E):
    load = sqrt((Q / p["l"]) ** 2 + (1e-7 * E * R) ** 2)
    b = sqrt(8 * load * R / (pi * E))
    pressure = load / (2 * b)
    L = log(oil["eta"]) + 9.67
    eta = oil["eta"] * exp(L * ((1 + pressure / 1.962e8) ** (oil["alpha"] * 1.962e8 / L) - 1))
    tau_E = 2 * 0.05 / oil["alpha"]
    tau = min(tau_E * asinh(eta * abs(u) / (tau_E * h)), 0.05 * pressure)
    return tau / pressure * (1 if u > 0 else -1)


def film(p, oil, Q, u, U, R, E):
    q = sqrt((Q / p["l"]) ** 2 + (1e-7 * E * R) ** 2)
    h = 2.65 * oil["alpha"] ** 0.54 * (oil["eta"] * U) ** 0.7 * R**0.43 / (q**0.13 * E**0.03)
    L = oil["eta"] * oil["beta"] * U**2 / oil["k"]
    return h / (1 + 0.1 * (1 + 14.8 * sqrt((u / U) ** 2 + 1e-6) ** 0.83) * L**0.64)


def rolling_shear(p, oil, Q, U, R, E):
    U2 = 2 * oil["eta"] * U / (E * R)
    M = Q / (p["l"] * E * R) / sqrt(U2)
    root = M / sqrt(M + 1e-3)
    return p["l"] * E * R * U2**0.75 / 0.985 * 1.4 * root / (1 + (1.4 / 1.45 * root) ** 10) ** 0.1


def drag(p, oil, V):
    Re = oil["rho"] * p["D"] * abs(V) / oil["eta"]
    for (a, ca), (b, cb) in pairwise(DRAG):
        if a <= Re <= b:
            Cd = ca + (cb - ca) * log10(Re / a) / log10(b / a)
    rho = p["oil_fraction"] * oil["rho"] + (1 - p["oil_fraction"]) * 1.2
    return 0.5 * rho * Cd * V * abs(V) * p["l"] * (p["D"] - p["t_cage"])


def raceway(p, oil, approach, tilt, u, U, h, R, E):
    """Load, moment, traction and inlet shear of one roller on one raceway, slice by slice."""
    B = (1 - p["nu_roller"] ** 2) / (pi * p["E_roller"]) + (1 - p["nu_ring"] ** 2) / (pi * p["E_ring"])
    n, length = p["slices"], p["l"]
    Q = M = T = 0.0
    for k in range(n):
        x = (k + 0.5) * length / n - length / 2
        d = approach + tilt * x
        e2 = (2e-8 * p["D"]) ** 2
        closed = (d + sqrt(d**2 + e2)) / 2 if d > 0 else e2 / (2 * (sqrt(d**2 + e2) - d))
        q = (closed * length**0.8 / 3.81) ** (1 / 0.9) / B / length
        mu = (
            mu_4109(p, oil, q * length, u, U, R, E)
            if p["traction"] == "4109"
            else mu_eyring(p, oil, q * length, u, h, R, E)
        )
        Q, M, T = Q + q * length / n, M + q * x * length / n, T + mu * q * length / n
    return Q, M, T, rolling_shear(p, oil, Q, U, R, E)


def height(p, phi, j):
    """Of both raceways over round ones and of roller j over a nominal one, towards each other."""
    roller = p["roller_deviations"][j] if p["roller_deviations"] else 0.0
    return roller + sum(a * cos(n * (phi - crest)) for a, n, crest in p["waves"])


def of_row(p, j):
    """Place along the axis, further clearance and azimuth of roller j, and the one before it in its row."""
    row, number = divmod(j, p["Z"])
    x, room, turned = p["rows"][row]
    return x, room, 2 * pi * number / p["Z"] + turned, j - 1 if number else j + p["Z"] - 1


def evaluate(p, oil, y, z, slopes, omega_c, e, tilt, spin, films):
    """Residuals of ring, cage and rollers, and outputs; pairs are inner and outer, lists run over rollers."""
    Z, D, dm = p["Z"], p["D"], p["outer_race"] - p["D"]
    g, r_m, r_w, r_i, r_o = D / dm, dm / 2, D / 2, p["outer_race"] / 2 - D, p["outer_race"] / 2
    mass = p["density"] * pi / 4 * D**2 * p["l"]
    E = 2 / ((1 - p["nu_roller"] ** 2) / p["E_roller"] + (1 - p["nu_ring"] ** 2) / p["E_ring"])
    R_i, R_o = r_w * r_i / (r_i + r_w), r_w * r_o / (r_o - r_w)
    ring_y, ring_z = p["load"] * sin(p["direction"]), p["load"] * cos(p["direction"])
    cage, moment_z, moment_y, rollers = 0.0, 0.0, 0.0, []
    for j in range(Z * len(p["rows"])):
        x, room, phi, before = of_row(p, j)
        u_i, u_o = (p["inner_speed"] - omega_c) * r_i - spin[j] * r_w, spin[j] * r_w - omega_c * r_o
        U_i, U_o = (
            ((p["inner_speed"] - omega_c) * r_i + spin[j] * r_w) / 2,
            (spin[j] * r_w + omega_c * r_o) / 2,
        )
        h_i, h_o = films[0][j], films[1][j]
        slope = slopes[0] * cos(phi) + slopes[1] * sin(phi)
        between = z * cos(phi) + y * sin(phi) + x * slope - (p["clearance"] + room) / 2 + height(p, phi, j)
        Q_i, M_i, T_i, F_i = raceway(
            p, oil, between - e[j] + h_i + h_o, slope - tilt[j], u_i, U_i, h_i, R_i, E
        )
        Q_o, M_o, T_o, F_o = raceway(p, oil, e[j], tilt[j], u_o, U_o, h_o, R_o, E)
        F_g = drag(p, oil, omega_c * r_m)
        F_c = -(T_i + T_o + (1 - 2 * g) * F_i - (1 + 2 * g) * F_o - F_g - mass * 9.81 * sin(phi))
        mu, close = p["mu_pocket"] * sense(p, spin[j]), 1e-10 * p["l"] * E * R_i
        friction = mu * F_c**2 / sqrt(F_c**2 + close**2)
        radial = Q_i - Q_o + mass * (r_m * omega_c**2 + 9.81 * cos(phi)) + mu * F_c
        inertia = mass * D**2 / 8 * omega_c * (spin[j] - spin[before]) / (2 * pi / Z)
        rollers.append({
            "radial": radial, "tilting": M_o - M_i,
            "spinning": r_w * (T_i - T_o - F_i - F_o - friction) - inertia,
            "load": (Q_i, Q_o), "moment": (M_i, M_o), "traction": (T_i, T_o), "rolling": (F_i, F_o),
            "sliding": (u_i, u_o), "entrainment": (U_i, U_o), "drag": F_g, "cage_force": F_c,
            "pocket_friction": (mu * F_c, friction), "inertia": inertia,
            "film": (film(p, oil, Q_i, u_i, U_i, R_i, E), film(p, oil, Q_o, u_o, U_o, R_o, E)),
        })  # fmt: skip
        tangential = T_i + F_i * (1 - 2 * g)
        along_y, along_z = Q_i * sin(phi) + tangential * cos(phi), Q_i * cos(phi) - tangential * sin(phi)
        ring_y, ring_z = ring_y - along_y, ring_z - along_z
        moment_z, moment_y = moment_z + M_i * cos(phi) + x * along_z, moment_y + M_i * sin(phi) + x * along_y
        cage -= F_c * r_m + friction * D / 2
    outputs = {name: [roller[name] for roller in rollers] for name in rollers[0]}
    outputs |= {"ring_moment": (moment_z, moment_y), **torques(p, oil, rollers, omega_c)}
    return outputs | {"ring": (ring_y, ring_z), "cage": cage + outputs["land_torque"]}


def sense(p, spin):
    """Sense of the spin, smooth through a thousandth of that of pure rolling."""
    g = p["D"] / (p["outer_race"] - p["D"])
    return spin / sqrt(spin**2 + (1e-3 * p["inner_speed"] * (1 - g**2) / (2 * g)) ** 2)


def torques(p, oil, rollers, omega_c):
    """Of the outer ring's land on the cage, of the drive of the inner ring, of the hold of the outer one."""
    R_l, width, c = p["land"]
    land = -2 * pi * oil["eta"] * R_l**3 * width / c * omega_c
    inner = sum(roller["traction"][0] + roller["rolling"][0] for roller in rollers)
    outer = sum(roller["traction"][1] - roller["rolling"][1] for roller in rollers)
    r_o = p["outer_race"] / 2
    return {
        "land_torque": land,
        "driving_torque": inner * (r_o - p["D"]),
        "outer_torque": outer * r_o + land,
    }
