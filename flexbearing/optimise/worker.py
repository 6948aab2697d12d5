"""What a worker does for derivatives: outputs of designs with their slopes, as rows of a study."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import isnan
from time import perf_counter

from flexbearing.case import BadCase, Head
from flexbearing.derivatives.sensitivities import sensitivities
from flexbearing.derivatives.table import Sensitivities
from flexbearing.families import FAMILIES
from flexbearing.findings.row import INFORMATION, RowFinding
from flexbearing.outputs import UnknownOutput
from flexbearing.printable import one_line
from flexbearing.studies.plan import Ring, Row, Task
from flexbearing.studies.plan.task import BAD_INPUT, CONVERGED
from flexbearing.studies.prepared_study import PreparedStudy, variants_of
from flexbearing.studies.run import Work
from flexbearing.studies.worker import rings_in
from quasidynamic import ImpossiblePart, NotSolved, OutOfRange

BY = " by "  # between the identity of a variant and its keys
NO_SLOPE_BY = "no-derivative"  # code of a key without them
NO_SLOPE = "no derivative"  # status of a design without them: differences take their place


@dataclass(frozen=True)
class SlopeRequest:
    """What is wanted of every design."""

    texts: tuple[str, ...]  # outputs, with units
    keys: tuple[str, ...]  # of the case


def slope_name(text: str, key: str) -> str:
    """What the derivative of an output by a key is called among the numbers of a row: by the key in SI."""
    return f"{text} by {key}"


def slope_rows(task: Task, request: SlopeRequest, cache: str | None = None) -> tuple[Row, ...]:
    """Outputs of variants with their derivatives."""
    read = variants_of(task.base)
    with rings_in(cache):
        return tuple(
            _row(variant.identity, read.known(variant.values, variant.in_si), _of(variant.identity, request))
            for variant in task.variants
        )


def _of(identity: str, request: SlopeRequest) -> SlopeRequest:
    """What is wanted of a variant: slopes by the keys that it names."""
    named = identity.rpartition(BY)[2].split()
    return SlopeRequest(request.texts, tuple(key for key in request.keys if key in named))


def _row(identity: str, case: Head, request: SlopeRequest) -> Row:
    began = perf_counter()
    try:
        found = sensitivities(case, FAMILIES[case.kind], request.texts, request.keys)
    except (BadCase, UnknownOutput) as problem:
        return Row(identity, NO_SLOPE, one_line(problem), perf_counter() - began)
    except (NotSolved, ImpossiblePart, OutOfRange) as problem:
        return Row(identity, BAD_INPUT, one_line(problem), perf_counter() - began)
    without = tuple(RowFinding(NO_SLOPE_BY, INFORMATION, places=(key,), text=one_line(reason))
                    for key, reason in found.left_out)  # fmt: skip
    return Row(identity, CONVERGED, "", perf_counter() - began, _values(found), without)


def _values(found: Sensitivities) -> dict[str, float]:
    """Outputs and slopes by their names; what jumps has none."""
    values: dict[str, float] = {}
    for number, output in enumerate(found.outputs):
        text = f"{output.name} [{output.unit}]"
        values[text] = output.value
        for place, key in enumerate(found.keys):
            values[slope_name(text, key.path)] = float(found.slopes[number, place]) / key.size
    return {name: value for name, value in values.items() if not isnan(value)}


@dataclass(frozen=True)
class Either:
    """Rows of slopes, or of finer models whose rings are condensed by the same worker first."""

    slopes: Work
    values: Work
    rings: tuple[Ring, ...]  # of the finer models

    def __call__(self, task: Task) -> Sequence[Row]:
        """Rows of the variants of a task."""
        if BY in task.variants[0].identity:
            return self.slopes.rows(task)
        for ring in self.rings:
            self.values.condense(ring, here=True)
        return self.values.rows(task)


def for_slopes(prepared: PreparedStudy, groups: Sequence[Sequence[str]]) -> PreparedStudy:
    """The same variants under names of their own, once for each group of keys: a task with its slopes."""
    variants = tuple(
        replace(each, identity=each.identity and f"{each.identity}{BY}{' '.join(keys)}")
        for keys in groups
        for each in prepared.plan.variants
    )
    return replace(prepared, plan=replace(prepared.plan, variants=variants, fewest=len(groups)))


def beside(
    both: PreparedStudy, groups: Sequence[Sequence[str]], slopes: Work, values: Work
) -> tuple[PreparedStudy, Work]:
    """One batch of the slopes of a design and of its values by finer models, and what computes it."""
    plan, count = both.plan, len(both.plan.variants) // 2
    finer = replace(plan, variants=plan.variants[count:])
    named = for_slopes(replace(both, plan=replace(plan, variants=plan.variants[:count])), groups).plan
    # Named rings would be condensed before the first task; those of the finer models go with theirs.
    variants = (*named.variants, *(replace(each, rings=()) for each in finer.variants))
    rings = finer.rings(lambda variant: bool(variant.identity))
    batch = replace(both, plan=replace(named, variants=variants, fewest=len(groups) + 1))
    return batch, replace(slopes, rows=Either(slopes, values, rings))
