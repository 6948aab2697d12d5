"""The sections [coupling] and [accuracy]."""

from typing import Literal

from flexbearing.case.quantity import Length, Section, key


class Coupling(Section):
    """How bearing and rings come to agree."""

    method: Literal["newton", "relaxed"] = key(
        "newton: both in one system; relaxed: one after the other with a fraction of the change", "newton"
    )
    tolerance: float = key(
        "largest load change over the largest load at convergence; newton also ends when the "
        "unbalanced force is below 1e-10 of the load",
        1e-8,
        gt=0,
        lt=1,
    )
    max_iterations: int = key("limit of the iterations", 200, ge=1)
    relaxation: float = key('fraction of the change taken over, method = "relaxed"', 0.1, gt=0, le=1)


class Accuracy(Section):
    """How finely everything is resolved."""

    slices: int = key("slices of a roller", 20, ge=2, le=1000)
    axial_shapes: int = key(
        "Legendre shapes along a roller that carry loads to the rings and deviations back", 3, ge=2, le=6
    )
    element_order: int = key("polynomial order of the finite elements", 3, ge=1, le=6)
    mesh_size: Length = key("largest size of the elements", "3 mm", example="3 mm", gt=0)
    raceway_mesh_size: Length = key("largest size of the elements on a raceway", "2 mm", example="2 mm", gt=0)
    patch_width: Length = key(
        "standard deviation of the load patch along the arc; its own half-space indentation is taken out",
        "0.5 mm",
        example="0.5 mm",
        gt=0,
    )
    threads: int = key("threads of the finite element part", 2, ge=1, le=64)
