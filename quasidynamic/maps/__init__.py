"""All equilibria of a bearing on a grid of operating points, and where they end in folds."""

from quasidynamic.maps.folds import MapFolds, folds
from quasidynamic.maps.points import GridPoints
from quasidynamic.maps.solve import SolvedGrid, solve

__all__ = ["GridPoints", "MapFolds", "SolvedGrid", "folds", "solve"]
