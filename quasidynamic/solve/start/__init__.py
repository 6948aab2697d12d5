"""Where solvers begin."""

from quasidynamic.solve.start.frictionless import static_unknowns
from quasidynamic.solve.start.initial_drifts import static_start
from quasidynamic.solve.start.lumped import LumpedRollers
from quasidynamic.solve.start.slipping import RESTARTS, slipping_start

__all__ = ["RESTARTS", "LumpedRollers", "slipping_start", "static_start", "static_unknowns"]
