"""What a printed value beside a registered band amounts to: one rule for all pages."""

from evidence.measured.declared import Prediction, Printed

WITHOUT = "prediction without a value"
INSIDE = "inside the band"
BOTH_SIDES = "not decided: the band lies on both sides"
WIDE = "band wider than a factor of 2"


def widths_outside(prediction: Prediction, printed: Printed) -> float:
    """Distance of a printed number or side from the nearer end of the band, over its width; 0 inside [-]."""
    apart = max(prediction.low - printed.high, printed.low - prediction.high, 0.0)
    return apart / prediction.width if prediction.width else float("inf") if apart else 0.0


def verdict(prediction: Prediction, printed: Printed | None) -> str:
    """Inside, outside by how many widths, or not decided; a wide band is stated."""
    wide = [WIDE] if prediction.wide else []
    late = [] if prediction.blind else ["registered after the value"]
    return ", ".join([_place(prediction, printed), *wide, *late])


def _place(prediction: Prediction, printed: Printed | None) -> str:
    if printed is None:
        return WITHOUT
    if outside := widths_outside(prediction, printed):
        return f"outside by {outside:.2g} widths" if prediction.width else "outside a band without width"
    if printed.is_number or (printed.low <= prediction.low and prediction.high <= printed.high):
        return INSIDE
    return BOTH_SIDES
