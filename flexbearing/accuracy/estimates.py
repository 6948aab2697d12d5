"""What is said of levels that a target led to: records, estimated errors, a target that is not met."""

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from flexbearing.accuracy.ladder import Selection, Unusable, Verdict
from flexbearing.quantities.coupling import BALL_LOAD, ROLLER_LOAD
from quasidynamic.note import Note, danger

ERRORS = {  # of the outputs that a target may be of
    ROLLER_LOAD: "{} of the largest load for the load of any roller",
    BALL_LOAD: "{} of the largest load for the load of any ball",
    "life": "{} for the life",
}


def require_resolved(selection: Selection) -> None:
    """Refuse levels at which a part is rigid only since its own levels have no result.

    Raises `Unusable` saying why they have none.
    """
    for verdict in selection.verdicts:
        if verdict.choice.converging > verdict.level and verdict.excess:
            raise Unusable("; ".join(dict.fromkeys(verdict.unusable.values())))


def largest(selections: Sequence[Selection]) -> dict[str, float]:
    """Largest estimated error of each output over cases at the same levels."""
    errors: dict[str, float] = {}
    for selection in selections:
        for name, error in selection.estimate.items():
            errors[name] = max(error, errors.get(name, 0.0))
    return errors


def attributes(selections: Sequence[Selection]) -> dict[str, Any]:
    """Root attributes of a result: choices of the case with the largest errors, and the largest errors."""
    errors = largest(selections)
    return {
        "choices": {verdict.choice.name: _record(verdict) for verdict in _worst(selections).verdicts},
        "error_estimate": {
            "target": selections[0].target,
            "met": all(selection.met for selection in selections),
            **{name: error if np.isfinite(error) else None for name, error in errors.items()},
        },
    }


def unmet(selections: Sequence[Selection]) -> Iterator[Note]:
    """Danger of a target that is not met: its errors, what makes them, and the keys that hold it back."""
    if all(selection.met for selection in selections):
        return
    selection = _worst(selections)
    errors = " and ".join(
        words.format(percent(selection.estimate[name]))
        for name, words in ERRORS.items()
        if name in selection.estimate
    )
    worst = max(
        selection.verdicts,
        key=lambda verdict: max(verdict.estimate.get(name, 0.0) for name in ERRORS),
    )
    coarse = _too_coarse(selection)
    yield danger(
        "unmet-target",
        f"the target of {percent(selection.target)} is not met: the estimated errors are {errors}, "
        f"most of it from {worst.choice.name} ({worst.choice.levels[worst.level]})"
        + (
            "; levels that the case fixes are too coarse: leave them out, or make them finer"
            if coarse
            else ""
        ),
        {"accuracy.target": "", **coarse},
    )


def _too_coarse(selection: Selection) -> dict[str, str]:
    """Keys that fix choices at levels which leave more than their parts of the target."""
    coarse = (verdict for verdict in selection.verdicts if verdict.excess and _is_fixed(verdict))
    return {f"accuracy.{key}": "" for verdict in coarse for key in verdict.choice.fixed_by}


def _is_fixed(verdict: Verdict) -> bool:
    """Whether the case fixes the level that was taken; a part may be left rigid below it."""
    return bool(verdict.choice.fixed_by) and verdict.level == verdict.choice.highest


def percent(share: float) -> str:
    """A share in two digits."""
    return f"{100 * share:.2g} %"


def _worst(selections: Sequence[Selection]) -> Selection:
    return max(selections, key=lambda each: max(each.estimate.get(name, 0.0) for name in ERRORS))


def _record(verdict: Verdict) -> dict[str, Any]:
    """One choice as JSON can hold it."""
    choice = verdict.choice
    return {
        "level": choice.levels[verdict.level],
        "fixed": _is_fixed(verdict),
        "compared_with": [choice.levels[level] for level in verdict.against],
        "changes": dict(verdict.changes),
        "factor": verdict.factor,
        "allowed": verdict.allowed,
        "unusable": dict(verdict.unusable),
    }
