"""What a worker does with a task: every variant is computed as a single run would."""

from collections.abc import Mapping
from functools import lru_cache
from time import perf_counter
from typing import Any

from flexbearing.api import compute
from flexbearing.case import BadCase, Head
from flexbearing.case.excerpt import excerpt
from flexbearing.case.variants import Variants
from flexbearing.families import FAMILIES
from flexbearing.studies.plan import Row, Task, Variant
from flexbearing.studies.plan.task import BAD_INPUT, CONVERGED, ERROR, Base
from flexbearing.studies.table.collected import numbers

LONGEST = 500  # characters of a message


def rows(task: Task, texts: tuple[str, ...]) -> tuple[Row, ...]:
    """Compute the variants of a task.

    Parameters
    ----------
    task : Task
        variants between the same rings
    texts : tuple of str
        outputs that are wanted, with units

    Returns
    -------
    tuple of Row
        one for each variant, also where it failed
    """
    return tuple(_row(variant, task.base, texts) for variant in task.variants)


def _row(variant: Variant, base: Base, texts: tuple[str, ...]) -> Row:
    began, values, status = perf_counter(), {}, ERROR
    try:
        status, message, values = _computed(_variants(base).case(variant.values), texts)
    except BadCase as problem:
        status, message = BAD_INPUT, str(problem)
    except MemoryError:
        message = "out of memory"
    except Exception as problem:  # of one variant, which must not end the others
        message = f"{type(problem).__name__}: {problem}"
    words = excerpt("; ".join(message.splitlines()), LONGEST)
    return Row(variant.identity, status, words, perf_counter() - began, values)


def _computed(case: Head, texts: tuple[str, ...]) -> tuple[str, str, dict[str, float]]:
    """Status, message and numbers; of a run that did not converge those between rigid raceways alone."""
    result = compute(case)
    status = result.attributes["status"]
    blocks: Mapping[str, Any] = {"rigid": result.rigid, "flexible": result.flexible}
    if status == CONVERGED:
        dangers = "; ".join(f"danger: {note['text']}" for note in result.dangers)
        return status, dangers, numbers(blocks, texts, case.kind, FAMILIES)
    of_rigid = tuple(text for text in texts if text.startswith("rigid."))
    return status, result.attributes["message"], numbers(blocks, of_rigid, case.kind, FAMILIES)


@lru_cache(maxsize=4)
def _variants(base: Base) -> Variants:
    return Variants(base.path, base.text, base.keys, FAMILIES)
