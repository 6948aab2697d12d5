"""The command `limits`; what it does not need is not loaded."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from flexbearing.program.commands import CaseFile, Settings, end, keeping, say

if TYPE_CHECKING:
    from flexbearing.limits.curves import LimitCurves
    from quasidynamic.outcome.limiting_load import StaticLimits

COLUMNS = ("radial_load [kN]", "axial_load [kN]", "moment [kN m]", "sense of the moment", "limited by")


def limits(  # noqa: PLR0913  # an argument for each option
    case: CaseFile,
    radial: Annotated[
        str, typer.Option("--radial", metavar="LOAD,...", help="radial loads, a curve for each")
    ] = "0 kN",
    points: Annotated[
        int, typer.Option("--points", min=3, max=1000, help="of each curve at least; more where it bends")
    ] = 13,
    safety: Annotated[
        float, typer.Option("--safety", min=0.1, max=100, help="static safety against 4200 MPa (ISO 76)")
    ] = 1.0,
    case_depth: Annotated[
        str | None,
        typer.Option("--case-depth", metavar="DEPTH", help="of the hardened case, with --core-yield"),
    ] = None,
    core_yield: Annotated[
        str | None,
        typer.Option("--core-yield", metavar="STRESS", help="yield stress of the core below --case-depth"),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", "--output", metavar="FILE", help="picture (.png, .svg, .pdf), beside it a table"),
    ] = None,
    settings: Settings = None,
) -> None:
    """Compute the static loads that a four-point bearing just bears, axial load against moment."""
    from flexbearing import api
    from flexbearing.case import BadCase
    from flexbearing.case.balls.four_point import FourPointCase
    from flexbearing.files import require_outputs
    from flexbearing.report.picture import form_of
    from flexbearing.runs.run_case import stem_of_outputs

    wanted = api.read_case(case, settings or [])
    if not isinstance(wanted, FourPointCase):
        raise BadCase(f'{case}: kind = "{wanted.kind}": limiting loads are those of kind = "four_point_ball"')
    loads, borne = _loads(radial), _limits(safety, case_depth, core_yield)
    picture = output or Path("results") / f"{stem_of_outputs(case, settings or ())}_limits.png"
    form, table = form_of(picture), picture.with_suffix(".csv")
    require_outputs((picture, table), wanted.input_files)
    found = _computed(wanted, loads, points, borne)
    _write(found, picture, table, form)
    with keeping([picture, table]):
        say(f"{_words(found)}\ntable: {table}\npicture: {picture}")


def _loads(radial: str) -> tuple[float, ...]:
    """Radial loads [N] of a list in words."""
    from flexbearing.case.quantity import Force

    loads = tuple(_si("--radial", each, Force) for each in radial.split(","))
    if min(loads) < 0:
        from flexbearing.case import BadCase

        raise BadCase(f"--radial {radial}: a radial load is not negative; the moment is taken in both senses")
    return loads


def _limits(safety: float, case_depth: str | None, core_yield: str | None) -> "StaticLimits":
    from flexbearing.case import BadCase
    from flexbearing.case.quantity import Length, Pressure
    from quasidynamic.outcome.limiting_load import StaticLimits

    if case_depth is None and core_yield is None:
        return StaticLimits(safety=safety)
    if case_depth is None or core_yield is None:
        raise BadCase("--case-depth and --core-yield: the core is judged by both; give the other one, too")
    depth, stress = _si("--case-depth", case_depth, Length), _si("--core-yield", core_yield, Pressure)
    if depth <= 0 or stress <= 0:
        raise BadCase("--case-depth and --core-yield are above zero")
    return StaticLimits(safety=safety, case_depth=depth, core_yield=stress)


def _si(option: str, text: str, kind: Any) -> float:
    """A quantity of an option in SI units."""
    from pydantic import TypeAdapter, ValidationError

    from flexbearing.case import BadCase

    try:
        return float(TypeAdapter(kind).validate_python(text.strip()))
    except ValidationError as problem:
        raise BadCase(f"{option} {text}: {problem.errors()[0]['msg']}") from None


def _computed(case: object, loads: tuple[float, ...], points: int, borne: "StaticLimits") -> "LimitCurves":
    from flexbearing.case.balls.four_point import FourPointCase
    from flexbearing.limits.curves import limit_curves
    from flexbearing.progress import shown
    from quasidynamic import NotSolved

    assert isinstance(case, FourPointCase)  # checked before
    try:
        with shown("limits") as report:
            return limit_curves(case, loads, points, borne, report)
    except NotSolved as problem:
        end(f"{case.source.path}: not converged: {problem}")


def _write(found: "LimitCurves", picture: Path, table: Path, form: str) -> None:
    from flexbearing.files import as_csv, write
    from flexbearing.limits.picture import drawn
    from flexbearing.report.picture import Format, picture_bytes

    write(table.resolve(), as_csv([COLUMNS, *found.rows()]).encode())
    with keeping([table], "the table is complete"):
        write(picture.resolve(), picture_bytes(drawn(found), Format(form)))


def _words(found: "LimitCurves") -> str:
    """Both ends of each curve."""
    lines = [f"{found.title}: limiting static loads, static safety {found.limits.safety:g}"]
    for curve in found.points:
        first, last = curve[0], curve[-1]
        lines.append(
            f"  radial load {first.radial / 1e3:,.4g} kN: axial load {first.axial / 1e3:,.4g} kN "
            f"({first.limited_by}), moment {last.moment / 1e3:,.4g} kN m ({last.limited_by})"
        )
    return "\n".join(lines)
