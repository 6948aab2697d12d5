"""A thin ring on supports that only push, slow and in one file.

A polygon of straight Timoshenko beams in the plane; unknowns per node: displacement along y, z and rotation.
Lines hold nodes radially: every set of lines is tried, the right one pushes and leaves gaps. Springs at every
node: those that pull are taken away, those that the ring enters are put back, until nothing changes.
"""

from itertools import product

import numpy as np

SHEAR = 5 / 6
NODES = 360
SOFT = 1e-9  # part of EA/R that holds a ring which supports leave free to turn or roll


class PlainRing:
    """A ring of rectangular section, its middle at `radius` [m]."""

    def __init__(self, radius, thickness, width, youngs_modulus, poisson_ratio):
        self.azimuth = 2 * np.pi * np.arange(NODES) / NODES
        self.radius, area = radius, thickness * width
        E, G = youngs_modulus, youngs_modulus / (2 * (1 + poisson_ratio))
        bending, stretch = E * width * thickness**3 / 12, E * area
        place = radius * np.stack([np.sin(self.azimuth), np.cos(self.azimuth)], axis=1)
        self.stiffness = SOFT * stretch / radius * np.diag(np.tile([1.0, 1.0, 0.0], NODES))
        for first in range(NODES):
            second = (first + 1) % NODES
            along = place[second] - place[first]
            length = np.hypot(*along)
            (c, s) = along / length
            phi = 12 * bending / (SHEAR * G * area * length**2)
            k = bending / (length**3 * (1 + phi))
            a, b, d, e = 12 * k, 6 * k * length, (4 + phi) * k * length**2, (2 - phi) * k * length**2
            n = stretch / length
            local = np.array([
                [n, 0, 0, -n, 0, 0], [0, a, b, 0, -a, b], [0, b, d, 0, -b, e],
                [-n, 0, 0, n, 0, 0], [0, -a, -b, 0, a, -b], [0, b, e, 0, -b, d],
            ])  # fmt: skip
            turn = np.zeros((6, 6))
            for block in (0, 3):
                turn[block : block + 2, block : block + 2] = [[c, s], [-s, c]]
                turn[block + 2, block + 2] = 1.0
            where = np.r_[3 * first : 3 * first + 3, 3 * second : 3 * second + 3]
            self.stiffness[np.ix_(where, where)] += turn.T @ local @ turn

    def outward(self, azimuths):
        """Unit radial forces (unknowns, K) at the nearest nodes; they also read radial displacements."""
        nodes = np.rint(np.asarray(azimuths) / (2 * np.pi) * NODES).astype(int) % NODES
        loads = np.zeros((3 * NODES, len(nodes)))
        loads[3 * nodes, np.arange(len(nodes))] = np.sin(self.azimuth[nodes])
        loads[3 * nodes + 1, np.arange(len(nodes))] = np.cos(self.azimuth[nodes])
        return loads

    def under_teeth(self, teeth, rollers, forces):
        """Deviations at rollers of a free ring, less mean translation; teeth are (azimuth, radius, force)."""
        load = self.outward(rollers) @ forces
        for azimuth, radius, tangential in teeth:
            node = round(azimuth / (2 * np.pi) * NODES) % NODES
            load[3 * node] += tangential * np.cos(azimuth)
            load[3 * node + 1] -= tangential * np.sin(azimuth)
            load[3 * node + 2] -= tangential * (radius - self.radius)  # rotation counts from y to z
        return self._deviation(np.linalg.solve(self.stiffness, load), rollers)

    def on_lines(self, lines, rollers, forces):
        """Pushes of the lines, and deviations at the rollers less the mean translation of the ring."""
        hold, load = self.outward(lines), self.outward(rollers) @ forces
        free = np.linalg.solve(self.stiffness, np.column_stack([hold, load]))
        compliance, gaps = hold.T @ free[:, :-1], -hold.T @ free[:, -1]
        for chosen in product([False, True], repeat=len(lines)):
            touching = np.array(chosen)
            pushes = np.zeros(len(lines))
            pushes[touching] = np.linalg.solve(compliance[np.ix_(touching, touching)], -gaps[touching])
            left = gaps + compliance @ pushes
            if pushes.min() >= 0 and left.min() >= -1e-9 * np.abs(gaps).max():
                return pushes, self._deviation(free[:, -1] - free[:, :-1] @ pushes, rollers)
        raise AssertionError("no set of lines holds the ring by pushing")

    def on_springs(self, per_radian, rollers, forces, pull=False):
        """Inward push per radian at every node, and deviations at the rollers less the mean translation."""
        all_around, load = self.outward(self.azimuth), self.outward(rollers) @ forces
        spring = per_radian * 2 * np.pi / NODES
        touching = np.ones(NODES, dtype=bool)
        for _ in range(50):
            held = all_around[:, touching]
            u = np.linalg.solve(self.stiffness + spring * held @ held.T, load)
            entered = all_around.T @ u > 0
            if pull or np.array_equal(entered, touching):
                return per_radian * np.where(touching, all_around.T @ u, 0), self._deviation(u, rollers)
            touching = entered
        raise AssertionError("springs go on changing")

    def _deviation(self, u, rollers):
        radial = self.outward(self.azimuth).T @ u
        wave = np.stack([np.sin(self.azimuth), np.cos(self.azimuth)])
        translation = 2 / NODES * wave @ radial
        return (
            self.outward(rollers).T @ u - np.stack([np.sin(rollers), np.cos(rollers)], axis=1) @ translation
        )
