"""How many rollers fit round a bearing with a cage."""

from math import asin, ceil, floor, pi

# Rule of thumb, assumed: Harris' 209 has 1.45, the bearing of Mao, Wang and Zhang 1.46.
SPACING = (1.2, 1.6)  # distance of roller centres over the roller diameter, with a cage
TAPERED_SPACING = (1.08, 1.18)  # the same of tapered rollers, which fill 0.85 to 0.92 of the pitch circle


def plausible_numbers(ratio: float, spacing: tuple[float, float] = SPACING) -> list[int]:
    """Numbers of rollers whose distance leaves room for a cage and wastes none."""
    closest, widest = (pi / asin(min(distance * ratio, 1.0)) for distance in spacing)
    return [*range(ceil(widest), floor(closest) + 1)] or [floor(closest)]
