"""What one run left behind, as arrays that cannot change."""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from flexbearing.case.family import Family
from flexbearing.outputs import Value, wanted
from flexbearing.quantities.attributes import GRADES
from flexbearing.quantities.summary import summary
from flexbearing.results.checks import require_same_names

Arrays = Mapping[str, np.ndarray]
NOTHING: Arrays = MappingProxyType({})


@dataclass(frozen=True, kw_only=True)
class Result:
    """What one run left behind, in SI units; names as in the layout."""

    path: Path | None  # of its file; None where nothing was written
    attributes: Mapping[str, Any]  # JSON attributes are mappings again, lists are tuples
    rigid: Arrays  # empty when the run ended before it was solved
    flexible: Arrays  # likewise; of ball bearings also between rigid rings
    iterations: tuple[Arrays, ...]  # from the first to the last
    family: Family  # of the bearing

    @property
    def kind(self) -> str:
        """Name of the family."""
        return self.family.kind

    @property
    def place(self) -> str:
        """Its file, or where there is none its title: what a message names."""
        return str(self.path) if self.path else f"result of {self.attributes['title']!r}"

    @property
    def stem(self) -> str:
        """Stem of the names of files that are made of it: that of its file, or of the case."""
        return Path(self.path or self.attributes.get("case_file") or self.kind).stem

    @property
    def files(self) -> tuple[Path, ...]:
        """Its file, where there is one: no output may replace it."""
        return (self.path,) if self.path else ()

    @property
    def dangers(self) -> tuple[Mapping[str, str], ...]:
        """Notes that whoever acts on the answer must heed, each with its code and text."""
        return tuple(note for note in self.attributes["notes"] if note["grade"] == GRADES[0])

    def __getitem__(self, output: str) -> Value:
        """A scalar by its name, "flexible.max_roller_load" or "cage_slip [%]"; see `flexbearing.outputs`."""
        return wanted(self.family.layout(), output).value({"rigid": self.rigid, "flexible": self.flexible})

    def summary(self) -> dict[str, Any]:
        """Numbers of the run as one object that JSON can hold; a name carries its unit."""
        blocks = {"rigid": self.rigid, "flexible": self.flexible}
        return summary(self.family.layout(), self.attributes, blocks)

    @property
    def stacked(self) -> Arrays:
        """Every dataset of the iterations, stacked over them; empty without any."""
        names = self.iterations[0] if self.iterations else ()
        return {name: np.stack([state[name] for state in self.iterations]) for name in names}

    def history(self, name: str) -> np.ndarray:
        """Stack a dataset over the iterations.

        Parameters
        ----------
        name : str
            a dataset of the iterations, such as ``load_change``

        Returns
        -------
        array (iterations, ...)
            stacked; without iterations, an array of length 0

        Raises
        ------
        NotInLayout
            for a name that iterations do not have
        """
        known = self.family.layout().datasets("iteration")
        if name not in known:
            require_same_names({**dict.fromkeys(known), name: None}, known, "history")
        if not self.iterations:
            return np.empty(0)
        return np.stack([state[name] for state in self.iterations])
