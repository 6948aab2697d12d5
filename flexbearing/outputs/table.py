"""All scalar outputs of a result as a table that can be searched."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from html import escape
from math import isfinite

from flexbearing.outputs.names import AbsentOutput, Block, Output, UnknownOutput, outputs, requested
from flexbearing.outputs.value import Value
from flexbearing.printable import printable
from flexbearing.quantities.effects import LIVES
from flexbearing.quantities.layout import Layout

_LIFE = re.compile(r"\s*((?:rigid|flexible)\.)?life\s*(\[[^]]*\])?\s*")
WIDTH = 100  # characters of a line


@dataclass(frozen=True, eq=False)
class Outputs(Mapping[str, Value]):
    """Scalars of a result by name; those that the case does not give are left out."""

    layout: Layout
    blocks: Mapping[str, Block]
    words: str = ""  # that name or meaning contain

    def search(self, words: str) -> "Outputs":
        """Outputs whose name or meaning contains some words."""
        return Outputs(self.layout, self.blocks, words.lower())

    def __getitem__(self, name: str) -> Value:
        """An output by name, block and unit, "rigid.max_roller_load [kN]"; "life" is the most detailed."""
        if life := _LIFE.fullmatch(name):
            return self._life(*(part or "" for part in life.groups()))
        return requested(self.layout, name).value(self.blocks)

    def __contains__(self, name: object) -> bool:
        return name in {*self}

    def __iter__(self) -> Iterator[str]:
        return (output.name for output, _ in self._rows)

    def __len__(self) -> int:
        return len(self._rows)

    def __repr__(self) -> str:
        rows = [(output.name, f"{value!r}", output.meaning) for output, value in self._rows]
        first, second = (max((len(row[place]) for row in rows), default=0) for place in (0, 1))
        lines = (f"{name:<{first}}  {value:>{second}}  {meaning}" for name, value, meaning in rows)
        return printable(
            "\n".join(line if len(line) <= WIDTH else f"{line[: WIDTH - 3]}..." for line in lines)
        )

    def _repr_html_(self) -> str:
        rows = (
            f"<tr><td>{output.name}</td><td>{value.number:.6g}</td><td>{_unit(value)}</td>"
            f"<td>{escape(output.meaning)}</td></tr>"
            for output, value in self._rows
        )
        head = "<tr><th>name</th><th>value</th><th>unit</th><th>meaning</th></tr>"
        return f"<table>{head}{''.join(rows)}</table>"

    @property
    def _rows(self) -> list[tuple[Output, Value]]:
        found = []
        for output in outputs(self.layout):
            if self.words in f"{output.name} {output.meaning}".lower():
                value = self._known(output.name)
                if value is not None:
                    found.append((output, value))
        return found

    def _known(self, name: str) -> Value | None:
        """An output that is there and finite."""
        try:
            value = requested(self.layout, name).value(self.blocks)
        except (AbsentOutput, UnknownOutput):
            return None
        return value if isfinite(float(value)) else None

    def _life(self, block: str, unit: str) -> Value:
        """The first of the lives that a result has."""
        names = [f"{block}{name}" for name in LIVES]
        name = next((name for name in names if self._known(name) is not None), names[-1])
        return requested(self.layout, f"{name} {unit}").value(self.blocks)


def _unit(value: Value) -> str:
    return "" if value.unit == "1" else value.unit
