"""What finite elements fail at, known without loading them."""


class NotSolved(RuntimeError):
    """The system has no trustworthy solution; the message says how large the residual is."""


class TooFewHarmonics(NotSolved):
    """More harmonics, on finer elements, would be needed; the message says how much lies beyond them."""
