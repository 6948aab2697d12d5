"""A result file that grows with the run and gets its name when complete."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal, Self

import h5py
import numpy as np
from numpy.typing import ArrayLike

from flexbearing.case.family import Family
from flexbearing.quantities import Quantity
from flexbearing.quantities.layout import Layout
from flexbearing.results.attributes import encoded, stamp
from flexbearing.results.checks import NotInLayout, Sizes, fitted, require_finite, require_same_names

UNFINISHED = ".part"


class ResultFile:
    """The result file of a run, written while it runs.

    The file is called ``<path>.part`` until :meth:`finish` gives it its name, so that a name
    without ``.part`` promises a complete file. A run that breaks off leaves the ``.part`` file,
    closed, with every iteration it reached.

    Parameters
    ----------
    path : path
        the final name; a file that is already there stays until the new one is complete
    attributes : mapping
        root attributes that are known when the run begins, such as ``title`` and ``case_text``
    family : Family
        of the bearing; it decides the layout

    Raises
    ------
    NotInLayout
        for an attribute that the layout does not know, or cannot store

    Examples
    --------
    ::

        with ResultFile("case.h5", {"title": "squirrel cage"}, family) as file:
            for number, state in enumerate(states, start=1):
                file.iteration(number, state)
            file.block("rigid", rigid)
            file.block("flexible", flexible)
            file.finish(status="converged", ...)
    """

    def __init__(self, path: str | Path, attributes: Mapping[str, Any], family: Family):
        self.path = _final_name(Path(path))
        self.part = self.path.with_name(self.path.name + UNFINISHED)
        self._layout: Layout = family.layout()
        self._attributes = {**stamp(), "kind": family.kind, **attributes}
        self._stored = self._encoded(self._attributes)
        self._file: h5py.File | None = None
        self._sizes: Sizes = {}
        self._iterations = 0
        self._rows: dict[str, h5py.Dataset] = {}  # of the iterations
        self._converged: dict[str, bool] = {}  # block to whether it is a solution

    def __enter__(self) -> Self:
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self._file = h5py.File(self.part, "w")
        self._file.attrs.update(self._stored)
        self._file.flush()
        return self

    def __exit__(self, *_: object) -> None:
        if self._file is not None:
            self._file.close()
            self._file = None

    def iteration(self, number: int, values: Mapping[str, ArrayLike]) -> None:
        """Add an iteration and bring it to the disk; its numbers need not be finite.

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
        """
        if number != self._iterations + 1:
            raise NotInLayout(
                f"iteration {number} after iteration {self._iterations}; they come without gaps."
            )
        known = self._layout.datasets("iteration")
        arrays = self._checked(f"iteration {number}", known, values, must_be_finite=False)
        self._append(known, arrays)
        self._iterations = number

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
        """
        possible = self._layout.blocks + self._layout.further_blocks
        if name not in possible:
            known = ", ".join(possible)
            raise NotInLayout(f"block {name!r} does not exist; it is one of: {known}.")
        file, known = self._open_file(), self._layout.datasets("block")
        if name in file:
            raise NotInLayout(f"{name} was written before; a result file is never overwritten in part.")
        for entry, array in self._checked(name, known, values, must_be_finite=converged).items():
            described(file.create_dataset(f"{name}/{entry}", data=array), known[entry])
        file.flush()
        self._converged[name] = converged

    def finish(self, **attributes: Any) -> None:
        """Write the ending, close the file and give it its final name.

        Parameters
        ----------
        **attributes
            every root attribute that was not given at the beginning, such as ``status``

        Raises
        ------
        NotInLayout
            for an unknown or missing attribute, or one that contradicts what was written
        """
        together = {**self._attributes, **attributes}
        require_same_names(together, self._layout.attributes, "root attributes")
        self._require_true_ending(together)
        file = self._open_file()
        file.attrs.update(self._encoded(attributes))
        file.close()
        self._file = None
        self.part.replace(self.path)

    def _require_true_ending(self, attributes: Mapping[str, Any]) -> None:
        if attributes["iterations"] != self._iterations:
            raise NotInLayout(
                f"iterations = {attributes['iterations']}, but {self._iterations} were written."
            )
        unsolved = [name for name in self._layout.blocks if name not in self._converged]
        unsolved += [name for name, converged in self._converged.items() if not converged]
        if attributes["status"] == "converged" and unsolved:
            raise NotInLayout(
                f"status = 'converged', but no converged block {' or '.join(unsolved)} was written."
            )

    def _checked(
        self, where: str, known: Mapping[str, Quantity], values: Mapping[str, ArrayLike], must_be_finite: bool
    ) -> dict[str, np.ndarray]:
        # everything is checked before anything is written: no group is ever half there
        self._open_file()
        require_same_names(values, known, where)
        arrays = {name: np.asarray(values[name], dtype=float) for name in known if name in values}
        sizes = self._sizes
        for name, array in arrays.items():
            sizes = fitted(known[name], array, sizes, where)
            if must_be_finite:
                require_finite(known[name], array, where)
        self._sizes = sizes
        return arrays

    def _append(self, known: Mapping[str, Quantity], arrays: Mapping[str, np.ndarray]) -> None:
        file = self._open_file()
        for name, array in arrays.items():
            if name not in self._rows:
                rows = {"shape": (0, *array.shape), "maxshape": (None, *array.shape), "dtype": float}
                made = file.create_dataset(f"iterations/{name}", chunks=(1, *array.shape), **rows)
                self._rows[name] = described(made, known[name], "iteration ")
            self._rows[name].resize(self._iterations + 1, axis=0)
            self._rows[name][self._iterations] = array
        file.flush()

    def _encoded(self, attributes: Mapping[str, Any]) -> dict[str, Any]:
        # only strangers matter here: what is still missing comes with finish
        require_same_names(
            {**dict.fromkeys(self._layout.attributes), **attributes},
            self._layout.attributes,
            "root attributes",
        )
        return {
            name: encoded(name, self._layout.attributes[name].kind, value)
            for name, value in attributes.items()
        }

    def _open_file(self) -> h5py.File:
        if self._file is None:
            raise NotInLayout(f"{self.path}: the result file is not open; write inside its with-block.")
        return self._file


def described(stored: h5py.Dataset, entry: Quantity, leading: str = "") -> h5py.Dataset:
    """Give a dataset its unit, axes and meaning; returns it."""
    texts = {"unit": entry.unit, "axes": f"{leading}{entry.axes}".strip(), "meaning": entry.meaning}
    stored.attrs.update(texts)
    return stored


def _final_name(path: Path) -> Path:
    if path.suffix == UNFINISHED:
        raise NotInLayout(
            f"{path}: names ending in {UNFINISHED} are kept for unfinished runs; choose another."
        )
    if path.is_dir():
        raise NotInLayout(f"{path} is a directory; a result file needs a name of its own.")
    return path
