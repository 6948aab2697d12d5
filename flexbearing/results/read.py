"""A result file as arrays that cannot change."""

import json
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import h5py
import numpy as np

from flexbearing.case.family import Families, Family
from flexbearing.quantities import Quantity
from flexbearing.quantities.attributes import FORMAT, OLDER
from flexbearing.quantities.layout import Layout
from flexbearing.results.attributes import decoded
from flexbearing.results.checks import Sizes, fitted, require_same_names
from flexbearing.results.write import UNFINISHED

Arrays = Mapping[str, np.ndarray]
_NOTHING: Arrays = MappingProxyType({})


class BadResult(ValueError):
    """A file that is no complete result file of this format."""


@dataclass(frozen=True, kw_only=True)
class Result:
    """What one run left behind, in SI units; names as in the layout."""

    path: Path
    attributes: Mapping[str, Any]  # JSON attributes are mappings again, lists are tuples
    rigid: Arrays  # empty when the run ended before it was solved
    flexible: Arrays  # likewise; of ball bearings also between rigid rings
    iterations: tuple[Arrays, ...]  # from the first to the last
    family: Family  # of the bearing

    @property
    def kind(self) -> str:
        """Name of the family."""
        return self.family.kind

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


def read(path: str | Path, families: Families) -> Result:
    """Read a complete result file.

    Parameters
    ----------
    path : path
        a file written by :class:`ResultFile`
    families : mapping
        kind to family

    Returns
    -------
    Result

    Raises
    ------
    BadResult
        naming the file and what to do, when it is missing, unfinished, damaged or of another format
    """
    path = Path(path)
    _require_finished(path)
    try:
        with h5py.File(path, "r") as file:
            _require_format(file, path)
            return _result(file, path, families)
    except OSError as reason:
        raise BadResult(f"{path}: not an HDF5 file, or damaged ({reason}). Run the case again.") from reason
    except BadResult:
        raise
    except ValueError as reason:
        raise BadResult(
            f"{path}: {reason} The file was changed after it was written; run the case again."
        ) from reason


def _require_finished(path: Path) -> None:
    part = path.with_name(path.name + UNFINISHED)
    if path.suffix == UNFINISHED:
        raise BadResult(
            f"{path}: the run has not finished: it is still at work, or was interrupted. "
            "Wait or run the case again; the iterations so far can be read with h5py."
        )
    if not path.exists() and part.exists():
        raise BadResult(f"{path}: not there yet, only {part.name}. Wait for the run, or run the case again.")
    if not path.is_file():
        raise BadResult(f"{path}: no such file. `flexbearing run CASE -o {path.name}` would write it.")


def _require_format(file: h5py.File, path: Path) -> None:
    number = file.attrs.get("format")
    if number is None:
        raise BadResult(f"{path}: an HDF5 file, but not a result of flexbearing: it has no format number.")
    if not np.array_equal(number, FORMAT):
        writer = json.loads(str(file.attrs.get("versions", "{}"))).get("flexbearing", "of unknown version")
        older = f"; {OLDER[number]}" if number in OLDER else ""
        raise BadResult(
            f"{path}: this file has format {number}, written by flexbearing {writer}{older}. This version "
            f"reads format {FORMAT}: run the case again, or read the file with the version that wrote it."
        )


def _result(file: h5py.File, path: Path, families: Families) -> Result:
    kind = str(file.attrs.get("kind"))
    if kind not in families:
        raise BadResult(f"{path}: kind {kind!r} is none of {', '.join(families)}. Run the case again.")
    layout: Layout = families[kind].layout()
    sizes: Sizes = {}
    blocks: dict[str, Arrays] = {"rigid": _NOTHING, "flexible": _NOTHING}
    for name in layout.blocks + layout.further_blocks:
        blocks[name], sizes = _arrays(file.get(name), layout.datasets("block"), sizes, name)
    iterations = _iterations(file, layout.datasets("iteration"), sizes)
    require_same_names(dict(file.attrs), layout.attributes, "root attributes")
    attributes = MappingProxyType(
        {name: decoded(layout.attributes[name].kind, stored) for name, stored in file.attrs.items()}
    )
    return Result(path=path, attributes=attributes, iterations=iterations, family=families[kind], **blocks)


def _iterations(file: h5py.File, known: Mapping[str, Quantity], sizes: Sizes) -> tuple[Arrays, ...]:
    if "iterations" not in file:
        return ()
    rows = {name: replace(entry, axes=f"iteration {entry.axes}") for name, entry in known.items()}
    arrays, sizes = _arrays(file["iterations"], rows, sizes, "iterations")
    return tuple(
        MappingProxyType({name: array[number, ...] for name, array in arrays.items()})
        for number in range(sizes["iteration"])
    )


def _arrays(group: Any, known: Mapping[str, Quantity], sizes: Sizes, where: str) -> tuple[Arrays, Sizes]:
    if group is None:
        return _NOTHING, sizes
    arrays, stored = {}, dict(group)
    require_same_names(stored, known, where)
    for name, entry in known.items():
        if name not in stored:  # it is optional
            continue
        array = np.asarray(stored[name][()])
        array.flags.writeable = False
        sizes = fitted(entry, array, sizes, where)
        arrays[name] = array
    return MappingProxyType(arrays), sizes
