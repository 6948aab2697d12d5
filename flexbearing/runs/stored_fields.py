"""Fields of a stored state: from a result file to its case, its rings, and files for ParaView."""

from __future__ import annotations

import re
from os.path import exists  # Path.exists raises for names that no file can have
from pathlib import Path

from flexbearing.case import BadCase, understood
from flexbearing.case.head import Head
from flexbearing.case.roller import Case
from flexbearing.files import require_folder, require_outputs, write as store
from flexbearing.results import BadResult, Result
from flexbearing.runs import fields
from flexbearing.runs.fields import Arrays
from flexbearing.runs.part_fields import NAMES, PartFields, Race


def case_of(result: Result) -> Case:
    """The case that a result file holds; its drawing is looked for next to the case, then beside the result.

    Raises `BadCase` if it cannot be read, or is about balls, whose rings are rigid, or known at the balls
    only.
    """
    case = _understood(result, Path(result.attributes.get("case_file") or result.place))
    drawing = case.drawing if isinstance(case, Case) else None
    # carried elsewhere, the drawing may have come along
    if result.path and drawing and not exists(drawing):  # noqa: PTH110
        case = _understood(result, result.path)
    if not isinstance(case, Case):
        raise BadCase(
            f'{result.place}: rings have fields in roller bearings only; this case has kind = "{case.kind}"'
        )
    return case


def _understood(result: Result, file: Path) -> Head:
    """The case in a result, as if it stood in a file."""
    attributes = result.attributes
    try:
        return understood(
            attributes["case_text"], file, attributes["case_overrides"], {result.kind: result.family}
        )
    except BadCase as problem:
        first, *_ = str(problem).splitlines()
        raise BadCase(f"{result.place}: the case in it cannot be read: {first}") from problem


def state_of(result: Result, name: str) -> Arrays:
    """Arrays of a stored state.

    Raises `BadResult` if there is no such state.
    """
    count = len(result.iterations)
    iteration = re.fullmatch(r"iteration ([1-9][0-9]{0,8})", name)
    if iteration and int(iteration[1]) <= count:
        return result.iterations[int(iteration[1]) - 1]
    blocks = {"rigid": result.rigid, "flexible": result.flexible}
    if blocks.get(name):
        return blocks[name]
    there = [block for block, values in blocks.items() if values]
    there += [f"iteration 1 to iteration {count}"] if count else []
    raise BadResult(f"{result.place}: there is no state {name!r}; there are: {', '.join(there) or 'none'}.")


def of_result(result: Result, state: str = "flexible", race: Race | None = None) -> list[PartFields]:
    """Fields of the flexible parts of a result."""
    case, values = case_of(result), state_of(result, state)
    return [fields.fields(case, name, state, values) for name in _races(result, case, race)]


def destinations(
    result: Result, directory: Path, state: str = "flexible", race: Race | None = None
) -> dict[Race, Path]:
    """Settle where the fields go, named after result, part and state, before anything is computed."""
    case = case_of(result)
    state_of(result, state)
    races, folder = _races(result, case, race), require_folder(directory)
    paths: dict[Race, Path] = {
        name: folder / f"{result.stem}_{name}_{state.replace(' ', '_')}.vtu" for name in races
    }
    require_outputs(paths.values(), result.files)
    return paths


def _races(result: Result, case: Case, race: Race | None) -> list[Race]:
    """Raceways of the flexible parts, or the one that is requested."""
    for block in filter(None, (result.rigid, result.flexible)):
        rollers = block["roller_azimuth"].size
        if rollers != case.bearing.all_rollers:
            raise BadResult(
                f"{result.place}: {rollers} rollers in its arrays, {case.bearing.all_rollers} in its case; "
                "run the case again."
            )
    flexible = fields.parts(case)
    races: list[Race] = [race] if race else list(flexible)
    if not races or any(name not in flexible for name in races):
        what = NAMES[race] if race else "every part"
        raise BadCase(f"{result.place}: {what} is rigid in this case: it has no displacements and stresses")
    return races


def write(part: PartFields, path: Path) -> None:
    """Write fields for ParaView."""
    from fem.solid.vtu import vtu

    store(path.resolve(), vtu(part.loaded.displacement, part.part.materials))
