"""Pictures of the deformed parts of a result."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from flexbearing.files import require_outputs, write
from flexbearing.report.picture import PNG, Format, picture_bytes
from flexbearing.report.roller.deformed_figure import deformed
from flexbearing.results import Result
from flexbearing.runs import fields, stored_fields
from flexbearing.runs.part_fields import NAMES, NoFields, PartFields, Race

if TYPE_CHECKING:
    from matplotlib.figure import Figure

COLOURED = 0.99  # share of the surface's corners with stresses up to the last colour


def pictures(result: Result, directory: Path, form: Format = PNG) -> Iterator[Path | NoFields]:
    """Draw every flexible part at the flexible end state, in files named after result and part.

    Raises
    ------
    BadOutput
        before anything is solved, if a picture cannot be written
    NotStored
        if there is no room for it
    """
    if not result.flexible or not result.family.report().deformed:
        return
    case = stored_fields.case_of(result)
    try:
        flexible = fields.parts(case)
    except NoFields as problem:
        yield problem
        return
    paths: dict[Race, Path] = {
        race: directory / f"{result.stem}_{race}_deformed.{form.name}" for race in flexible
    }
    require_outputs(paths.values(), result.files)
    for race, path in paths.items():
        try:
            part = fields.fields(case, race, "flexible", result.flexible)
        except NoFields as problem:
            yield problem
        else:
            write(path.resolve(), picture_bytes(_drawn(part, result), form))
            yield path


def _drawn(part: PartFields, result: Result) -> Figure:
    from fem.solid.skin import skin  # NGSolve takes a second to load

    outside = skin(part.loaded)
    limit = float(np.quantile(outside.von_mises, COLOURED))  # sharp edges would leave all else in one colour
    title = f"{result.attributes['title']}: {NAMES[part.race]}"
    return deformed(title, outside, limit)
