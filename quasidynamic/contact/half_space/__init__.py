"""Elastic half-spaces on a regular grid: influence numbers of cells and displacements by convolution.

Closed formulas and sums; which tractions act, normal or tangential, is decided elsewhere.
"""

from quasidynamic.contact.half_space.convolution import Convolution, convolution
from quasidynamic.contact.half_space.influence import (
    CellGrid,
    ElasticPair,
    X,
    Y,
    Z,
    elastic_pair,
    grid_over,
    influence_number,
)

__all__ = [
    "CellGrid",
    "Convolution",
    "ElasticPair",
    "X",
    "Y",
    "Z",
    "convolution",
    "elastic_pair",
    "grid_over",
    "influence_number",
]
