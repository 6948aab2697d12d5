"""Codes of notes that say where a peak pressure is not known."""

PRESSED_ENDS = frozenset({"pressed-end", "sharp-roller-end"})  # slices leave out the rise of an end
PEAK_AT_ENDS = PRESSED_ENDS | {"sliced-peak"}  # slices do not have the peak
