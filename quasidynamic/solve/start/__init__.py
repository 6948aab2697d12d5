"""Where solvers begin."""

from quasidynamic.solve.start.frictionless import static_unknowns
from quasidynamic.solve.start.initial_drifts import RESTARTS, slipping_start, static_start
from quasidynamic.solve.start.lumped import LumpedRollers

__all__ = ["RESTARTS", "LumpedRollers", "slipping_start", "static_start", "static_unknowns"]
