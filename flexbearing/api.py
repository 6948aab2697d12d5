"""What Python programs call: run, read, check, drawings, explain.

Every function binds the registered bearing families to a room below; what a call does not need is not loaded.
"""

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flexbearing.accuracy.shared import Levels
    from flexbearing.derivatives.table import Sensitivities
    from flexbearing.progress import Report
    from flexbearing.report.drawing import Drawing
    from flexbearing.results import Others, Result

Overrides = Sequence[str] | Mapping[str, object]


def read_case(case: str | Path, overrides: Overrides = ()) -> Any:
    """Read a case file into the case model of its family, in SI units, with overrides as for `run`.

    Raises `BadCase`, one line for each problem: file, key, value found, what is allowed, nearest valid name.
    """
    from flexbearing.case import read as read_case
    from flexbearing.families import FAMILIES

    return read_case(case, overrides, FAMILIES)


def check(case: str | Path, overrides: Overrides = ()) -> Any:
    """Read a case as `read_case` does, and build everything that needs no mesh.

    Raises `BadCase` where the file is wrong, or physics or geometry forbid the case.
    """
    from flexbearing.families import FAMILIES
    from flexbearing.runs.validate import require_drawing, require_possible

    wanted = read_case(case, overrides)
    require_possible(wanted, FAMILIES[wanted.kind])
    require_drawing(wanted)
    return wanted


def run(
    case: str | Path,
    overrides: Overrides = (),
    *,
    output: str | Path | None = None,
    report: "Report | None" = None,
    start: "str | Path | Result | None" = None,
) -> "Result":
    """Compute a case file.

    Parameters
    ----------
    case : path
        case file
    overrides : sequence of str or mapping
        settings that replace or add keys: "bearing.clearance=50 um", or {"bearing.clearance": "50 um"}
    output : path, optional
        result file; without one nothing is written
    report : Report, optional
        is called with stages and iterations; default is the log
    start : path or Result, optional
        of a neighbouring case, at whose flexible end state newton begins; by default between rigid raceways

    Returns
    -------
    Result
        also when the iteration did not converge: `result.attributes["status"]` says so

    Raises
    ------
    BadCase
        when the case cannot be computed as it stands, or cannot start there
    BadResult
        when there is no complete result to start from
    BadOutput, NotStored
        when the file cannot be written

    >>> result = run("case.toml", {"operation.radial_load": "15 kN"})  # doctest: +SKIP
    >>> result.flexible["inner_load"].max()                            # doctest: +SKIP
    """
    return compute(read_case(case, overrides), output=output, report=report, start=start)


def compute(
    case: Any,
    *,
    output: str | Path | None = None,
    report: "Report | None" = None,
    start: "str | Path | Result | None" = None,
    levels: "Levels | None" = None,
    others: "Others" = "searched",
) -> "Result":
    """Compute a case that was read before; everything else as for `run`.

    A roller case with a target takes the `levels` that it shares with others, where they are given. `others`
    says what is done about other equilibria: they are "searched", "reported" where they are likely, or "left
    out" of a case whose numbers alone are compared with those of others.
    """
    from flexbearing.families import FAMILIES
    from flexbearing.runs.run_case import compared as solved_to_compare, run_case

    if others == "left out":
        return solved_to_compare(case, FAMILIES[case.kind])
    near = read(start) if isinstance(start, str | Path) else start
    return run_case(case, FAMILIES[case.kind], output, report, near, levels, others)


def against_catalogue(case: str | Path, overrides: Overrides = ()) -> dict[str, Any]:
    """Compare the life of a bearing with that of a catalogue, factor by factor.

    Parameters
    ----------
    case : path
        case file
    overrides : sequence of str or mapping
        as for `run`

    Returns
    -------
    dict
        "ratings" (C_r, C_0r, C_u, static safety, rating life) and "stages", each a life with its name, the
        settings that give it, and its factor over the life before

    Raises
    ------
    BadCase
        as `run`; and without a load, where a case in between has no solution, and for a kind without ratings
    """
    from flexbearing.case import BadCase
    from flexbearing.case.read import written
    from flexbearing.families import FAMILIES
    from flexbearing.life.against_catalogue import against_catalogue as compared

    given = written(overrides) if isinstance(overrides, Mapping) else tuple(overrides)
    wanted = check(case, given)
    catalogue = FAMILIES[wanted.kind].catalogue
    if catalogue is None:
        raise BadCase(
            f'{case}: kind = "{wanted.kind}" has no radial ratings in ISO 281, so no life is compared.'
        )
    solved = partial(compute, others="left out")
    return compared(wanted, catalogue(), lambda further: read_case(case, [*given, *further]), solved)


def sensitivities(
    case: Any, of: Sequence[str] = (), by: Sequence[str] = (), report: "Report | None" = None
) -> "Sensitivities":
    """Differentiate outputs of a case of `read_case` by its keys, at its equilibrium, in the units of both.

    Outputs have units if others than those of the summary are wanted; they may be "life" or "all", and by
    default are the main ones. Keys are by default all continuous ones that the case states. `report` is
    called with what is computed; the log, unless given.
    Raises `BadCase` for keys that hold no continuous value, and cases without derivatives; `UnknownOutput`
    and `WrongUnit` for texts that name no output; `NotSolved` where there is no equilibrium.
    """
    from flexbearing.derivatives.sensitivities import sensitivities as differentiated
    from flexbearing.families import FAMILIES

    return differentiated(case, FAMILIES[case.kind], of, by, report)


def drawings(case: Any, *, values: bool = True) -> "list[Drawing]":
    """Draw what a case of `read_case` describes, to scale, with or without values beside the keys.

    Nothing is solved.
    Raises `BadCase` where points of a profile cannot be read or are none of its roller.
    """
    from flexbearing.families import FAMILIES
    from flexbearing.report.drawing.of_case import drawings as drawn

    return list(drawn(FAMILIES[case.kind], case, values=values))


def read(path: str | Path) -> "Result":
    """Read a complete result file.

    Parameters
    ----------
    path : path
        as `run` wrote it

    Raises
    ------
    BadResult
        naming the file and what to do, when it is missing, unfinished, damaged or of another format
    """
    from flexbearing.families import FAMILIES
    from flexbearing.results import read as read_file

    return read_file(path, FAMILIES)


def explain(key: str | None = None) -> str:
    """Explain a key of the case file, a table, or all of them.

    Parameters
    ----------
    key : str, optional
        dotted; without it every key is listed

    Returns
    -------
    str
        lines of text

    Raises
    ------
    BadCase
        for an unknown key, naming the nearest one
    """
    from flexbearing.case.explain import explain as explained
    from flexbearing.families import FAMILIES

    return explained(key, FAMILIES)
