"""How the solve of a case can end."""

from enum import StrEnum


class SolverOutcome(StrEnum):
    """How the solve of a case ended."""

    RUNNING = ""  # no outcome yet
    CONVERGED = "converged"
    UNDETERMINED = "undetermined"  # nothing holds the ring: neither load nor contact
    STALLED = "stalled"  # no step lowers the residual
    LIMIT = "iteration limit"
    WORK = "work limit"  # every way together took as many evaluations as a case may
    NOT_FINITE = "not finite"
