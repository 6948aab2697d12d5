"""What can go wrong in the bearing model."""


class ImpossiblePart(ValueError):
    """A part that cannot exist, such as a roller of negative length."""


class OutOfRange(ValueError):
    """A value outside the range in which a formula or a table holds."""


class NotSolved(RuntimeError):
    """No equilibrium was reached; the message has the residual, `outcome` says how the solver ended."""

    def __init__(self, message: str, outcome: str = ""):
        super().__init__(message)
        self.outcome = outcome


def require_positive(name: str, value: float) -> None:
    """Refuse a value that is not a finite number above zero.

    Raises `ImpossiblePart` with the name and the value.
    """
    if not 0.0 < value < float("inf"):
        raise ImpossiblePart(f"{name} = {value!r} must be a finite number above zero")
