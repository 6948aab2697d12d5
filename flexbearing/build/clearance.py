"""The operating clearance of a case: stated, or computed from its fits."""

from typing import TYPE_CHECKING, Any

from flexbearing.case.roller import Case
from quasidynamic.note import Note, information

if TYPE_CHECKING:
    from flexbearing.build.fits import OperatingClearance


def operating(case: Case) -> float:
    """Operating diametral clearance [m], negative is a preload."""
    chain = computed(case)
    return case.bearing.stated_clearance if chain is None else chain.clearance


def computed(case: Case) -> "OperatingClearance | None":
    """Steps from the cold to the operating clearance; None when the case states the latter."""
    if case.bearing.mounting is None:
        return None
    from flexbearing.build.fits import from_fits

    return from_fits(case)


def record(case: Case) -> dict[str, Any]:
    """The clearance and how it came about, for the result file; lengths are diametral."""
    chain = computed(case)
    if chain is None:
        return {"operating_m": operating(case), "steps": []}
    return {
        "operating_m": chain.clearance,
        "cold_m": chain.cold,
        "steps": [
            {
                "name": step.name,
                "change_m": step.change,
                "clearance_m": step.clearance,
                "explanation": step.explanation,
            }
            for step in chain.steps
        ],
        "shaft_fit": chain.shaft_seat.words,
        "housing_fit": chain.housing_seat.words if chain.housing_seat else "free ring, no housing",
        "verdict": chain.verdict,
    }


def notes(case: Case) -> tuple[Note, ...]:
    """Say so when the bearing runs under preload."""
    clearance = operating(case)
    if clearance >= 0.0:
        return ()
    return (
        information(
            "preload",
            "clearance: the bearing is preloaded, its rollers interfere by "
            f"{-clearance * 1e6:.3f} um diametral",
        ),
    )
