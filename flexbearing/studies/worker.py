"""What a worker does with a task: every variant is computed as a single run would."""

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import lru_cache
from time import perf_counter
from typing import Any

from threadpoolctl import threadpool_limits

from flexbearing.api import compute
from flexbearing.build.ring_parts import Race
from flexbearing.cache.store import VARIABLE
from flexbearing.case import BadCase, Head
from flexbearing.case.excerpt import excerpt
from flexbearing.case.roller import Case
from flexbearing.case.variants import Variants
from flexbearing.coupling import PartnerFailed
from flexbearing.families import FAMILIES
from flexbearing.progress import Logged
from flexbearing.studies.plan import Ring, Row, Task, Variant
from flexbearing.studies.plan.task import BAD_INPUT, CONVERGED, ERROR, Base
from flexbearing.studies.table.collected import numbers

LONGEST = 500  # characters of a message


def rows(task: Task, texts: tuple[str, ...], cache: str | None = None) -> tuple[Row, ...]:
    """Compute the variants of a task.

    Parameters
    ----------
    task : Task
        variants between the same rings
    texts : tuple of str
        outputs that are wanted, with units
    cache : str, optional
        folder of condensed rings, where it is not that of the user

    Returns
    -------
    tuple of Row
        one for each variant, also where it failed
    """
    with _rings_in(cache):
        return tuple(_row(variant, task.base, texts) for variant in task.variants)


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
        with _rings_in(cache), suppress(BadCase, PartnerFailed), threadpool_limits(limits=1, user_api="blas"):
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
