"""Outputs that become columns, by the names of the summary."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from math import isnan, nan

from flexbearing.case import BadCase
from flexbearing.case.family import Families
from flexbearing.outputs import RequestedOutput, UnknownOutput, WrongUnit, of_rollers, outputs, requested
from flexbearing.outputs.names import BLOCKS
from flexbearing.outputs.value import conversion, quoted
from flexbearing.quantities.layout import Layout
from flexbearing.studies.file import Study
from flexbearing.studies.plan import Row
from flexbearing.studies.table.table import Column

_QUOTIENT = re.compile(r"\s*(?P<dividend>[\w.]+)\s*/\s*(?P<divisor>[\w.]+)\s*(?:\[(?P<unit>[^]]*)\]\s*)?")


@dataclass(frozen=True)
class Collected:
    """An output that becomes a column."""

    column: str  # its heading without the unit
    text: str  # as `flexbearing.outputs.requested` takes it, with its unit
    unit: str  # empty for plain numbers
    error: bool = False  # whether it is the estimated error of an output
    over: str = ""  # output in the same unit that it is divided by; empty: none
    factor: float = 1.0  # of the quotient in the unit
    rollers: int = 0  # how many numbers `text` has, one for each roller; 0: it is a single number

    @property
    def texts(self) -> tuple[str, ...]:
        """Outputs that rows must hold."""
        if self.rollers:
            name, _, unit = self.text.partition(" ")
            return tuple(f"{name}.{number + 1} {unit}" for number in range(self.rollers))
        return (self.text, self.over) if self.over else (self.text,)

    def values(self, rows: Sequence[Row]) -> Column:
        """The column of some rows; NaN where a row has no such number."""
        if self.rollers:
            texts = self.texts
            numbers = tuple(tuple(row.values.get(text, nan) for text in texts) for row in rows)
            return Column(self.column, self.unit, numbers)
        return Column(self.column, self.unit, tuple(map(self._value, rows)))

    def _value(self, row: Row) -> float:
        value = row.values.get(self.text, nan)
        if not self.over:
            return value
        divisor = row.values.get(self.over, nan)
        return value / divisor * self.factor if divisor else nan


def collected(study: Study, families: Families, *, elastic: bool, rollers: int = 0) -> tuple[Collected, ...]:
    """Columns that a study collects; without [collect], every scalar of the summary.

    Raises `BadCase` for a name that no output has, or a unit of another kind.
    """
    layout = families[study.kind].layout()
    if study.collect is None:
        blocks = [f"{block}." for block in BLOCKS] if elastic else [""]
        texts = [f"{block}{output.name}" for block in blocks for output in outputs(layout)]
        return tuple(of_output(text, requested(layout, text)) for text in texts)
    columns = []
    for each in study.collect:
        try:
            columns.append(of_text(each.column, each.text, layout, rollers))
        except (UnknownOutput, WrongUnit) as problem:
            raise BadCase(f"{study.path.name}: [collect] {each.column}: {problem}") from None
    return tuple(columns)


def require_outputs(study: Study, texts: Iterable[str], table: str, families: Families) -> None:
    """Refuse outputs that a table of the study file needs and that this kind of bearing does not have.

    Raises `BadCase` naming table and output.
    """
    layout = families[study.kind].layout()
    try:
        for text in texts:
            requested(layout, text)
    except UnknownOutput as problem:
        raise BadCase(f"{study.path.name}: [{table}] {problem}") from None


def of_output(column: str, output: RequestedOutput) -> Collected:
    """Column of an output under a name."""
    return Collected(column, f"{output.name} [{output.unit}]", "" if output.unit == "1" else output.unit)


def of_text(column: str, text: str, layout: Layout, rollers: int = 0) -> Collected:
    """Column of an output, of the quotient of two, "life_L10 / rigid.life_L10 [%]", or of all rollers.

    Raises `UnknownOutput`, `WrongUnit` for a name that no output has, a unit of another kind, or outputs of
    different kinds.
    """
    name, bracket, unit = text.strip().partition("[")
    if name.strip().rpartition(".")[2] in of_rollers(layout):
        if not rollers:
            raise UnknownOutput(
                f"{quoted(text)}: a number for every roller needs the same bearing.rollers in all variants."
            )
        first = of_output(column, requested(layout, f"{name.strip()}.1 {bracket}{unit}"))
        return replace(first, text=first.text.replace(".1 ", " ", 1), rollers=rollers)
    quotient = _QUOTIENT.fullmatch(text)
    if quotient is None:
        return of_output(column, requested(layout, text))
    dividend = requested(layout, quotient["dividend"])
    divisor = requested(layout, f"{quotient['divisor']} [{dividend.unit}]")
    unit = (quotient["unit"] or "1").strip()
    above, below = of_output(column, dividend), of_output(column, divisor)
    return Collected(
        column,
        above.text,
        "" if unit == "1" else unit,
        over=below.text,
        factor=conversion("1", unit).factor,
    )


def with_errors(columns: Iterable[Collected], layout: Layout) -> tuple[Collected, ...]:
    """Columns with those of their estimated errors behind them; quotients have none."""
    found = []
    for column in columns:
        found.append(column)
        output = requested(layout, column.texts[0])
        if output.estimated and not column.over:
            unit = "%" if output.output.declared.error_relative else column.unit
            found.append(Collected(f"{column.column} error", of_error(column.text), unit, error=True))
    return tuple(found)


def estimated(texts: Iterable[str], layout: Layout) -> tuple[str, ...]:
    """Names of the estimated errors of outputs, of those that have one."""
    return tuple(of_error(text) for text in texts if requested(layout, text).estimated)


def errors(
    estimates: Mapping[str, float], texts: tuple[str, ...], kind: str, families: Families
) -> dict[str, float]:
    """Estimated errors of outputs by the texts that name them."""
    found = {}
    for text in texts:
        output = requested(families[kind].layout(), text)
        whole = 100.0 if output.output.declared.error_relative else 1.0  # in percent of the output
        error = output.error(estimates, whole)
        if not isnan(error):
            found[of_error(text)] = error
    return found


def of_error(text: str) -> str:
    """What the estimated error of an output is called among the numbers of a row."""
    return f"{text} error"
