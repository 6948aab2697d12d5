"""Sensitivities of a case, given its family."""

from collections.abc import Sequence

from flexbearing.case import BadCase, Head
from flexbearing.case.family import Family
from flexbearing.derivatives.table import Sensitivities


def sensitivities(case: Head, family: Family, of: Sequence[str], by: Sequence[str]) -> Sensitivities:
    """Derivatives of outputs of a case by its keys, see the function of its family.

    Parameters
    ----------
    case : Head
        as it was read
    family : Family
        its family
    of : sequence of str
        outputs
    by : sequence of str
        keys

    Returns
    -------
    Sensitivities

    Raises
    ------
    BadCase
        for a family without derivatives
    """
    if family.sensitivities is None:
        raise BadCase(
            f'{case.source.path}: outputs of kind = "{case.kind}" are not differentiated; '
            "vary the key in a study instead"
        )
    return family.sensitivities()(case, of, by)
