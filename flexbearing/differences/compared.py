"""What two results have different."""

from collections.abc import Iterator, Mapping
from dataclasses import asdict, dataclass
from math import isfinite, isnan
from typing import Any

import numpy as np

from flexbearing.case.declarations import by_path
from flexbearing.case.differing import differing
from flexbearing.findings import stored
from flexbearing.outputs import requested
from flexbearing.outputs.names import BLOCKS, RequestedOutput, outputs
from flexbearing.results import BadResult, Result
from flexbearing.studies.table.keys import in_table

ROUNDING = 1e-9  # of an output without estimate: what another order of sums changes


@dataclass(frozen=True)
class Setting:
    """A key of the cases."""

    key: str
    unit: str  # empty for texts and plain numbers
    one: Any  # None where a case does not have the key
    other: Any


@dataclass(frozen=True)
class Differing:
    """An output of both results, or of one of them."""

    name: str
    unit: str
    one: float  # NaN where a result does not have it
    other: float
    error: float  # estimated numerical errors of both together; NaN where either has none

    @property
    def change(self) -> float:
        """The second number less the first one."""
        return self.other - self.one

    @property
    def explained(self) -> bool:
        """Whether the numbers agree within their errors, without estimates but for rounding."""
        if isnan(self.one) and isnan(self.other):
            return True
        if not (isfinite(self.one) and isfinite(self.other)):
            return self.one == self.other
        rounding = ROUNDING * max(abs(self.one), abs(self.other))
        return abs(self.change) <= (rounding if isnan(self.error) else max(self.error, rounding))


@dataclass(frozen=True)
class Verdict:
    """A finding that the results do not share."""

    code: str
    grade: str
    place: str
    source: str  # of the limit
    one: str  # verdict; empty where a result has none
    other: str


@dataclass(frozen=True)
class Compared:
    """Two results of one kind of bearing."""

    one: str  # place of the first
    other: str
    settings: tuple[Setting, ...]  # keys that differ
    outputs: tuple[Differing, ...]  # that differ by more than their estimated errors, or have none
    within_error: tuple[Differing, ...]  # that differ by less than their estimated errors
    findings: tuple[Verdict, ...]  # with different verdicts
    without_estimate: tuple[str, ...]  # names of the outputs compared whose error nothing estimates

    def as_json(self) -> dict[str, Any]:
        """The same as JSON can hold it; null stands for numbers that are not finite."""
        return _plain(asdict(self))


def compared(one: Result, other: Result) -> Compared:
    """Compare two results.

    Raises `BadResult` if the kinds of bearing differ.
    """
    if one.kind != other.kind:
        raise BadResult(
            f"{one.place} is of a {one.kind}, {other.place} of a {other.kind}: there is nothing to compare."
        )
    both = [_output(name, one, other) for name in _names(one, other)]
    differ = [each for each in both if each.one != each.other and not (isnan(each.one) and isnan(each.other))]
    return Compared(
        one.place,
        other.place,
        tuple(_settings(one, other)),
        tuple(each for each in differ if not each.explained),
        tuple(each for each in differ if each.explained and not isnan(each.error)),
        tuple(_verdicts(one, other)),
        tuple(
            each.name for each in both if isnan(each.error) and not (isnan(each.one) and isnan(each.other))
        ),
    )


def _settings(one: Result, other: Result) -> Iterator[Setting]:
    """Keys that differ, in the order of the cases."""
    known = by_path(one.family.case())
    for key, values in differing(one.attributes["case_si"], other.attributes["case_si"]).items():
        kind = known[key].kind if key in known else None
        if kind is None:
            yield Setting(key, "", *values)
            continue
        name, converted = in_table(key, kind)
        yield Setting(key, name, *(_converted(value, converted) for value in values))


def _verdicts(one: Result, other: Result) -> Iterator[Verdict]:
    """Findings whose verdicts differ, in the order of the results."""
    both = [
        {(each.code, each.grade, each.place, each.source): each.verdict for each in stored(result.attributes)}
        for result in (one, other)
    ]
    for key in dict.fromkeys((*both[0], *both[1])):
        verdicts = [found.get(key, "") for found in both]
        if verdicts[0] != verdicts[1]:
            yield Verdict(*key, *verdicts)


def _converted(value: Any, converted: Any) -> Any:
    if isinstance(value, list | tuple):
        return [_converted(each, converted) for each in value]
    return value if value is None or isinstance(value, str) else converted(value)


def _blocks(result: Result) -> dict[str, Mapping[str, Any]]:
    return {"rigid": result.rigid, "flexible": result.flexible}


def _names(one: Result, other: Result) -> list[str]:
    """Outputs of both blocks, or of one where no ring is flexible; those of the main one without its name."""
    scalars = [output.name for output in outputs(one.family.layout())]
    apart = any(result.rigid and result.flexible and _elastic(result) for result in (one, other))
    return [*scalars, *(f"{BLOCKS[-1]}.{name}" for name in scalars if apart)]


def _elastic(result: Result) -> bool:
    """Whether the blocks of a result are two states."""
    return any(
        not np.array_equal(result.rigid[name], result.flexible[name], equal_nan=True) for name in result.rigid
    )


def _output(name: str, one: Result, other: Result) -> Differing:
    output = requested(one.family.layout(), name)
    first, second = (output.number(_blocks(each)) for each in (one, other))
    error = _error(output, one, first) + _error(output, other, second)
    return Differing(name, output.unit, first, second, error)


def _error(output: RequestedOutput, result: Result, number: float) -> float:
    """Estimated error of an output: with a target, else by slices, of a life by axial shapes too."""
    estimates = result.attributes.get("error_estimate") or result.attributes.get("slice_error") or {}
    error = output.error(estimates, number)
    by_slices = output.chosen(_blocks(result)).get(f"{output.output.declared.error}_error")
    if isnan(error) and by_slices is not None and output.output.declared.error:
        return float(by_slices) * abs(number)
    return error


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(each) for key, each in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(each) for each in value]
    return None if isinstance(value, float) and not isfinite(value) else value
