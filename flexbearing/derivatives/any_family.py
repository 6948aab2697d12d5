"""Sensitivities of a case, given its family."""

from collections.abc import Sequence

from flexbearing.case import BadCase, Head
from flexbearing.case.family import Family
from flexbearing.derivatives.keys import keys_of
from flexbearing.derivatives.table import Sensitivities
from flexbearing.outputs import wanted
from flexbearing.progress import Report

COLLECTIVE = "all", "life"  # what a family has its own names for


def sensitivities(
    case: Head, family: Family, of: Sequence[str], by: Sequence[str], report: Report | None = None
) -> Sensitivities:
    """Derivatives of outputs of a case by its keys, see the function of its family.

    Raises
    ------
    BadCase
        for a family without derivatives, and for keys that have none, before anything is solved
    UnknownOutput, WrongUnit
        for texts that name no output, before anything is solved
    """
    if family.sensitivities is None:
        raise BadCase(
            f'{case.source.path}: outputs of kind = "{case.kind}" are not differentiated; '
            "vary the key in a study instead"
        )
    _require_names(case, family, of, by)
    return family.sensitivities()(case, of, by, report)


def _require_names(case: Head, family: Family, of: Sequence[str], by: Sequence[str]) -> None:
    """Refuse names before all that derivatives need is imported."""
    layout = family.layout()
    for text in of:
        if text not in COLLECTIVE:
            wanted(layout, text)
    for path in by:
        keys_of(case, path)
