"""Pictures of a result by short names, for notebooks."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from flexbearing.outputs import AbsentOutput

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True)
class Plots:
    """Pictures as functions without arguments; `dir` names them."""

    pictures: Callable[[], Mapping[str, Figure | str]]  # by names of files; or why one would be empty
    short: Mapping[str, str]  # names to those of files

    def __dir__(self) -> list[str]:
        return sorted({*self.short, *self.pictures()})

    def __getattr__(self, name: str) -> Callable[[], Figure]:
        if name.startswith("_"):
            raise AttributeError(name)

        def plot() -> Figure:
            drawn = self.pictures()
            figure = drawn.get(self.short.get(name, name), "is no picture of this result")
            if isinstance(figure, str):
                raise AbsentOutput(f"plot.{name}: {figure}; there are {', '.join(dir(self))}.")
            return figure

        return plot
