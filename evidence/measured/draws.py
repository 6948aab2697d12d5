"""Bearings drawn from the inputs that a source does not give."""

import hashlib
import json
import tempfile
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from datetime import date
from functools import cache, cached_property

import numpy as np
from numpy.typing import NDArray

import flexbearing
from evidence.measured.declared import Experiment, Prediction
from evidence.stored import ROOT
from flexbearing.sampling.distribution import quantile
from flexbearing.sampling.indices import sobol_indices
from flexbearing.sampling.points import Design

SEED = 42
ENDS = (0.05, 0.5, 0.95)


@dataclass(frozen=True, eq=False)
class Draws:
    """Rows of the inputs of an experiment, all or some of them."""

    experiment: Experiment
    every: int = 1  # the first of so many rows is drawn

    @property
    def design(self) -> Design:
        """How the rows are spread."""
        return Design("sobol_indices", self.experiment.count, SEED)

    @cached_property
    def values(self) -> dict[str, NDArray]:
        """Inputs (rows) in their units, by name."""
        inputs = self.experiment.inputs
        shares = self.design.points([1] * len(inputs))[:: self.every]
        return {each.name: each.at(column) for each, column in zip(inputs, shares.T, strict=True)}

    def __len__(self) -> int:
        return len(range(0, self.design.rows(len(self.experiment.inputs)), self.every))

    def texts(self, name: str) -> list[object]:
        """An input (rows) in the words of a case file."""
        unit = next(each.unit for each in self.experiment.inputs if each.name == name)
        values = self.values[name].tolist()
        return [f"{value!r} {unit}" for value in values] if unit else values

    def study(
        self,
        outputs: Sequence[str],
        settings: Mapping[str, object] | None = None,
        keys: Mapping[str, Sequence[object]] | None = None,
    ) -> list[NDArray]:
        """Outputs (rows) of the drawn bearings, NaN of those not solved; those of rollers are (rows, Z).

        Inputs with the name of a key are drawn; `settings` hold for all rows, `keys` row by row.
        """
        drawn = {each.name: self.texts(each.name) for each in self.experiment.inputs if "." in each.name}
        source = {
            "case": str(ROOT / self.experiment.case_file),
            "name": "drawn",
            "set": {**self.experiment.settings, **(settings or {})},
            "over": {"zip": True, **drawn, **(keys or {})},
            "collect": {f"output_{number}": text for number, text in enumerate(outputs)},
        }
        return _computed(json.dumps(source))


@cache
def _computed(source: str) -> list[NDArray]:
    """Outputs of a study, one of several pages with the same bearings."""
    study = json.loads(source)
    with tempfile.TemporaryDirectory() as folder:
        table = flexbearing.study(study, folder, jobs=1)
    return [np.array(table[name].values, float) for name in study["collect"]]


def digest(experiment: Experiment) -> str:
    """Twelve characters that name case, settings, inputs and rows of an experiment."""
    case = tomllib.loads((ROOT / experiment.case_file).read_text()) if experiment.case_file else {}
    inputs = [{**asdict(each), "reason": ""} for each in experiment.inputs]
    parts = [case, experiment.settings, inputs, experiment.count, SEED]
    return hashlib.sha256(json.dumps(parts, sort_keys=True, default=str).encode()).hexdigest()[:12]


def computed(experiment: Experiment, every: int = 1) -> NDArray:
    """What is predicted of all rows that are drawn, or of some; NaN of those not solved."""
    return np.asarray(experiment.predict(Draws(experiment, every)), float)


def predicted(experiment: Experiment, found: NDArray, *, blind: bool) -> Prediction:
    """The band of an experiment by what was found for all rows that are drawn."""
    rows = found[Draws(experiment).design.independent(len(found))]
    known = rows[np.isfinite(rows)]
    low, median, high = (quantile(known, len(rows) - len(known), end).value for end in ENDS)
    indices = sobol_indices(found.reshape(-1, len(experiment.inputs) + 2), SEED)
    return Prediction(
        digest=digest(experiment),
        version=flexbearing.__version__,
        date=date.today().isoformat(),
        blind=blind,
        rows=len(rows),
        unsolved=len(rows) - len(known),
        low=low,
        median=median,
        high=high,
        shares={
            each.name: float(share) for each, share in zip(experiment.inputs, indices.total, strict=True)
        },
    )
