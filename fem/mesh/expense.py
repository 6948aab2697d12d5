"""About how many unknowns a mesh will have, known before it is made."""

import logging

from fem.errors import NotSolved
from fem.parts.material import in_mm
from fem.parts.rings import MeshSize

LARGEST = {2: 300_000, 3: 3_000_000}  # unknowns on an axial section, for every harmonic; of a solid
SIMPLICES = {2: 2.3, 3: 8.5}  # equilateral ones of edge one in a unit of area or volume
PER_SIMPLEX = {2: 3 / 2, 3: 3 / 6}  # three displacements times order^dimension of them
HELD = {2: 4.6, 3: 7.0}  # elements beside a loaded band of edge one, with those that grow away from it

_log = logging.getLogger(__name__)


def require_affordable(
    dimension: int, bodies: list[tuple[float, float]], loaded: float, mesh_size: MeshSize
) -> float:
    """Refuse a mesh of far more unknowns than a computer can solve for; about how many there will be [-].

    Bodies are area and perimeter [m^2, m] in 2 dimensions, volume and surface [m^3, m^2] in 3; `loaded` is
    length [m] or area [m^2] of the loaded band. Layers at corners are not counted, which few elements make
    many.
    Raises `NotSolved` when there are too many.
    """
    elements = HELD[dimension] * loaded / mesh_size.raceway_size ** (dimension - 1)
    for content, surface in bodies:
        size = min(mesh_size.size, 2 * content / surface)  # no larger than a thin wall
        elements += SIMPLICES[dimension] * content / size**dimension
    unknowns = PER_SIMPLEX[dimension] * mesh_size.order**dimension * elements
    where = {2: "on the axial section", 3: "in the solid"}[dimension]
    if unknowns > LARGEST[dimension]:
        raise NotSolved(
            f"elements of {in_mm(mesh_size.size)}, on the raceway of {in_mm(mesh_size.raceway_size)}, and of "
            f"order {mesh_size.order} make about {unknowns:.2g} unknowns {where}; allowed are "
            f"{LARGEST[dimension]:.2g}, by larger elements or a lower order"
        )
    _log.debug("about %d unknowns %s", unknowns, where)
    return unknowns


def polygon(corners: list[tuple[float, float]]) -> tuple[float, float]:
    """Area and perimeter of a polygon of any unit."""
    pairs = list(zip(corners, corners[1:] + corners[:1], strict=True))
    area = abs(sum(x * s - r * y for (x, r), (y, s) in pairs)) / 2
    return area, sum(((y - x) ** 2 + (s - r) ** 2) ** 0.5 for (x, r), (y, s) in pairs)
