"""What a run reaches, checked against the layout of its family and kept in memory."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any, ClassVar, Literal, Protocol

import numpy as np
from numpy.typing import ArrayLike

from flexbearing.case.family import Family
from flexbearing.quantities import Quantity
from flexbearing.quantities.layout import Layout
from flexbearing.results.attributes import checked, empty, stamp
from flexbearing.results.checks import (
    NotInLayout,
    Sizes,
    fitted,
    require_finite,
    require_same_names,
    require_true_ending,
)
from flexbearing.results.result import NOTHING, Arrays, Result

Others = Literal["searched", "reported", "left out"]


class Recorder(Protocol):
    """Takes what a run reaches: a `Record`, or a `ResultFile`, which also stores it."""

    stores: ClassVar[bool]  # whether a file is written
    others: Others  # what is done about other equilibria

    def iteration(self, number: int, values: Mapping[str, ArrayLike]) -> None:
        """Add an iteration."""
        ...

    def block(
        self, name: Literal["rigid", "flexible"], values: Mapping[str, ArrayLike], *, converged: bool = True
    ) -> None:
        """Add an end state."""
        ...


class Record:
    """Iterations, blocks and root attributes of a run at work; nothing is written anywhere.

    `attributes` are root attributes that are known when the run begins, such as ``title`` and ``case_text``;
    the family of the bearing decides the layout. Other equilibria are "searched", "reported", where a note
    says where they are likely, or "left out", where numbers alone matter, which are compared with those of
    other cases.
    Raises `NotInLayout` for an attribute that the layout does not know, or cannot hold.
    """

    stores: ClassVar[bool] = False

    def __init__(self, attributes: Mapping[str, Any], family: Family, *, others: Others = "searched"):
        self.others = others
        self._family = family
        self._layout: Layout = family.layout()
        self._attributes = self._allowed({**stamp(), "kind": family.kind, **attributes})
        self._sizes: Sizes = {}
        self._shapes: dict[str, tuple[int, ...]] = {}  # of the datasets so far
        self._blocks: dict[str, Arrays] = {}
        self._converged: dict[str, bool] = {}  # block to whether it is a solution
        self._iterations: list[Arrays] = []

    def iteration(self, number: int, values: Mapping[str, ArrayLike]) -> None:
        """Add an iteration; its numbers need not be finite.

        Raises `NotInLayout` for a number out of turn, an unknown or missing name, or a wrong shape.
        """
        if number != len(self._iterations) + 1:
            raise NotInLayout(
                f"iteration {number} after iteration {len(self._iterations)}; they come without gaps."
            )
        known = self._layout.datasets("iteration")
        self._iterations.append(self._fitting(f"iteration {number}", known, values, must_be_finite=False))

    def block(
        self, name: Literal["rigid", "flexible"], values: Mapping[str, ArrayLike], *, converged: bool = True
    ) -> None:
        """Add the end state with rigid or with flexible raceways.

        Raises `NotInLayout` for an unknown or missing name, a wrong shape, or a solution that is not finite.
        """
        possible = self._layout.blocks + self._layout.further_blocks
        if name not in possible:
            known = ", ".join(possible)
            raise NotInLayout(f"block {name!r} does not exist; it is one of: {known}.")
        if name in self._converged:
            raise NotInLayout(f"{name} was added before; a block is never replaced.")
        known = self._layout.datasets("block")
        self._blocks[name] = self._fitting(name, known, values, must_be_finite=converged)
        self._converged[name] = converged

    def finish(self, **attributes: Any) -> Result:
        """The result of the run.

        Raises `NotInLayout` for an unknown or missing attribute, or one that contradicts blocks and
        iterations.
        """
        together = {**self._attributes, **self._allowed(attributes)}
        require_same_names(together, self._layout.attributes, "root attributes")
        solved = [name for name, converged in self._converged.items() if converged]
        unsolved = [name for name, converged in self._converged.items() if not converged]
        require_true_ending(together, self._layout, solved, len(self._iterations), unsolved)
        return self._result(together)

    def so_far(self) -> Result:
        """All there is while the run is at work; attributes that are not known yet are empty."""
        missing = {
            name: empty(entry.kind)
            for name, entry in self._layout.attributes.items()
            if not entry.optional and name not in self._attributes
        }
        count = len(self._iterations)
        ending = {"status": "unfinished", "message": "at work, or interrupted", "iterations": count}
        return self._result({**missing, **self._attributes, **ending})

    @property
    def words(self) -> str:
        """The blocks and iterations that are there, in a sentence; empty where nothing is."""
        blocks = [f"the state with {name} raceways" for name in self._converged]
        count = len(self._iterations)
        blocks += [f"{count} iteration{'s' if count > 1 else ''}"] if count else []
        return " and ".join(blocks)

    def _result(self, attributes: Mapping[str, Any]) -> Result:
        blocks = {"rigid": NOTHING, "flexible": NOTHING, **self._blocks}
        return Result(
            path=None,
            attributes=MappingProxyType(attributes),
            rigid=blocks["rigid"],
            flexible=blocks["flexible"],
            iterations=tuple(self._iterations),
            family=self._family,
        )

    def _fitting(
        self, where: str, known: Mapping[str, Quantity], values: Mapping[str, ArrayLike], must_be_finite: bool
    ) -> Arrays:
        # everything is checked before anything is kept: no group is ever half there
        require_same_names(values, known, where)
        arrays = {name: np.array(values[name], dtype=float) for name in known if name in values}
        sizes = self._sizes
        for name, array in arrays.items():
            if self._shapes.get(name) != array.shape:  # the first array of a name settles its shape
                sizes = fitted(known[name], array, sizes, where)
            if must_be_finite:
                require_finite(known[name], array, where)
            array.flags.writeable = False
        self._sizes = sizes
        self._shapes |= {name: array.shape for name, array in arrays.items()}
        return MappingProxyType(arrays)

    def _allowed(self, attributes: Mapping[str, Any]) -> dict[str, Any]:
        # what is still missing comes with finish
        known = self._layout.attributes
        require_same_names({**dict.fromkeys(known), **attributes}, known, "root attributes")
        return {name: checked(known[name], value) for name, value in attributes.items()}
