"""A result file that is stored while the run goes on and gets its name when complete."""

import logging
from collections.abc import Mapping
from contextlib import ExitStack, suppress
from pathlib import Path
from threading import RLock, Timer
from typing import Any, Literal, Self

import numpy as np
from numpy.typing import ArrayLike

from flexbearing.case.family import Family
from flexbearing.files import NotStored, lock, parts_of, require_output, write
from flexbearing.files.whole import host, part_name
from flexbearing.quantities import Quantity
from flexbearing.quantities.layout import Layout
from flexbearing.results import hdf5
from flexbearing.results.attributes import empty, encoded, stamp
from flexbearing.results.checks import (
    NotInLayout,
    Sizes,
    fitted,
    require_finite,
    require_same_names,
    require_true_ending,
)
from flexbearing.results.content import Content
from flexbearing.results.read import Result, of_content

LATEST = 0.5  # [s] that anything finished stays in memory only
log = logging.getLogger(__name__)


class ResultFile:
    """The result file of a run; its only writer.

    What is finished goes to a ``.part`` file within a second, always as a whole file that can be read, until
    :meth:`finish` writes the result and gives it its name: a name without ``.part`` promises a complete file.
    A run that breaks off leaves the ``.part`` file with all that it reached, and says so in a note of the
    exception.

    Parameters
    ----------
    path : path
        the final name; a file that is already there stays until the new one is complete
    attributes : mapping
        root attributes that are known when the run begins, such as ``title`` and ``case_text``
    family : Family
        of the bearing; it decides the layout
    inputs : sequence of paths
        files that are read and that the result must not replace

    Raises
    ------
    NotInLayout
        for an attribute that the layout does not know, or cannot store
    BadOutput
        for a name that cannot be written, or that another run is writing (on entering)

    Examples
    --------
    ::

        with ResultFile("case.h5", {"title": "squirrel cage"}, family) as file:
            for number, state in enumerate(states, start=1):
                file.iteration(number, state)
            file.block("rigid", rigid)
            file.block("flexible", flexible)
            result = file.finish(status="converged", ...)
    """

    def __init__(
        self, path: str | Path, attributes: Mapping[str, Any], family: Family, inputs: tuple[Path, ...] = ()
    ):
        self.path = Path(path)
        self._place = require_output(path, inputs)  # where a link leads
        self.part = part_name(self._place)
        self._family = family
        self._layout: Layout = family.layout()
        self._attributes = {**stamp(), "kind": family.kind, **attributes}
        self._encoded(self._attributes)
        self._sizes: Sizes = {}
        self._blocks: dict[str, np.ndarray] = {}  # by block and name, "rigid/inner_load"
        self._converged: dict[str, bool] = {}  # block to whether it is a solution
        self._iterations: list[dict[str, np.ndarray]] = []
        self._open = ExitStack()
        self._is_open = False
        self._guard = RLock()  # of all that the timer reads
        self._timer: Timer | None = None
        self._problem: Exception | None = None  # met by the timer

    def __enter__(self) -> Self:
        self._open.enter_context(lock(self._place))
        self._is_open = True
        return self

    def __exit__(self, kind: object, problem: BaseException | None, trace: object) -> None:
        try:
            if self._is_open:  # not finished
                with self._guard:
                    self._is_open = False
                    if self._timer is not None:
                        self._timer.cancel()
                kept = "" if isinstance(problem, NotStored) else self._kept()
                if kept and problem is not None:
                    problem.add_note(kept)
            elif problem is not None:  # a signal that came a moment later
                problem.add_note(f"complete: {self.path}")
        finally:
            self._open.close()

    def iteration(self, number: int, values: Mapping[str, ArrayLike]) -> None:
        """Add an iteration; its numbers need not be finite.

        Parameters
        ----------
        number : int
            1 for the first, then without gaps
        values : mapping
            every dataset of an iteration, by name

        Raises
        ------
        NotInLayout
            for a number out of turn, an unknown or missing name, or a wrong shape
        NotStored
            if earlier ones could not be stored
        """
        if number != len(self._iterations) + 1:
            raise NotInLayout(
                f"iteration {number} after iteration {len(self._iterations)}; they come without gaps."
            )
        known = self._layout.datasets("iteration")
        arrays = self._checked(f"iteration {number}", known, values, must_be_finite=False)
        with self._guard:
            self._iterations.append(arrays)
        self._store_soon()

    def block(
        self, name: Literal["rigid", "flexible"], values: Mapping[str, ArrayLike], *, converged: bool = True
    ) -> None:
        """Add the end state with rigid or with flexible raceways.

        Parameters
        ----------
        name : "rigid" or "flexible"
            which of the two
        values : mapping
            every dataset of a block that is not optional, by name
        converged : bool
            whether this is a solution; only then every number must be finite

        Raises
        ------
        NotInLayout
            for an unknown or missing name, a wrong shape, or a solution that is not finite
        NotStored
            if what came before could not be stored
        """
        possible = self._layout.blocks + self._layout.further_blocks
        if name not in possible:
            known = ", ".join(possible)
            raise NotInLayout(f"block {name!r} does not exist; it is one of: {known}.")
        if name in self._converged:
            raise NotInLayout(f"{name} was written before; a result file is never overwritten in part.")
        known = self._layout.datasets("block")
        arrays = self._checked(name, known, values, must_be_finite=converged)
        with self._guard:
            self._blocks |= {f"{name}/{entry}": array for entry, array in arrays.items()}
            self._converged[name] = converged
        self._store_soon()

    def finish(self, **attributes: Any) -> Result:
        """Write the result, read it back and give it its name.

        Parameters
        ----------
        **attributes
            every root attribute that was not given at the beginning, such as ``status``

        Returns
        -------
        Result
            as it stands in the file

        Raises
        ------
        NotInLayout
            for an unknown or missing attribute, or one that contradicts what was written
        NotStored
            if it could not be written; what had its name before is unchanged
        """
        self._require_open()
        together = {**self._attributes, **attributes}
        require_same_names(together, self._layout.attributes, "root attributes")
        solved = [name for name, converged in self._converged.items() if converged]
        unsolved = [name for name, converged in self._converged.items() if not converged]
        require_true_ending(together, self._layout, solved, len(self._iterations), unsolved)
        data = hdf5.image(self._content(together))
        result = of_content(*hdf5.content(data), self.path, {self._family.kind: self._family})
        write(self._place, data)
        with self._guard:
            self._is_open = False
            if self._timer is not None:
                self._timer.cancel()
        self._remove_parts()
        return result

    def _content(self, attributes: Mapping[str, Any]) -> Content:
        """All there is so far, with these root attributes."""
        known = self._layout.datasets("block")
        texts = {place: _texts(known[place.partition("/")[2]]) for place in self._blocks}
        arrays = dict(self._blocks)
        if self._iterations:
            for name, entry in self._layout.datasets("iteration").items():
                if name in self._iterations[0]:
                    place = f"iterations/{name}"
                    arrays[place] = np.stack([state[name] for state in self._iterations])
                    texts[place] = _texts(entry, "iteration ")
        return Content(self._encoded(attributes), arrays, texts)

    def _store_soon(self) -> None:
        """Have the timer store what there is; what it could not store before is told now."""
        with self._guard:
            if self._problem is not None:
                raise self._problem
            if self._timer is None:
                self._timer = Timer(LATEST, self._store_on_time)
                self._timer.daemon = True
                self._timer.start()

    def _store_on_time(self) -> None:
        with self._guard:
            self._timer = None
            if self._is_open:
                try:
                    self._store_part()
                except Exception as problem:  # whatever it is, the run must hear of it
                    self._problem = problem

    def _store_part(self) -> None:
        """Store all there is so far as an unfinished result."""
        missing = {
            name: empty(entry.kind)
            for name, entry in self._layout.attributes.items()
            if not entry.optional and name not in self._attributes
        }
        count = len(self._iterations)
        so_far = {"status": "unfinished", "message": "at work, or interrupted", "iterations": count}
        content = self._content({**missing, **self._attributes, **so_far})
        write(self.part, hdf5.image(content), beside=self._place, lasting=False)

    def _kept(self) -> str:
        """Store what there is when a run breaks off; says what was kept and where, nothing without it."""
        if not (self._blocks or self._iterations):
            return ""
        try:
            self._store_part()
        except NotStored as problem:
            return f"what was finished could not be kept: {problem}"
        blocks = [f"the state with {name} raceways" for name in self._converged]
        count = len(self._iterations)
        blocks += [f"{count} iteration{'s' if count > 1 else ''}"] if count else []
        return f"{' and '.join(blocks)} kept in {self.part}"

    def _remove_parts(self) -> None:
        """Remove parts of runs that ended: whoever holds the lock knows that those of this host did."""
        for part, where, process in parts_of(self._place):
            if where == host():
                with suppress(OSError):  # somebody else removed it
                    part.unlink()
            else:
                log.info("%s is left of process %d on %s; remove it if that has ended", part, process, where)

    def _checked(
        self, where: str, known: Mapping[str, Quantity], values: Mapping[str, ArrayLike], must_be_finite: bool
    ) -> dict[str, np.ndarray]:
        # everything is checked before anything is kept: no group is ever half there
        self._require_open()
        require_same_names(values, known, where)
        arrays = {name: np.array(values[name], dtype=float) for name in known if name in values}
        sizes = self._sizes
        for name, array in arrays.items():
            sizes = fitted(known[name], array, sizes, where)
            if must_be_finite:
                require_finite(known[name], array, where)
        self._sizes = sizes
        return arrays

    def _encoded(self, attributes: Mapping[str, Any]) -> dict[str, Any]:
        # what is still missing comes with finish
        known = self._layout.attributes
        require_same_names({**dict.fromkeys(known), **attributes}, known, "root attributes")
        return {name: encoded(known[name], value) for name, value in attributes.items()}

    def _require_open(self) -> None:
        if not self._is_open:
            raise NotInLayout(f"{self.path}: the result file is not open; write inside its with-block.")


def _texts(entry: Quantity, leading: str = "") -> dict[str, str]:
    """What a dataset says of itself."""
    return {"unit": entry.unit, "axes": f"{leading}{entry.axes}".strip(), "meaning": entry.meaning}
