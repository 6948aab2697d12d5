"""From a result file to a result, believing nothing that the file says."""

import json
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from flexbearing import inputs
from flexbearing.case.family import Families
from flexbearing.case.text import command
from flexbearing.files import parts_of
from flexbearing.files.atomic import UNFINISHED
from flexbearing.inputs.file import CASE as LARGEST
from flexbearing.quantities import Quantity
from flexbearing.quantities.attributes import FORMAT, OLDER
from flexbearing.quantities.layout import ITERATION, Layout
from flexbearing.results import hdf5_read
from flexbearing.results.attributes import decoded
from flexbearing.results.checks import (
    NotInLayout,
    Sizes,
    fitted,
    require_finite,
    require_same_names,
    require_true_ending,
)
from flexbearing.results.content import ITERATIONS, MEANINGS, Content, Groups, digest, named_axes, scales
from flexbearing.results.result import NOTHING, Arrays, Result

INPUT = ".toml"  # ending of the files that results are computed from


class BadResult(ValueError):
    """A file that is no result file of this format."""


def read(path: str | Path, families: Families) -> Result:
    """Read a result file, or what a run that is at work or was interrupted has stored so far.

    Raises `BadResult` naming the file and what to do, when it is missing, damaged, changed or of another
    format.
    """
    path = Path(path)
    try:
        _require_there(path)
        return of_content(*hdf5_read.content(hdf5_read.stored(path)), path, families)
    except hdf5_read.Foreign as problem:
        raise BadResult(f"{path}: {_other_format(problem)}") from problem
    except BadResult:
        raise
    except inputs.Unreadable as problem:
        raise BadResult(f"{path}: {problem}.") from problem
    except (OSError, MemoryError) as problem:
        raise BadResult(f"{path}: cannot be read: {getattr(problem, 'strerror', problem)}.") from problem
    except ValueError as problem:  # BadContent, NotInLayout, a NUL in the name
        raise BadResult(f"{path}: {str(problem).rstrip('.')}. Run the case again.") from problem


def case_file(path: Path) -> str:
    """Say which case file a result is of, in any format that says so."""
    with suppress(OSError, inputs.Unreadable, hdf5_read.BadContent):
        stated = hdf5_read.attribute(hdf5_read.stored(path), "case_file")
        return stated if isinstance(stated, str) else ""
    return ""


def of_content(content: Content, claimed: str, path: Path, families: Families) -> Result:
    """Check the content of a file against its digest and the layout of its family.

    Raises `NotInLayout` for anything that the layout does not require; `BadResult` for another format,
    another digest or an unknown family.
    """
    stored = dict(content.attributes)
    if digest(content) != claimed:
        raise BadResult(f"{path}: changed after it was written, as its digest shows. Run the case again.")
    kind = stored.get("kind")
    if not isinstance(kind, str) or kind not in families:
        raise BadResult(f"{path}: kind {kind!r} is none of {', '.join(families)}. Run the case again.")
    layout: Layout = families[kind].layout()
    if not isinstance(stored.pop(MEANINGS, None), str):
        raise NotInLayout(f"attribute {MEANINGS} is no text.")
    require_same_names(stored, layout.attributes, "root attributes")
    attributes = {name: decoded(layout.attributes[name], value) for name, value in stored.items()}
    blocks, stacked = _groups(content, layout)
    rows = len(next(iter(stacked.values()), ()))
    require_true_ending(attributes, layout, solved=[name for name in blocks if blocks[name]], iterations=rows)
    if attributes["status"] == "converged":
        for name, block in blocks.items():
            for entry in block:
                require_finite(layout[entry], block[entry], name)
    _require_described(content, layout, {**blocks, ITERATIONS: stacked})
    shown = {"rigid": NOTHING, "flexible": NOTHING, **blocks}
    return Result(
        path=path,
        attributes=MappingProxyType(attributes),
        iterations=tuple(
            MappingProxyType({name: array[number, ...] for name, array in stacked.items()})
            for number in range(rows)
        ),
        family=families[kind],
        rigid=shown["rigid"],
        flexible=shown["flexible"],
    )


def _groups(content: Content, layout: Layout) -> tuple[dict[str, Arrays], Arrays]:
    """Blocks and stacked iterations, of names and shapes that the layout requires."""
    groups: dict[str, dict[str, np.ndarray]] = {}
    for place, array in content.arrays.items():
        group, slash, name = place.partition("/")
        if slash:
            groups.setdefault(group, {})[name] = array
    possible = (*layout.blocks, *layout.further_blocks)
    known = {**dict.fromkeys(possible), ITERATIONS: None}
    require_same_names({**known, **groups}, known, "groups")
    sizes: Sizes = {}
    blocks: dict[str, Arrays] = {}
    for name in possible:
        blocks[name], sizes = _fitted(groups.get(name), layout.datasets("block"), sizes, name)
    datasets = layout.datasets("iteration")
    rows = {name: replace(entry, axes=f"{ITERATION.symbol} {entry.axes}") for name, entry in datasets.items()}
    stacked, sizes = _fitted(groups.get(ITERATIONS), rows, sizes, ITERATIONS)
    return blocks, stacked


def _require_described(content: Content, layout: Layout, groups: Groups) -> None:
    """Raise unless units, axes and scales are those that follow from the layout and the arrays."""
    expected = scales(layout, groups)
    there = {name: array for name, array in content.arrays.items() if "/" not in name}
    require_same_names(there, expected, "axes")
    for name, scale in expected.items():
        if content.units[name] != scale.unit or there[name].tobytes() != scale.values.tobytes():
            raise NotInLayout(f"axis {name} does not have the places of the arrays along it")
    for group, arrays in groups.items():
        for name in arrays:
            place, entry = f"{group}/{name}", layout[name]
            if (content.units[place], content.axes[place]) != (entry.unit, named_axes(layout, group, entry)):
                raise NotInLayout(f"{place} has another unit, or other axes, than the layout requires")


def _fitted(
    arrays: Arrays | None, known: Mapping[str, Quantity], sizes: Sizes, where: str
) -> tuple[Arrays, Sizes]:
    """The arrays of a group in the order of the layout, and the sizes of axes that they settle."""
    if arrays is None:
        return NOTHING, sizes
    require_same_names(arrays, known, where)
    for name, array in arrays.items():
        sizes = fitted(known[name], array, sizes, where)
        if not array.size:
            raise NotInLayout(f"{where}: {name} has shape {array.shape}: nothing is in it")
    return MappingProxyType({name: arrays[name] for name in known if name in arrays}), sizes


def _require_there(path: Path) -> None:
    if path.is_file() and path.suffix != INPUT:
        return
    if path.is_file():
        by = command(inputs.text(path, LARGEST))
        raise BadResult(f"{path}: is no result; run it first: flexbearing {by} {path}")
    if path.exists():
        raise BadResult(f"{path}: is no file; a result is one.")
    if parts := [part for part, *_ in parts_of(path) if part.suffix == UNFINISHED]:
        raise BadResult(
            f"{path}: not there yet, only {parts[0].name} of a run at work or interrupted. "
            "Wait for the run, run the case again, or read that file."
        )
    raise BadResult(f"{path}: no such file. `flexbearing run CASE -o {path.name}` would write it.")


def _other_format(found: hdf5_read.Foreign) -> str:
    if found.number is None:
        return "an HDF5 file, but not a result of flexbearing: it has no format number."
    return _format(found.number, found.versions)


def _format(number: Any, versions: Any) -> str:
    writer = "of unknown version"
    with suppress(ValueError, TypeError, RecursionError, AttributeError):
        writer = json.loads(versions)["flexbearing"] or writer
    older = f"; {OLDER[number]}" if isinstance(number, int) and number in OLDER else ""
    return (
        f"this file has format {number}, written by flexbearing {writer}{older}. This version "
        f"reads format {FORMAT}: run the case again, or read the file with the version that wrote it."
    )
