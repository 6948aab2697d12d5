"""Predictions and printed values as files, and how far predictions are from what is computed now."""

import json
import math
from collections.abc import Iterable, Iterator
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from evidence.measured.declared import Experiment, Prediction, Printed
from evidence.stored import DOCS

EVERY = 4  # of the rows of a prediction one is computed again
SHARE_MOVES = 0.1  # of the variance, by which a Sobol index may move


def prediction_file(experiment: Experiment) -> Path:
    """Where the prediction is registered."""
    return DOCS / "predictions" / f"{experiment.name}.json"


def value_file(experiment: Experiment) -> Path:
    """Where the printed value is, once it is stored."""
    return DOCS / "values" / f"{experiment.name}.json"


def rows_file(experiment: Experiment) -> Path:
    """Where the rows are that a prediction was made of."""
    return DOCS / "rows" / f"{experiment.name}.json"


def register(experiment: Experiment, prediction: Prediction) -> None:
    """Store a prediction."""
    text = json.dumps(asdict(prediction), indent=1, ensure_ascii=False)
    prediction_file(experiment).write_text(f"{text}\n")


def write_rows(experiment: Experiment, found: NDArray) -> None:
    """Store the rows of a prediction, null where one was not solved."""
    text = json.dumps([value if math.isfinite(value) else None for value in found.tolist()])
    rows_file(experiment).write_text(f"{text}\n")


def rows_of(experiment: Experiment) -> NDArray:
    """The stored rows of a prediction, NaN where one was not solved."""
    return np.array(json.loads(rows_file(experiment).read_text()), float)


def moved_rows(experiment: Experiment, found: NDArray) -> list[str]:
    """One line for each of the rows computed again that moved by more than ends of the band may."""
    before = rows_of(experiment)[::EVERY]
    may = _allowed(experiment, registered(experiment).width, before)
    return [
        f"{experiment.name}: row {EVERY * row} was {old:.9g}, is {new:.9g}, may move by {limit:.2g}"
        for row, (old, new, limit) in enumerate(zip(before, found, may, strict=True))
        if not (abs(new - old) <= limit or (math.isnan(old) and math.isnan(new)))
    ]


def _allowed(experiment: Experiment, width: float, value: Any) -> Any:
    """By how much a number of a band may move."""
    return experiment.moves * width + 1e-3 * abs(value)


def registered(experiment: Experiment) -> Prediction:
    """The stored prediction."""
    return Prediction(**json.loads(prediction_file(experiment).read_text()))


def printed(experiment: Experiment) -> Printed | None:
    """The printed value, where one is stored; an end that is null is infinite."""
    path = value_file(experiment)
    if not path.exists():
        return None
    value = json.loads(path.read_text())
    low, high = value.pop("low"), value.pop("high")
    return Printed(**value, low=-math.inf if low is None else low, high=math.inf if high is None else high)


def changed(experiment: Experiment, before: Prediction, now: Prediction) -> list[str]:
    """One line for every number of a registered prediction that the program does not give any more."""
    if before.digest != now.digest:
        return [f"{experiment.name}: case or inputs differ from the registered ones: register it again"]
    return [
        f"{experiment.name}: {name} was {old:.9g}, is {new:.9g}, may move by {may:.2g}"
        for name, old, new, may in _numbers(experiment, before, now)
        if not abs(new - old) <= may
    ]


def _numbers(
    experiment: Experiment, before: Prediction, now: Prediction
) -> Iterator[tuple[str, float, float, float]]:
    """Name, registered number, new one, and how far they may be apart."""
    for name in ("low", "median", "high"):
        old = getattr(before, name)
        yield name, old, getattr(now, name), _allowed(experiment, before.width, old)
    for name, share in before.shares.items():
        if math.isfinite(share):
            yield f"share of {name}", share, now.shares[name], SHARE_MOVES


def all_registered(experiments: Iterable[Experiment]) -> dict[str, tuple[Prediction, Printed | None]]:
    """Predictions that are registered and the printed values beside them, by name."""
    return {
        each.name: (registered(each), printed(each)) for each in experiments if prediction_file(each).exists()
    }
