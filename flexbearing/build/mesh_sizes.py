"""Finite elements of a case: their order and sizes, or those of another case on moved nodes."""

from typing import Any

import fem
from fem.parts.resolution import Shape
from flexbearing.build.expansion import roller_length
from flexbearing.build.ring_parts import Race, part_of
from flexbearing.build.roller_bearing import row_distance
from flexbearing.case.roller import Case

ON_A_SECTION = (5, 1.2, 0.25)  # order, and sizes over the roller length: 0.1 % of the largest compliance
IN_SPACE = (3, 0.6, 0.4)  # 0.5 % of the largest compliance


def mesh_size(case: Case, usual: tuple[int, float, float]) -> fem.MeshSize:
    """Order and sizes of elements: those of the case, else the usual ones in roller lengths."""
    case = case.nodes_of or case
    order, size, raceway_size = usual
    accuracy, length = case.accuracy, roller_length(case)
    return fem.MeshSize(
        order=accuracy.element_order or order,
        size=accuracy.mesh_size or size * length,
        raceway_size=accuracy.raceway_mesh_size or raceway_size * length,
    )


def nodes_of(case: Case, race: Race) -> Shape | None:
    """Part and band of the case whose meshes are taken; None where the case has its own."""
    other = case.nodes_of
    return None if other is None else shape(other, part_of(other, race))


def shape(case: Case, part: Any) -> Shape:
    """A part of a case with the bands that rollers load."""
    return Shape(part=part, length=roller_length(case), row_distance=row_distance(case))
