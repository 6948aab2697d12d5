"""Displacements and stresses of flexible rings for ParaView."""

import sys
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from flexbearing.case import BadCase
from flexbearing.results import Result


def export(
    result: Result, directory: Path, part: str | None = None, state: str = "flexible"
) -> Iterator[Path]:
    """Compute the fields of a stored state, print their largest stresses and write them.

    Raises `BadCase`, `BadResult` if no such part is flexible, or there is no such state; `NoFields` if a part
    has no solid, or it could not be solved; `BadOutput`, `NotStored` if a file cannot be written.
    """
    from flexbearing.report.html.reader import Reader
    from flexbearing.report.html.units import METRIC
    from flexbearing.report.output import laid_out
    from flexbearing.report.page import solids
    from flexbearing.runs import stored_fields as compute

    if part not in ("inner", "outer", None):
        raise BadCase(f'part {part}: it is "inner" or "outer"')
    paths = compute.destinations(result, directory, state, part)
    solved = compute.of_result(result, state, part)
    stresses = {one.race: one.record() for one in solved}
    reader = Reader(replace(result, attributes={**result.attributes, "stresses": stresses}), METRIC)
    sys.stdout.write(laid_out(solids(reader), encoding=sys.stdout.encoding))
    for one in solved:
        compute.write(one, paths[one.race])
        yield paths[one.race]
