"""Where solvers begin."""

from quasidynamic.start.drifts import static_start
from quasidynamic.start.lumped import LumpedRollers
from quasidynamic.start.resting import static_unknowns
from quasidynamic.start.slipping import RESTARTS, slipping_start

__all__ = ["RESTARTS", "LumpedRollers", "slipping_start", "static_start", "static_unknowns"]
