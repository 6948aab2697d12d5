"""Raceways and rollers that a page of a catalogue lacks, by rules of thumb."""

from collections.abc import Iterator, Mapping, Sequence

# Assumed: Harris' 209 and an NU 210 have rollers of 0.55 (D - d)/2 and pitch diameters of 1.007 (d + D)/2, an
# NU 308 and an NUP 204 0.56 and 1.015.
ROLLER, PITCH = 0.555, 1.01


def raceways(of: Sequence[str], given: Mapping[str, float]) -> Iterator[tuple[str, tuple[str, str]]]:
    """Estimate raceways and rollers that are needed besides those given [m], each with its reason.

    Any two of the inner raceway, the outer raceway and the diameter of the rollers give the third.
    """
    if not of:
        return
    known = [name for name in of if name in given]
    diameter = given.get("diameter", ROLLER * (given["outside"] - given["bore"]) / 2)
    if "diameter" not in given and len(known) < 2:  # of three
        yield "diameter", (f"{1e3 * diameter:.4g} mm", f"rule of thumb, {ROLLER:g} (D - d)/2")
    if not {"inner_raceway", "outer_raceway"} & {*given}:
        raceway = PITCH * (given["outside"] + given["bore"]) / 2 + diameter
        yield "outer_raceway", (f"{1e3 * raceway:.5g} mm", f"rule of thumb, {PITCH:g} (d + D)/2 + D_w")
