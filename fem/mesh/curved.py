"""Curved meshes whose elements are all the right way round.

An element with all its corners on one round face is thin before it is curved and may be turned inside out
by it; a finer mesh has others. Beside a fillet, elements that are as large as it is always fold a little:
they touch it and the faces that it is tangent to. Flatter ones would cost more accuracy than that.
"""

import logging
from collections.abc import Callable
from dataclasses import replace

import ngsolve as ngs
import numpy as np

from fem.errors import NotSolved
from fem.parts.material import in_mm
from fem.parts.rings import MeshSize

LEAST = 0.02  # of the volume of a straight element that is left where it does not count as folded
FOLDED = 1e-3  # share of a volume that may fold beside fillets; that changes compliances by 1e-3 at most
FINER = (1.0, 0.85, 0.7, 0.5, 0.35, 0.25, 0.18, 0.125)  # sizes over those requested, one after the other
AT_ANY_COST = 0.7  # of the sizes requested: 3 times the elements
MOST = 10_000  # elements of sizes below that: seconds for half a pitch of a cage

_log = logging.getLogger(__name__)


def curved(generate: Callable[[MeshSize], ngs.Mesh], mesh_size: MeshSize, allowed: float = 0.0) -> ngs.Mesh:
    """Curve a mesh; where that turns elements inside out, take a finer one.

    An edge of length :math:`h` is up to :math:`h^2 / 8 R` away from the face of radius :math:`R`: walls
    thinner than that need shorter ones.

    `generate` makes the straight mesh of element sizes; a share `allowed` of the volume may fold [-].
    Raises `NotSolved` if elements are inside out on the finest mesh of at most `MOST` elements, too.
    """
    folded, elements, tried = 0.0, 0, 1.0
    for share in FINER:
        if share < AT_ANY_COST and elements * (tried / share) ** 3 > MOST:
            break
        tried = share
        mesh = generate(
            replace(mesh_size, size=share * mesh_size.size, raceway_size=share * mesh_size.raceway_size)
        )
        elements = mesh.ne
        folded = _curve(mesh, mesh_size.order)
        _log.debug("%d elements of order %d, %.2g of the volume folded", mesh.ne, mesh_size.order, folded)
        if folded <= allowed:
            return mesh
    raise NotSolved(
        f"elements of {in_mm(mesh_size.size)}, on the raceway of {in_mm(mesh_size.raceway_size)}, and of "
        f"order {mesh_size.order} are impossible: curved edges turn {folded:.2g} of the volume inside "
        f"out, also on elements {tried:g} times as large; allowed is {allowed:g}, by other sizes or a "
        "lower order"
    )


def _curve(mesh: ngs.Mesh, order: int) -> float:
    """Curve a mesh, and return the share of its volume that is folded by that.

    Prisms of refined layers have negative volumes from the start, which does no harm.
    """
    kinds = (ngs.TET, ngs.PYRAMID, ngs.PRISM, ngs.HEX)
    rules = {kind: ngs.IntegrationRule(kind, 2 * order) for kind in kinds}
    ratio = ngs.Det(ngs.specialcf.JacobianMatrix(3))
    straight = ratio(mesh.MapToAllElements(rules, ngs.VOL))[:, 0]
    mesh.Curve(order)
    change = ratio(mesh.MapToAllElements(rules, ngs.VOL))[:, 0] / straight
    return float(np.sum(np.abs(straight), where=change <= LEAST) / np.sum(np.abs(straight)))
