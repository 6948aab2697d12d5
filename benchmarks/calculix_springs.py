r"""A bearing in an elastic ring as input of CalculiX: slices of rollers as nonlinear springs.

CalculiX takes the whole at once: ring of quadratic hexahedra (C3D20), every slice of every roller a
nonlinear spring (SPRINGA) from the inner ring to the mean displacement (*EQUATION) of its patch of the
raceway: as long as the slice, a Gaussian along the arc. Its law is that of both raceways in series, with half
the clearance and the drop of the profile as dead zone,

.. math:: a(F) = (F / b c)^{0.9} + G/2 + 2 C_k - h_k F

with h_k F what a half-space yields, on the mean over the patch of slice k, to a load spread evenly over all
patches of the roller: the law of contact owns that already, and the ring yields it once more. A clamped side
loads slices unevenly, so each run after the first adds to the dead zone of every spring what turns h_k F
into (H F)_k, with the whole matrix H of slice on slice and the loads of the run before. Two widths of the
patches tell whether the split works: without it the loads would follow the width.

CalculiX 2.20 knows nonlinear springs only in an iteration of Newton, which NLGEOM or a plastic material
calls for. The ring is linear: a clamped cube of a plastic material lies beside it. From an open gap only a
given displacement leads CalculiX to a solution, so the inner ring is moved, and flexbearing gets the force
that this takes. The springs are a metre long to keep their directions; the forces they print
must obey their law at the displacements printed, or the run is refused.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import sparse

import fem
import quasidynamic as qd
from benchmarks.calculix import Hexahedra, between, clamped, elastic, rows, simpson
from quasidynamic.contact.line import EXPONENT, Slices, palmgren

SLICES = 10
MOVED = 0.045  # [mm] inner ring, where a side of the outer one is clamped
SPRING = 1000.0  # [mm] long against all displacements
MOST = 2000.0  # [N] end of the table of a slice
POINTS = 150  # of the table; CalculiX 2.20 goes wrong above 200, in silence
REACH = 5.0  # standard deviations of a patch
LAWFUL = 1e-3  # of the largest slice load
SOFT, SOFTNESS = 100000, 10.0  # number of the first, and stiffness [N/mm] of springs that hold a loose rim
MM = 1e3


@dataclass(frozen=True)
class Springs:
    """Slice springs of all rollers of a bearing in a ring; lengths in mm, Z rollers of all rows, K slices."""

    bearing: qd.CylindricalRollerBearing
    ring: fem.OuterRing
    width: float  # of the patches [mm]
    moved: float = MOVED  # of the inner ring [mm]

    @cached_property
    def slices(self) -> Slices:
        return Slices(SLICES, MM * self.bearing.roller.length)

    @property
    def radius(self) -> float:
        """Of the raceway [mm]."""
        return MM * self.ring.raceway_diameter / 2

    @property
    def azimuths(self) -> NDArray:
        """Of all springs (Z K), roller by roller [rad]."""
        return np.repeat(self.bearing.azimuths, SLICES)

    @cached_property
    def centres(self) -> NDArray:
        """Axial places of all springs (Z K)."""
        of_rows = [MM * row.axial + self.slices.all_centres for row in self.bearing.rows]
        return np.concatenate([np.tile(places, self.bearing.rollers) for places in of_rows])

    @property
    def normal(self) -> NDArray:
        """Outward direction (Z K, 3) of every spring."""
        return np.stack([np.zeros(self.azimuths.size), np.cos(self.azimuths), np.sin(self.azimuths)], axis=1)

    @cached_property
    def half_space(self) -> NDArray:
        """Indentation (K, K) [mm/N] of a half-space at the patches of a roller under each of them."""
        t, step = np.linspace(-40.0, 3.0, 861, retstep=True)
        s = np.sqrt(2) * self.width * np.exp(t)  # distance of two points of the Gaussian
        weight = 2 * s * step * np.exp(-((s / self.width) ** 2) / 4) / (2 * self.width * np.sqrt(np.pi))
        apart = self.slices.width * np.arange(-1, SLICES + 1)[:, None]
        integral = np.diff(apart * np.arcsinh(apart / s) - np.hypot(apart, s), 2, axis=0) @ weight
        steel, k = self.ring.materials["ring"], np.arange(SLICES)
        modulus = steel.youngs_modulus / MM**2 / (1 - steel.poisson_ratio**2)
        return integral[abs(k[:, None] - k)] / (np.pi * modulus * self.slices.width**2)

    @property
    def gap(self) -> NDArray:
        """What the rows have of clearance beyond that of the bearing, half of it, (Z, 1)."""
        further = [MM * row.clearance / 2 for row in self.bearing.rows]
        return np.repeat(further, self.bearing.rollers)[:, None]

    def approach(self, load: NDArray) -> NDArray:
        """Raceways' approach a (..., K) [mm] for loads of the slices (..., K) [N], contact closed."""
        roller, own = self.bearing.roller, self.slices
        each = [
            MM * (load / own.width * MM / palmgren(roller.material, raceway, roller.length)) ** (1 / EXPONENT)
            for raceway in (self.bearing.inner_ring, self.bearing.outer_ring)
        ]
        dead = self.bearing.clearance / 2 + 2 * roller.profile.drop(own.all_centres / MM, roller.length)
        return sum(each) + MM * dead - self.half_space.sum(axis=1) * load

    @cached_property
    def table(self) -> tuple[NDArray, NDArray]:
        """Loads (points, 1) [N], even in their cubic root, and approaches (points, K) [mm]."""
        load = MOST * np.linspace(0.0, 1.0, POINTS)[:, None] ** 3
        approach = self.approach(load)
        if not (np.diff(approach, axis=0) > 0).all():
            raise RuntimeError("the half-space yields more than the contact: the patches are too narrow")
        return load, approach

    def uneven(self, load: NDArray) -> NDArray:
        """Dead zones (Z, K) [mm] of rows, and that turn h F into H F under unlike loads (Z, K) [N]."""
        return self.gap + load * self.half_space.sum(axis=1) - load @ self.half_space


def meshed(springs: Springs, along: int, shoulder: int, radial: int, around: int) -> Hexahedra:
    """Elements whose ends are those of the rollers, smaller towards the corners of the clamp."""
    half, end = springs.slices.length / 2, MM * springs.ring.width / 2
    graded = 1 - (1 - np.arange(1, shoulder + 1) / shoulder) ** 2
    below = [MM * row.axial + np.linspace(-half, half, along + 1) for row in springs.bearing.rows]
    last = below[-1][-1]
    axial = np.concatenate([[-end], *below, last + (end - last) * graded])
    deep = (1 - np.cos(np.pi * np.arange(radial + 1) / radial)) / 2
    return between(axial, springs.radius + MM * springs.ring.thickness * deep, around)


def patches(springs: Springs, mesh: Hexahedra) -> sparse.csr_array:
    """Shares (Z K, nodes + 1) of the nodes in the load of a slice, and in the mean that it feels."""
    own, around = springs.slices, mesh.number.shape[2] // 2
    ends = np.linspace(-own.length / 2, own.length / 2, 2 * SLICES + 1)
    each = [gauss(MM * row.axial + ends, 2) for row in springs.bearing.rows]
    x, dx = (np.concatenate(parts) for parts in zip(*each, strict=True))
    phi, dphi = gauss(2 * np.pi / around * np.arange(around + 1), 6)
    arc = springs.radius * np.angle(np.exp(1j * (phi - springs.azimuths[:, None])))
    along_arc = (
        np.where(abs(arc) < REACH * springs.width, np.exp(-((arc / springs.width) ** 2) / 2), 0.0) * dphi
    )
    along_axis = np.where(abs(x - springs.centres[:, None]) < own.width / 2, dx, 0.0)
    share = np.einsum("sx,sp->sxp", along_axis, along_arc).reshape(springs.azimuths.size, -1)
    found = sparse.csr_array(share) @ raceway_shapes(mesh, x, phi)
    return sparse.csr_array(sparse.diags_array(1 / found.sum(axis=1)) @ found)


def gauss(ends: NDArray, order: int) -> tuple[NDArray, NDArray]:
    """Points and weights of Gauss's rule between all neighbouring ends."""
    node, weight = np.polynomial.legendre.leggauss(order)
    half = np.diff(ends)[:, None] / 2
    return (ends[:-1, None] + half * (node + 1)).ravel(), (half * weight).ravel()


def raceway_shapes(mesh: Hexahedra, x: NDArray, phi: NDArray) -> sparse.csr_array:
    """Shape functions (x phi, nodes + 1) on the inner surface at all pairs of places."""
    ends, around = mesh.axial[::2], mesh.number.shape[2] // 2
    i = np.clip(np.searchsorted(ends, x) - 1, 0, ends.size - 2)
    k = (phi / (2 * np.pi) * around).astype(int)
    xi = (2 * (x - ends[i]) / np.diff(ends)[i] - 1)[:, None]
    eta = (2 * (phi / (2 * np.pi) * around - k) - 1)[None, :]
    point = np.arange(xi.size * eta.size).reshape(xi.size, eta.size)
    shape = point.size, mesh.number.max() + 1
    total = sparse.csr_array(shape)
    for a, b in ((-1, -1), (-1, 1), (1, -1), (1, 1), (0, -1), (0, 1), (-1, 0), (1, 0)):
        value = serendipity(xi, eta, a, b)
        node = mesh.number[(2 * i + 1 + a)[:, None], 0, (2 * k + 1 + b)[None, :] % mesh.number.shape[2]]
        total += sparse.csr_array((value.ravel(), (point.ravel(), node.ravel())), shape=shape)
    return total


def serendipity(xi: NDArray, eta: NDArray, a: int, b: int) -> NDArray:
    """Shape function of the node at (a, b) of a face of eight nodes."""
    if a and b:
        return (1 + a * xi) * (1 + b * eta) * (a * xi + b * eta - 1) / 4
    return (1 - xi**2) * (1 + b * eta) / 2 if b else (1 + a * xi) * (1 - eta**2) / 2


def deck(springs: Springs, mesh: Hexahedra, dead: NDArray) -> str:
    """Input of CalculiX, with dead zones (Z, K) [mm] further than those of the law."""
    held = between_teeth if isinstance(springs.ring.support, fem.PlanetGear) else clamped
    steel, load = springs.ring.materials["ring"], patches(springs, mesh)
    count, last = springs.azimuths.size, int(mesh.number.max())
    outer, inner = last + 1 + np.arange(count), last + 1 + count + np.arange(count)
    elements = len(mesh.elements)
    x = springs.centres[:, None] * [1, 0, 0]
    lines = [
        *held(mesh, steel.youngs_modulus / MM**2, steel.poisson_ratio),
        "*NODE, NSET=OUTER", *rows(outer, x + springs.radius * springs.normal),
        "*NODE, NSET=INNER", *rows(inner, x + (springs.radius - SPRING) * springs.normal),
        *plastic_cube(int(inner[-1]) + 1, elements + 1),
        "*BOUNDARY", "OUTER, 1, 1", "INNER, 1, 1", "INNER, 3, 3",
    ]  # fmt: skip
    for spring, node in enumerate(outer):
        lines += mean(int(node), load[[spring]].tocoo())
    force, approach = springs.table
    for spring, further in enumerate(dead.ravel()):
        lines += [f"*ELEMENT, TYPE=SPRINGA, ELSET=SLICE{spring}"]
        lines += [f"{elements + 2 + spring}, {inner[spring]}, {outer[spring]}"]
        lines += [f"*SPRING, ELSET=SLICE{spring}, NONLINEAR"]
        pairs = zip(force[::-1, 0], approach[::-1, spring % SLICES] + further, strict=True)
        lines += [f"{-f:.11f}, {-a:.11f}" for f, a in pairs] + ["0., 1."]
    lines += [
        "*STEP, INC=100", "*STATIC", "1., 1.", "*CONTROLS, PARAMETERS=FIELD", "1e-5, 1e-4",
        "*BOUNDARY", f"INNER, 2, 2, {springs.moved}",
        "*NODE PRINT, NSET=INNER", "RF", "*NODE PRINT, NSET=OUTER", "U", "*END STEP",
    ]  # fmt: skip
    return "\n".join(lines) + "\n"


def between_teeth(mesh: Hexahedra, youngs_modulus: float, poisson_ratio: float) -> list[str]:
    """Input of CalculiX for a rim that even tangential forces at 90 and 270 degrees hold.

    The mean displacement of either line along the load is zero, so that rim and pin find the forces. Soft
    springs, which take 1e-4 of these, hold the tilt of the rim until both rows are loaded.
    """
    quarter, middle = mesh.number.shape[2] // 4, mesh.number[:, :, [0, mesh.number.shape[2] // 2]]
    teeth, share = mesh.number[:, -1, [quarter, 3 * quarter]], simpson(mesh.axial)
    lines = [
        *elastic(mesh, youngs_modulus, poisson_ratio),
        "*NSET, NSET=MIRROR", *(f"{n}," for n in middle[middle > 0]), "*BOUNDARY", "MIRROR, 3, 3",
        f"{mesh.number[0, 0, 0]}, 1, 1", "*ELEMENT, TYPE=SPRING1, ELSET=SOFT",
        *(f"{len(mesh.elements) + SOFT + k}, {n}" for k, n in enumerate(teeth[[0, -1]].ravel())),
        "*SPRING, ELSET=SOFT", "2", f"{SOFTNESS}",
    ]  # fmt: skip
    for tooth in teeth.T:
        terms = [f"{n}, 2, {part:.12f}" for n, part in zip(tooth, share, strict=True)]
        first = len(terms) // 2
        terms = [terms[first], *terms[:first], *terms[first + 1 :]]
        lines += ["*EQUATION", str(len(terms))]
        lines += [", ".join(terms[each : each + 4]) for each in range(0, len(terms), 4)]
    return lines


def plastic_cube(node: int, element: int) -> list[str]:
    """A clamped cube beside a linear model, for which CalculiX iterates."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    nodes = node + np.arange(8)
    return [
        "*NODE, NSET=CUBE", *rows(nodes, np.array(corners, dtype=float)),
        "*ELEMENT, TYPE=C3D8, ELSET=CUBE", ", ".join(map(str, [element, *nodes])),
        "*MATERIAL, NAME=PLASTIC", "*ELASTIC", "2e5, 0.3", "*PLASTIC", "1000., 0.", "1100., 0.1",
        "*SOLID SECTION, ELSET=CUBE, MATERIAL=PLASTIC", "*BOUNDARY", "CUBE, 1, 3",
    ]  # fmt: skip


def mean(node: int, share: sparse.coo_array) -> list[str]:
    """Equations that move a node across the axis by the mean of its patch."""
    lines = []
    for direction in (2, 3):
        terms = [f"{node}, {direction}, -1."]
        terms += [f"{n}, {direction}, {w:.12f}" for n, w in zip(share.coords[1], share.data, strict=True)]
        lines += ["*EQUATION", str(len(terms))]
        lines += [", ".join(terms[first : first + 4]) for first in range(0, len(terms), 4)]
    return lines


def found(springs: Springs, dead: NDArray, text: str) -> tuple[NDArray, float]:
    """Slice loads (Z, K) and force on the inner ring [N] from what CalculiX printed at last."""
    if "time  0.1000000E+01" not in text:
        raise RuntimeError("CalculiX did not move the inner ring all the way")
    words = [line.split() for line in text.splitlines()]
    numbers = [word[1:] for word in words if len(word) == 4 and word[0].isdigit()]
    forces, moved = np.array(numbers[-2 * springs.azimuths.size :], dtype=float).reshape(2, -1, 3)
    load = (forces * springs.normal).sum(axis=1).reshape(-1, SLICES)
    shift = np.array([0.0, springs.moved, 0.0]) - moved
    closed = SPRING - np.linalg.norm(SPRING * springs.normal - shift, axis=1).reshape(-1, SLICES) - dead
    force, approach = springs.table
    lawful = [np.interp(closed[:, k], approach[:, k], force[:, 0]) for k in range(SLICES)]
    error = np.abs(load - np.transpose(lawful)).max() / load.max()
    if not error < LAWFUL or load.max() > MOST:
        raise RuntimeError(f"the springs of CalculiX are {error:.1e} of the largest load off their law")
    return load, float(forces[:, 1].sum())
