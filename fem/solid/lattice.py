"""Points spread evenly over elements, and what a displacement makes there."""

from dataclasses import dataclass
from functools import cache
from typing import Any

import ngsolve as ngs
import numpy as np
from numpy.typing import NDArray

from fem.assembly.elasticity import lame_constants
from fem.mesh.moved_nodes import Faces, unmoved
from fem.mesh.solid import MILLIMETRES
from fem.parts.material import Elastic

SQUEEZED = 0.25  # of the mean of its element, volume per point below which a gradient is not trusted
NEAR = 0.05  # of a box, by which curved elements may reach beyond points in them
ROUGH = 2  # intervals of a lattice that gives the size of an element
INSIDE = 1e-7  # of an element's edge, by which points stay away from its faces: some maps have poles there


@cache
def lattice(kind, intervals: int):
    """Points of an element of some kind, without weights, and whether half as many intervals would have them.

    The kind is TRIG, QUAD, TET, PRISM, PYRAMID or HEX of ngsolve.ET; intervals are along each edge.
    """
    i, j, k = np.indices((intervals + 1,) * 3).reshape(3, -1)
    flat = kind in (ngs.TRIG, ngs.QUAD)
    inside = {
        ngs.TRIG: i + j <= intervals, ngs.QUAD: i >= 0, ngs.TET: i + j + k <= intervals, ngs.HEX: i >= 0,
        ngs.PRISM: i + j <= intervals, ngs.PYRAMID: (np.maximum(i, j) <= intervals - k) & (k < intervals),
    }[kind] & ((k == 0) | (not flat))  # fmt: skip
    number = np.stack([i, j, k], axis=1)[inside]
    points = number / intervals
    points = points.mean(axis=0) + (1 - INSIDE) * (points - points.mean(axis=0))
    columns = 2 if flat else 3
    rule = ngs.IntegrationRule([tuple(p[:columns]) for p in points.tolist()], [1.0] * len(points))
    return rule, (number % 2 == 0).all(axis=1)


@dataclass(frozen=True)
class Spread:
    """Points in some elements of a mesh."""

    mapped: NDArray  # points as NGSolve wants them
    key: NDArray  # (n,) number of the element of each point
    even: NDArray  # (n,) bool: those that half as many intervals would have

    def where(self, kept: NDArray) -> "Spread":
        """Only some of the points (n,)."""
        return Spread(self.mapped[kept], self.key[kept], self.even[kept])

    def joined(self, other: "Spread") -> "Spread":
        """These points and others after them."""
        pairs = zip((self.mapped, self.key, self.even), (other.mapped, other.key, other.even), strict=True)
        return Spread(*(np.concatenate(pair) for pair in pairs))


def _unfolded(mesh: ngs.Mesh, points: Spread) -> NDArray:
    """Whether elements are not squeezed to nothing at points (n,), as curved ones are beside fillets."""
    volume = np.abs(ngs.Det(ngs.specialcf.JacobianMatrix(mesh.dim))(points.mapped)[:, 0])
    _, element = np.unique(points.key, return_inverse=True)
    mean = np.bincount(element, volume) / np.bincount(element)
    return volume > SQUEEZED * mean[element]


def spread(
    mesh: ngs.Mesh, body: str, intervals: int, keys: NDArray | None = None, places: NDArray | None = None
) -> Spread:
    """Lattices in the curved elements of a body, or of those with `keys`; intervals are along their edges.

    Stresses are read at `places` (n, dimensions) [mm], too, as far as they lie in these elements.
    """
    points = _lattices(mesh, body, intervals, keys)
    if places is not None and len(places):
        near = np.flatnonzero(_near(mesh, points.mapped, places))
        inside = np.atleast_1d(mesh(*places[near].T))
        held = np.isin(inside["nr"], points.key)
        points = points.joined(Spread(inside[held], inside["nr"][held], near[held] % 2 == 0))
    return points.where(_unfolded(mesh, points))


def located(
    mesh: ngs.Mesh, body: str, places: NDArray, moved: tuple[Faces, Faces] | None = None
) -> tuple[Spread, NDArray]:
    """Places (n, dimensions) [mm] that lie in a body, m of them, and which they are.

    Where nodes were moved, `moved` has their faces before and after: the search for elements knows the mesh
    before.
    """
    before = places if moved is None else MILLIMETRES * unmoved(places / MILLIMETRES, *moved)
    inside = _elements(mesh, before)
    if moved is not None and (found := inside["nr"] >= 0).any():
        there = ngs.CF((ngs.x, ngs.y, ngs.z)[: mesh.dim])(inside[found])
        inside[found] = _elements(mesh, before[found] + places[found] - there)
    held = np.flatnonzero(np.isin(inside["nr"], [e.nr for e in mesh.Materials(body).Elements()]))
    if not held.size:
        return Spread(inside[:0], np.zeros(0, dtype=int), np.zeros(0, dtype=bool)), held
    points = Spread(inside[held], inside["nr"][held], held % 2 == 0)
    around = _lattices(mesh, body, ROUGH, np.unique(points.key))
    good = _unfolded(mesh, points.joined(around))[: held.size]
    return points.where(good), held[good]


def _elements(mesh: ngs.Mesh, places: NDArray) -> NDArray:
    """Places (n, dimensions) [mm] in elements as NGSolve wants them; of number -1 where there is none."""
    one_or_more: Any = places if len(places) else np.zeros((1, mesh.dim))
    return np.atleast_1d(mesh(*one_or_more.T))[: len(places)]


def _lattices(mesh: ngs.Mesh, body: str, intervals: int, keys: NDArray | None) -> Spread:
    """Lattices in the elements of a body, or in some of them."""
    wanted = None if keys is None else set(keys.tolist())
    mapped, key, even = [], [], []
    for element in mesh.Materials(body).Elements():
        if wanted is None or element.nr in wanted:
            rule, halved = lattice(element.type, intervals)
            mapped.append(mesh.GetTrafo(ngs.ElementId(ngs.VOL, element.nr))(rule))
            key.append(np.full(len(halved), element.nr))
            even.append(halved)
    return Spread(np.concatenate(mapped), np.concatenate(key), np.concatenate(even))


def _near(mesh: ngs.Mesh, mapped: NDArray, places: NDArray) -> NDArray:
    """Whether places (n, dimensions) lie in the box of points [mm]: to find elements takes longer."""
    points = ngs.CF((ngs.x, ngs.y, ngs.z)[: mesh.dim])(mapped)
    room = NEAR * np.ptp(points, axis=0)
    return np.all((places > points.min(axis=0) - room) & (places < points.max(axis=0) + room), axis=1)


def hooke(strain: NDArray, elastic: Elastic) -> NDArray:
    """Stress of an isotropic body.

    Parameters
    ----------
    strain : array (..., 6)
        xx, yy, zz, 2 xy, 2 yz, 2 xz [-] in axes at right angles
    elastic : Elastic
        of the body

    Returns
    -------
    array (..., 6)
        [Pa]

    Source
    ------
    Hooke's law; any text on elasticity, e.g. Braess, Finite Elements (2007), ch. VI.
    """
    lame, shear = lame_constants(elastic.youngs_modulus, elastic.poisson_ratio)
    stress = shear * strain
    stress[..., :3] += shear * strain[..., :3] + lame * strain[..., :3].sum(axis=-1, keepdims=True)
    return stress


def hooke_reversed(stress: NDArray, elastic: Elastic) -> NDArray:
    """Strain of an isotropic body that its stress [Pa] makes, without that of heat.

    The stress (..., 6) is xx, yy, zz, xy, yz, xz in axes at right angles, the strain that of `hooke`.

    Source
    ------
    The reverse of `hooke`.
    """
    poisson_ratio = elastic.poisson_ratio
    strain = 2 * (1 + poisson_ratio) * stress
    strain[..., :3] -= (1 + poisson_ratio) * stress[..., :3]
    strain[..., :3] -= poisson_ratio * stress[..., :3].sum(axis=-1, keepdims=True)
    return strain / elastic.youngs_modulus


def strain_of(gradient: NDArray) -> NDArray:
    """Strain (n, 6) of a displacement gradient (n, 9) [m/mm], as `hooke` wants it."""
    g = MILLIMETRES * gradient.reshape(-1, 3, 3)
    shears = (g[:, a, b] + g[:, b, a] for a, b in ((0, 1), (1, 2), (0, 2)))
    return np.stack([g[:, 0, 0], g[:, 1, 1], g[:, 2, 2], *shears], axis=1)
