"""Sensitivities of a case, given its family."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from math import isfinite, nan

from flexbearing.case import BadCase, Head
from flexbearing.case.family import Family
from flexbearing.derivatives.keys import keys_of
from flexbearing.derivatives.table import Chosen, OutputValue, Sensitivities
from flexbearing.outputs import requested
from flexbearing.progress import Report
from flexbearing.runs.plausible import graded
from flexbearing.runs.run_case import answers, reader

COLLECTIVE = "all", "life"  # what a family has its own names for


def sensitivities(
    case: Head, family: Family, of: Sequence[str], by: Sequence[str], report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs of a case by its keys, see the function of its family.

    Without keys also the outputs with other choices of graded keys, such as the cleanliness of the oil.

    Raises `BadCase` for a family without derivatives, and for keys that have none, before anything is solved;
    `UnknownOutput`, `WrongUnit` for texts that name no output, before anything is solved.
    """
    if family.sensitivities is None:
        raise BadCase(
            f'{case.source.path}: outputs of kind = "{case.kind}" are not differentiated; '
            "vary the key in a study instead"
        )
    _require_names(case, family, of, by)
    found = family.sensitivities()(case, of, by, report)
    return found if by else replace(found, chosen=_with_other_choices(case, family, found.outputs, report))


def _with_other_choices(
    case: Head, family: Family, outputs: Sequence[OutputValue], report: Report | None
) -> tuple[Chosen, ...]:
    """Outputs with the next choices of every graded key; those that cannot be computed are left out."""
    others = [(each.key, other) for each in graded(case) for other in each.others]
    if report:
        report.stage(f"{len(others)} other choices", None)
    read, cases, known = reader(case, family), [], []
    for key, other in others:
        with suppress(BadCase):
            cases.append(read(other.settings))
            known.append((key, other.words))
    texts = [f"{each.name} [{each.unit}]" for each in outputs]
    answered = answers(cases, texts, family)
    return tuple(
        Chosen(output, key, words, number)
        for (key, words), answer in zip(known, answered, strict=True)
        for output, text in zip(outputs, texts, strict=True)
        if isfinite(number := answer.numbers.get(text, nan))
    )


def _require_names(case: Head, family: Family, of: Sequence[str], by: Sequence[str]) -> None:
    """Refuse names before all that derivatives need is imported."""
    layout = family.layout()
    for text in of:
        if text not in COLLECTIVE:
            requested(layout, text)
    for path in by:
        keys_of(case, path)
