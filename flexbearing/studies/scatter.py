"""The scatter of a sampled study: beside its table, in files and a picture."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexbearing.case import BadCase
from flexbearing.derivatives.sensitivities import sensitivities
from flexbearing.families import FAMILIES
from flexbearing.files import write
from flexbearing.report.html.scatter import ScatterTables, figures_of
from flexbearing.report.html.units import METRIC
from flexbearing.report.panels import picture
from flexbearing.report.picture import picture_bytes
from flexbearing.sampling.linear import Linear
from flexbearing.studies.file.read import ENDS
from flexbearing.studies.file.sampled import Drawn, Factor
from flexbearing.studies.prepared_study import PreparedStudy, variants_of
from flexbearing.studies.table import Column, Table
from flexbearing.studies.table.files import SCATTER_PICTURE, store
from flexbearing.studies.table.scatter import Scatter
from quasidynamic import NotSolved


@dataclass(frozen=True, eq=False)
class FirstOrder:
    """Predictions of outputs, and what is missing from them."""

    outputs: Mapping[str, Linear]  # by the names of columns
    missing: tuple[str, ...] = ()  # sentences


def first_order(prepared: PreparedStudy) -> FirstOrder:
    """Differentiate the outputs of a sampled study where every drawn key has its mean."""
    drawn = prepared.study.drawn
    assert drawn  # of no other study is it asked
    if prepared.study.spectrum:
        return FirstOrder({}, ("no linear prediction: the life under a duty cycle is not differentiated",))
    columns = [each for each in prepared.columns if not (each.over or each.rollers or each.error)]
    try:
        case = _at_means(prepared, drawn)
        elastic = bool(prepared.plan.rings())  # states on the way to the answer are not differentiated
        known = [each for each in columns if not (elastic and each.text.startswith("rigid."))]
        found = sensitivities(
            case, FAMILIES[case.kind], [each.text for each in known], [each.key for each in drawn.factors]
        )
    except (BadCase, NotSolved) as problem:
        return FirstOrder({}, (f"no linear prediction: {' '.join(str(problem).splitlines())}",))
    places = {f"{each.name} [{each.unit}]": place for place, each in enumerate(found.outputs)}
    slopes = _slopes(found, drawn)
    means, deviations = (
        np.concatenate([np.full(each.width, getattr(each.distribution, name)) for each in drawn.factors])
        for name in ("mean", "deviation")
    )
    outputs = {
        column.column: Linear(found.outputs[place].value, slopes[place], means, deviations)
        for column in known
        if (place := places.get(column.text)) is not None and np.isfinite(slopes[place]).all()
    }
    return FirstOrder(
        outputs, tuple(f"linear prediction without {key}: {why}" for key, why in found.left_out)
    )


def _at_means(prepared: PreparedStudy, drawn: Drawn) -> Any:
    """The case with every drawn key at its mean, others as in all variants."""
    base, first = prepared.plan.base, prepared.plan.variants[0]
    values = dict(zip(base.keys, first.values, strict=True))
    for factor in drawn.factors:
        values[factor.key] = factor.written([factor.distribution.mean] * factor.width)
    return variants_of(base).case(tuple(values.values()))


def _slopes(found: Any, drawn: Drawn) -> NDArray:
    """Derivatives (O, D) by the drawn numbers in SI; zero by keys that have none."""
    by_key = {key.path: found.slopes[:, place] / key.size for place, key in enumerate(found.keys)}
    nothing = np.zeros(len(found.outputs))
    return np.array([by_key.get(path, nothing) for factor in drawn.factors for path in _paths(factor)]).T


def _paths(factor: Factor) -> list[str]:
    """Keys of the numbers of a list, or the key itself."""
    return [f"{factor.key}.{number + 1}" for number in range(factor.width)] if factor.listed else [factor.key]


MOST = 6  # outputs of the picture; the tables have all
APART = (*ENDS, "result")  # columns that are no outputs


def add_scatter(prepared: PreparedStudy, table: Table, folder: Path) -> Table:
    """Add to a table what its rows tell of the scatter of the outputs, and write that.

    Raises `NotStored` where a file cannot be written.
    """
    assert prepared.study.drawn  # of no other study is it asked
    prediction = first_order(prepared)
    outputs = _outputs(table.cycles or table)
    scatter = Scatter(table.name, prepared.study.drawn, _drawn(prepared), outputs, prediction.outputs)
    tables = scatter.tables()
    for each in tables:
        store(each, folder)
    if len(tables[0]):
        place = folder / f"{table.name}{SCATTER_PICTURE}"
        figures = figures_of(ScatterTables(*(each.rows for each in tables)), METRIC, MOST)
        drawn = picture(f"Study: {table.name}", "Scatter, and what causes it", figures, 2, (4.8, 2.6))
        write(place.resolve(), picture_bytes(drawn))
    return replace(table, scatter=tables, missing=prediction.missing)


def _outputs(table: Table) -> tuple[Column, ...]:
    """Columns of numbers that are computed."""
    return tuple(
        column
        for column in table.columns
        if not column.varied
        and column.name not in APART
        and not column.name.endswith(" error")
        and all(isinstance(value, float | int) for value in column.values)
    )


def _drawn(prepared: PreparedStudy) -> NDArray:
    """Drawn values (rows, D) in SI units; with a duty cycle a row for each of its bearings."""
    plan, drawn = prepared.plan, prepared.study.drawn
    assert drawn
    length = len(plan.axes[-1].rows) if prepared.study.spectrum else 1
    columns = [plan.base.keys.index(factor.key) for factor in drawn.factors]
    lists = [factor.listed for factor in drawn.factors]
    return np.array([
        [*chain.from_iterable(
            variant.in_si[at] if listed else (variant.in_si[at],)
            for at, listed in zip(columns, lists, strict=True)
        )]
        for variant in plan.variants[::length]
    ])  # fmt: skip
