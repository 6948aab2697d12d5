"""The duty cycles of a study from its variants: what bounds a row, and loads as a catalogue has them."""

from collections.abc import Callable, Collection, Iterator, Sequence
from math import nan, prod
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.family import Family
from flexbearing.studies.file.spectrum import Spectrum
from flexbearing.studies.idle import is_load
from flexbearing.studies.plan import Plan, Row, Variant
from flexbearing.studies.table.bounds import Conditions
from flexbearing.studies.table.duty import KINDS, Catalogued, Cycles
from quasidynamic import OutOfRange

IDLE = 0.0, 1.0, 1.0  # load, a_1 and exponent of a row without damage; other exponents are larger


def duty_cycles(
    plan: Plan,
    spectrum: Spectrum,
    rows: Sequence[Row],
    speeds: NDArray,
    errors: Collection[str],
    catalogue: Catalogued | None,
) -> Cycles:
    """The cycle of each bearing, from the rows and speeds of all variants of a plan."""
    length = len(plan.axes[-1].rows)
    return Cycles(
        spectrum,
        speeds.reshape(-1, length),
        [rows[first : first + length] for first in range(0, len(rows), length)],
        errors,
        conditions(plan.base.keys, plan.variants[:length]),
        np.array([bool(each.thin) for each in plan.variants]).reshape(-1, length),
        catalogue,
    )


def life_kinds(plan: Plan, spectrum: Spectrum, case_of: Callable[[Variant], Any]) -> Iterator[str]:
    """What life each cycle has: by the case of its first row that is computed."""
    length = len(plan.axes[-1].rows)
    for first in range(0, len(plan.variants), length):
        computed = [each for each in plan.variants[first : first + length] if not each.idle]
        life = case_of(computed[0]).life if computed else None
        if life is None or life.loads != "rating" or spectrum.life == "life_L10":
            yield KINDS[spectrum.life]
        else:
            yield "modified catalogue" if life.lubrication or life.reliability else "catalogue L10"


def catalogued(
    plan: Plan, family: Family, spectrum: Spectrum, case_of: Callable[[Variant], Any]
) -> Catalogued | None:
    """Loads and factors of the lives of all variants; None of kinds without, or where no load is known."""
    if family.catalogue is None:
        return None
    of = family.catalogue()
    each = [IDLE if variant.idle else _required(of, case_of(variant)) for variant in plan.variants]
    loads, factors, exponents = np.array(each).T.reshape(3, -1, len(plan.axes[-1].rows))
    if not np.any(loads > 0):
        return None
    exponent = exponents.max(axis=1)
    return Catalogued(loads, exponent, factors, spectrum.required, spectrum.application_factor)


def _required(catalogue: Any, case: Any) -> tuple[float, float, float]:
    """Equivalent load [N], NaN where not known beforehand, life over (C_r/P)^p, and p.

    That factor is a_1 of the reliability, with a C_r that leaves the stress reduction out.
    """
    from flexbearing.runs.life_of_state import of_reliability

    exponent = catalogue.exponent(case)
    factor = catalogue.rating_factor(case) ** exponent
    factor *= prod(float(each.value) for each in of_reliability(case.life))
    try:
        return catalogue.load(case), factor, exponent
    except OutOfRange:
        return nan, factor, exponent


def conditions(keys: Sequence[str], rows: Sequence[Variant]) -> Conditions:
    """Loads of the rows of a cycle, and which rows differ in nothing else."""
    loads = [number for number, key in enumerate(keys) if is_load(key)]
    others = [str([value for n, value in enumerate(row.in_si) if n not in loads]) for row in rows]
    values = np.array([[abs(row.in_si[number] or 0.0) for number in loads] for row in rows], dtype=float)
    return Conditions(values.reshape(len(rows), len(loads)), np.unique(others, return_inverse=True)[1])
