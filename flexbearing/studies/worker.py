"""What a worker does with a task: variants side by side, with the answers of single runs."""

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import lru_cache
from math import isnan
from time import perf_counter
from typing import Any

from flexbearing.api import compute
from flexbearing.build.ring_parts import Race
from flexbearing.cache.store import VARIABLE
from flexbearing.case import BadCase, Head
from flexbearing.case.excerpt import excerpt
from flexbearing.case.roller import Case
from flexbearing.case.variants import Variants
from flexbearing.coupling import PartnerFailed
from flexbearing.families import FAMILIES
from flexbearing.program.threads import linear_algebra_alone
from flexbearing.progress import Logged
from flexbearing.runs.many import Answer, answers
from flexbearing.studies.plan import Ring, Row, Task, Variant
from flexbearing.studies.plan.task import BAD_INPUT, CONVERGED, ERROR, Base
from flexbearing.studies.table.collected import numbers

LONGEST = 500  # characters of a message


def rows(
    task: Task, texts: tuple[str, ...], cache: str | None = None, *, search: bool = False
) -> tuple[Row, ...]:
    """Compute the variants of a task.

    Parameters
    ----------
    task : Task
        variants between the same rings
    texts : tuple of str
        outputs that are wanted, with units
    cache : str, optional
        folder of condensed rings, where it is not that of the user
    search : bool
        whether other equilibria are searched where they are likely

    Returns
    -------
    tuple of Row
        one for each variant, also where it failed
    """
    with _rings_in(cache):
        return tuple(_rows(task, texts, search))


def condense(ring: Ring, cache: str | None = None) -> None:
    """Condense a ring into the cache; whatever goes wrong is told by the variants that have it.

    Parameters
    ----------
    ring : Ring
        of a variant
    cache : str, optional
        as for `rows`
    """
    case = _variants(ring.base).case(ring.variant.values)
    if not isinstance(case, Case) or case.accuracy.target is not None:
        return  # not kept, or chosen with the loads
    from flexbearing.build.roller_bearing import bearing
    from flexbearing.rings.condensed import raceway
    from flexbearing.rings.fits import is_in_fit

    race: Race = "inner" if ring.race == "inner" else "outer"
    if not is_in_fit(case, race):
        with _rings_in(cache), suppress(BadCase, PartnerFailed), linear_algebra_alone():
            raceway(case, race, bearing(case).bearing.azimuths, Logged())


@contextmanager
def _rings_in(folder: str | None) -> Iterator[None]:
    """Let condensed rings be kept in a folder of the study, where the user keeps none."""
    before = os.environ.get(VARIABLE)
    if folder is not None:
        os.environ[VARIABLE] = folder
    try:
        yield
    finally:
        if folder is not None:
            os.environ.pop(VARIABLE)
            os.environ |= {} if before is None else {VARIABLE: before}


def _rows(task: Task, texts: tuple[str, ...], search: bool) -> Iterator[Row]:
    """Rows of roller bearings from one batch, those of other kinds one by one."""
    began, read = perf_counter(), _variants(task.base)
    cases = [
        read.case(variant.values) for variant in task.variants
    ]  # none of them is bad: the plan read them
    rollers = [case for case in cases if isinstance(case, Case)]
    if len(rollers) == len(cases):
        found = answers(rollers, texts, lambda place: _alone(cases[place], texts), search=search)
        seconds = (perf_counter() - began) / len(cases)
        columns = {text: numbers.tolist() for text, numbers in found.numbers.items()}
        for place, variant in enumerate(task.variants):
            values = {text: column[place] for text, column in columns.items()}
            yield _row(variant, Answer(found.statuses[place], found.messages[place], values), seconds)
        return
    for case, variant in zip(cases, task.variants, strict=True):
        began = perf_counter()
        answer = _alone(case, texts)
        yield _row(variant, answer, perf_counter() - began)


def _row(variant: Variant, answer: Answer, seconds: float) -> Row:
    words = excerpt("; ".join(answer.message.splitlines()), LONGEST)
    values = {text: number for text, number in answer.numbers.items() if not isnan(number)}
    return Row(variant.identity, answer.status, words, seconds, values)


def _alone(case: Head, texts: tuple[str, ...]) -> Answer:
    """The answer of a case from a run of its own; that between rigid raceways where it does not converge."""
    try:
        result = compute(case)
    except BadCase as problem:
        return Answer(BAD_INPUT, str(problem), {})
    except MemoryError:
        return Answer(ERROR, "out of memory", {})
    except Exception as problem:  # of one variant, which must not end the others
        return Answer(ERROR, f"{type(problem).__name__}: {problem}", {})
    status = result.attributes["status"]
    blocks: Mapping[str, Any] = {"rigid": result.rigid, "flexible": result.flexible}
    if status == CONVERGED:
        dangers = "; ".join(f"danger: {note['text']}" for note in result.dangers)
        return Answer(status, dangers, numbers(blocks, texts, case.kind, FAMILIES))
    of_rigid = tuple(text for text in texts if text.startswith("rigid."))
    return Answer(status, result.attributes["message"], numbers(blocks, of_rigid, case.kind, FAMILIES))


@lru_cache(maxsize=4)
def _variants(base: Base) -> Variants:
    return Variants(base.path, base.text, base.keys, FAMILIES)
