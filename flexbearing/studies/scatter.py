"""The scatter of a sampled study: beside its table, in files and a picture."""

from dataclasses import replace
from itertools import chain
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from flexbearing.files import write
from flexbearing.report.html.scatter import ScatterTables, figures_of
from flexbearing.report.html.units import METRIC
from flexbearing.report.panels import picture
from flexbearing.report.picture import picture_bytes
from flexbearing.studies.first_order import first_order
from flexbearing.studies.prepared_study import PreparedStudy
from flexbearing.studies.table import Column, Table
from flexbearing.studies.table.files import SCATTER_PICTURE, store
from flexbearing.studies.table.scatter import Scatter

MOST = 6  # outputs of the picture; the tables have all
APART = ("status", "message", "seconds", "result")  # columns that are no outputs


def add_scatter(prepared: PreparedStudy, table: Table, folder: Path) -> Table:
    """Add to a table what its rows tell of the scatter of the outputs, and write that.

    Raises
    ------
    NotStored
        where a file cannot be written
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
