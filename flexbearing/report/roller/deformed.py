"""Pictures of the deformed parts of a result."""

from collections.abc import Iterator
from pathlib import Path

from flexbearing.report.roller.deformed_figure import deformed
from flexbearing.results import Result
from flexbearing.runs import fields


def pictures(result: Result, directory: Path) -> Iterator[str]:
    """Draw every flexible part at the flexible end state, as PNG.

    Parameters
    ----------
    result : Result
        what a run left behind
    directory : Path
        where to; it is there

    Yields
    ------
    str
        a line for each part: its file, or why there is none; nothing without flexible parts or end state,
        nor of ball bearings, whose rings are known at the balls only
    """
    if not result.flexible or not result.family.report().deformed:
        return
    case = fields.case_of(result)
    try:
        flexible = fields.parts(case)
    except fields.NoFields as problem:
        yield f"no picture of a deformed part: {problem}"
        return
    for race in flexible:
        try:
            part = fields.fields(case, race, "flexible", result.flexible)
        except fields.NoFields as problem:
            yield f"no picture of a deformed part: {problem}"
        else:
            yield f"picture: {_draw(part, result, directory)}"


def _draw(part: fields.PartFields, result: Result, directory: Path) -> Path:
    from fem.solid.skin import skin  # NGSolve takes a second to load

    limit = max(body.von_mises for body in part.fields.largest().values())
    path = directory / f"{part.race}_deformed.png"
    title = f"{result.attributes['title']}: {fields.NAMES[part.race]}"
    deformed(title, skin(part.fields), limit).savefig(path, dpi=150)
    return path
