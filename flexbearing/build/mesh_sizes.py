"""Order and sizes of the finite elements of a case."""

import fem
from flexbearing.build.expansion import roller_length
from flexbearing.case.roller import Case

ON_A_SECTION = (5, 1.2, 0.25)  # order, and sizes over the roller length: 0.1 % of the largest compliance
IN_SPACE = (3, 0.6, 0.4)  # 0.5 % of the largest compliance


def mesh_size(case: Case, usual: tuple[int, float, float]) -> fem.MeshSize:
    """Order and sizes of elements: those of the case, else the usual ones in roller lengths."""
    order, size, raceway_size = usual
    accuracy, length = case.accuracy, roller_length(case)
    return fem.MeshSize(
        order=accuracy.element_order or order,
        size=accuracy.mesh_size or size * length,
        raceway_size=accuracy.raceway_mesh_size or raceway_size * length,
    )
