"""The bearing of `plain_bearing` in the time domain: rollers run, spin and hit their pockets.

Nothing makes a roller follow the cage but the pocket, a gap between two damped springs: its force is a
result of the motion and not of a balance. Only the directions without slow motion, the inner ring and the
rollers between the raceways, are in balance at every instant. SI units; one slice, which is exact for a
straight roller between aligned rings. Arrays are (Z,) rollers or (2, Z), index 0 inner and 1 outer
raceway; azimuth as in `plain_bearing`. `spin` is the speed of a roller relative to its own orbit.
"""

from dataclasses import dataclass, field
from itertools import islice

import numpy as np

from tests.reference.plain_bearing import DRAG, PAPER

POCKET = {"gap": 0.1e-3, "stiffness": 2e6, "damping": 40.0, "cage_mass": 0.025}  # [m], [N/m], [N s/m], [kg]
CLOSE = 1e-18  # [m2] square of the rounding of the contact law, wider than in the plain model


def friction(oil, Q, u, U, R, E):
    """Traction coefficient [-] of oil 4109 under a load Q [N], sliding u and entrainment U [m/s]."""
    P, Ub = np.sqrt(Q**2 + (1e-7 * PAPER["l"] * E * R) ** 2) / (E * R**2), oil["eta"] * U / (E * R)
    Th = oil["k"] * oil["T"] / (oil["eta"] * U**2)
    log_P, log_U, log_T = np.log(P), np.log(Ub), np.log(Th)
    A = -6.96e2 * np.exp(-0.163 * log_P + 0.577 * log_U + 0.308 * log_T)
    B = 5.19e6 * np.exp(-0.373 * log_P + log_U + 0.687 * log_T)
    C = 6.826e5 * np.exp(-0.170 * log_P + 0.578 * log_U + 0.373 * log_T)
    S = np.abs(u) / U
    return ((A + B * S) * np.exp(-C * S) - A) * np.sign(u)


def film(p, oil, Q, u, U, R, E):
    """Thickness of the oil film [m], thinned by the heat of the inlet."""
    q = np.hypot(Q, p.get("least", 1e-7 * p["l"] * E * R)) / p["l"]
    h = 2.65 * oil["alpha"] ** 0.54 * (oil["eta"] * U) ** 0.7 * R**0.43 / (q**0.13 * E**0.03)
    L = oil["eta"] * oil["beta"] * U**2 / oil["k"]
    return h / (1 + 0.1 * (1 + 14.8 * np.hypot(u / U, 1e-3) ** 0.83) * L**0.64)


def rolling_shear(p, oil, Q, U, R, E):
    """Shear force of the inlet [N], >= 0, against rolling."""
    U2 = 2 * oil["eta"] * U / (E * R)
    M = Q / (p["l"] * E * R) / np.sqrt(U2)
    root = M / np.sqrt(M + 1e-3)
    return p["l"] * E * R * U2**0.75 / 0.985 * 1.4 * root / (1 + (1.4 / 1.45 * root) ** 10) ** 0.1


def drag(p, oil, V):
    """Force [N] of the mixture of oil and air on a roller that orbits at V [m/s]."""
    reynolds, coefficient = np.array(DRAG).T
    Re = oil["rho"] * p["D"] * np.abs(V) / oil["eta"]
    Cd = np.interp(np.log10(Re), np.log10(reynolds), coefficient)
    rho = p["oil_fraction"] * oil["rho"] + (1 - p["oil_fraction"]) * 1.2
    return 0.5 * rho * Cd * V * np.abs(V) * p["l"] * (p["D"] - p["t_cage"])


@dataclass
class Forces:
    """Everything that acts at one instant."""

    load: np.ndarray  # (2, Z) [N]
    traction: np.ndarray  # (2, Z) [N] raceway on roller, along its orbit
    shear: np.ndarray  # (2, Z) [N] of the inlets, >= 0
    pocket: np.ndarray  # (Z,) [N] cage on roller, along its orbit
    rubbing: np.ndarray  # (Z,) [N] friction in the pocket, >= 0, against spin
    drag: np.ndarray  # (Z,) [N] against the orbit
    land: float  # [N m] torque on the cage


@dataclass
class TimeDomain:
    """Equations of motion; `ring`, `approach` and `films` are the last balance, where the next one starts."""

    p: dict
    oil: dict
    ring: np.ndarray = field(init=False)  # (2,) displacement of the inner ring y, z [m]
    approach: np.ndarray = field(init=False)  # (Z,) elastic approach at the outer raceway [m]
    films: np.ndarray = field(init=False)  # (2, Z) [m]

    def __post_init__(self):
        p = self.p
        self.ring, self.approach = np.array([0.0, 70e-6]), np.full(p["Z"], 10e-6)
        self.films = np.full((2, p["Z"]), 0.3e-6)
        self.r_m, self.r_w = (p["outer_race"] - p["D"]) / 2, p["D"] / 2
        self.g = self.r_w / self.r_m
        self.r_i, self.r_o = self.r_m - self.r_w, self.r_m + self.r_w
        self.mass = p["density"] * np.pi / 4 * p["D"] ** 2 * p["l"]
        self.inertia, self.cage_inertia = self.mass * p["D"] ** 2 / 8, p["cage_mass"] * self.r_m**2
        roller, ring = ((1 - p["nu_" + part] ** 2) / p["E_" + part] for part in ("roller", "ring"))
        self.E, self.B = 2 / (roller + ring), (roller + ring) / np.pi
        self.R = self.r_w * np.array([[self.r_i / self.r_m], [self.r_o / self.r_m]])
        self.seat = 2 * np.pi * np.arange(p["Z"]) / p["Z"]  # pocket centres relative to the cage [rad]

    def kinematic_start(self):
        """State of rolling without sliding, made of what `parts` names."""
        cage = self.p["inner_speed"] * self.r_i / (2 * self.r_m)
        spin, same = cage * self.r_o / self.r_w, np.ones(self.p["Z"])
        return np.concatenate([self.seat, cage * same, spin * same, [0.0, cage]])

    def parts(self, state):
        """Angles [rad], orbital speeds and spins [rad/s] of the rollers, angle and speed of the cage."""
        return *state[:-2].reshape(3, -1), state[-2], state[-1]

    def rate(self, state):
        """Time derivative of the state."""
        return self.response(state, self.forces(state))

    def response(self, state, f):
        """Time derivative of the state under forces f."""
        _, orbit, _, _, cage = self.parts(state)
        inner, outer = (1 - 2 * self.g) * f.shear[0], (1 + 2 * self.g) * f.shear[1]
        push = f.traction[0] + f.traction[1] + inner - outer - f.drag + f.pocket
        turn = f.traction[0] - f.traction[1] - f.shear[0] - f.shear[1] - f.rubbing
        faster = push / (self.mass * self.r_m)
        cage_torque = f.land - f.pocket.sum() * self.r_m - f.rubbing.sum() * self.r_w
        spin_rate = turn * self.r_w / self.inertia + faster  # the orbit itself turns the roller back
        return np.concatenate([orbit, faster, spin_rate, [cage, cage_torque / self.cage_inertia]])

    def forces(self, state):
        """Forces of all parts, with the ring and the rollers in balance across the raceways."""
        p = self.p
        angle, orbit, spin, cage_angle, cage = self.parts(state)
        pocket = self.pocket(self.r_m * (cage_angle + self.seat - angle), self.r_m * (cage - orbit))
        rubbing = p["mu_pocket"] * np.abs(pocket)
        outwards = self.mass * self.r_m * orbit**2 + p["mu_pocket"] * pocket
        inner, outer, roller = (p["inner_speed"] - orbit) * self.r_i, orbit * self.r_o, spin * self.r_w
        u, U = np.array([inner - roller, roller - outer]), np.array([inner + roller, roller + outer]) / 2
        load, traction, shear = self.balance(angle, outwards, u, U)
        radius, width, clearance = p["land"]
        land = -2 * np.pi * self.oil["eta"] * radius**3 * width / clearance * cage
        return Forces(load, traction, shear, pocket, rubbing, drag(p, self.oil, orbit * self.r_m), land)

    def pocket(self, lag, rate):
        """Force [N] of the cage on rollers that lag [m] behind the pocket centre, growing at a rate [m/s]."""
        depth = np.abs(lag) - self.p["gap"] / 2
        push = self.p["stiffness"] * depth + self.p["damping"] * rate * np.sign(lag)
        return np.sign(lag) * np.where(depth > 0, np.maximum(push, 0.0), 0.0)

    def balance(self, angle, outwards, u, U):
        """Loads, tractions and shears (2, Z) [N] that hold ring and rollers.

        `outwards` [N] pulls a roller from the axis; u, U sliding and entrainment (2, Z) [m/s].
        """
        p = self.p
        normal = np.array([np.sin(angle), np.cos(angle)])
        along = np.array([np.cos(angle), -np.sin(angle)])
        for _ in range(50):
            inner = self.ring @ normal - p["clearance"] / 2 - self.approach + self.films.sum(axis=0)
            load, stiffness = self.contact(np.array([inner, self.approach]))
            traction = load * friction(self.oil, load, u, U, self.R, self.E)
            shear = rolling_shear(p, self.oil, load, U, self.R, self.E)
            tangential = traction[0] + (1 - 2 * self.g) * shear[0]
            on_ring = np.array([0.0, p["load"]]) - normal @ load[0] - along @ tangential
            on_roller = load[0] - load[1] + outwards
            films = film(p, self.oil, load, u, U, self.R, self.E)
            change = np.abs(films - self.films).max()
            self.films = films
            if max(np.abs(on_ring).max(), np.abs(on_roller).max()) < 1e-2 and change < 1e-10:
                return load, traction, shear
            share = stiffness[0] / stiffness.sum(axis=0)
            both = normal * (share * stiffness[1]) @ normal.T
            move = np.linalg.solve(both, on_ring + normal @ (share * on_roller))
            self.ring = self.ring + move
            self.approach = self.approach + on_roller / stiffness.sum(axis=0) + share * (move @ normal)
        raise ArithmeticError("the ring finds no balance")

    def contact(self, approach):
        """Load [N] and stiffness [N/m] of contacts at an elastic approach [m], smooth where they close."""
        root = np.sqrt(approach**2 + CLOSE)
        closed = np.where(approach > 0, approach + root, CLOSE / (root + np.abs(approach))) / 2
        load = (closed * self.p["l"] ** 0.8 / 3.81) ** (1 / 0.9) / self.B
        return load, load / 0.9 / root


def later(rate, state, dt):
    """State one step dt [s] later: the classical Runge-Kutta scheme."""
    a = rate(state)
    b = rate(state + dt / 2 * a)
    c = rate(state + dt / 2 * b)
    d = rate(state + dt * c)
    return state + dt / 6 * (a + 2 * b + 2 * c + d)


def passages(model, state, dt):
    """Whenever the cage has turned by one pocket: its mean speed meanwhile [rad/s], the state then."""
    pitch, time, told = 2 * np.pi / model.p["Z"], 0.0, 0.0
    while True:
        new = later(model.rate, state, dt)
        part = (np.ceil(state[-2] / pitch + 1e-9) * pitch - state[-2]) / (new[-2] - state[-2])
        if part <= 1:
            yield pitch / (time + part * dt - told), state + part * (new - state)
            told = time + part * dt
        state, time = new, time + dt


def settled(model, dt=3e-6, tolerance=1e-6, limit=300):
    """Mean cage speed [rad/s] and state when a passage is like the last, from rolling without sliding.

    Half the step changes the slip by 1e-4 of itself, a tenth of the tolerance by 5e-4.
    """
    before = 0.0
    for speed, state in islice(passages(model, model.kinematic_start(), dt), limit):
        if abs(speed - before) < tolerance * speed:
            return speed, state
        before = speed
    raise ArithmeticError("the motion does not become periodic")
