"""Derivatives of a design while another worker verifies it: rows of both kinds in one batch."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from flexbearing.optimise.worker import BY, with_keys
from flexbearing.studies.plan import Ring, Row, Task
from flexbearing.studies.prepared_study import PreparedStudy
from flexbearing.studies.run import Work


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
        replace(each, identity=each.identity and with_keys(each.identity, keys))
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
