"""A study file, settled and computed with the bearings of this program."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

from flexbearing.cache import Cache, configured
from flexbearing.case import BadCase, Head
from flexbearing.case.roller import Case
from flexbearing.case.variants import Variants
from flexbearing.families import FAMILIES
from flexbearing.files import require_folder_name
from flexbearing.printable import excerpt
from flexbearing.program.threads import limited_to
from flexbearing.program.workers import shared_map
from flexbearing.studies.file import Study, read
from flexbearing.studies.file.read import Source
from flexbearing.studies.placement import Placement
from flexbearing.studies.plan import Impossible, Plan, Variant, plan
from flexbearing.studies.plan.identity import identity
from flexbearing.studies.plan.task import Base, Values
from flexbearing.studies.prepared_study import Prepared, variants_of
from flexbearing.studies.run import Tell, Work, run
from flexbearing.studies.scatter import told_of_scatter
from flexbearing.studies.table import Table, duty
from flexbearing.studies.table.collected import collected, estimated, require_outputs, with_errors
from flexbearing.studies.table.drawn import drawn

FOLDER, HERE = Path("results"), Placement()
TellChecked = Callable[[int, int], None]
LONGEST = 500  # characters of what is wrong with a variant


def prepared(
    source: Source, tell: TellChecked = lambda done, total: None, case: Head | None = None
) -> Prepared:
    """Read a study, from its file or as a dictionary, and settle what it computes.

    Raises
    ------
    BadCase
        one line for each problem of the study file, or of the case that its variants are made of
    """
    return settle(read(source, FAMILIES, case), tell, bounded=True)


def settle(study: Study, tell: TellChecked = lambda done, total: None, *, bounded: bool = False) -> Prepared:
    """Settle what a study computes, see `prepared`; `bounded`: a duty cycle may have idle and thin rows."""
    family = FAMILIES[study.kind]
    lives = duty.texts(study.spectrum).values() if study.spectrum else ()
    require_outputs(study, lives, "duty", FAMILIES)
    drawn(study, collected(study, FAMILIES, elastic=True, rollers=1), FAMILIES)  # names that none has
    with shared_map() as mapped:
        checked = partial(_checked, cycle=bounded and study.spectrum is not None)
        settled = plan(study, checked, mapped, tell)
    if study.spectrum and study.spectrum.measure == "revolutions":
        _require_turning(study, settled)
    elastic, first = any(variant.rings for variant in settled.variants), _first(settled)
    settled = replace(settled, side_by_side=not study.full and _is_side_by_side(first))
    rollers = 0 if "bearing.rollers" in settled.base.keys else _rollers(first)
    columns = collected(study, FAMILIES, elastic=elastic, rollers=rollers)
    plot, columns = drawn(study, columns, FAMILIES)
    if not settled.corners:
        return Prepared(study, settled, columns, plot)
    layout = family.layout()
    return Prepared(study, settled, with_errors(columns, layout), plot, estimated(lives, layout))


def _require_turning(study: Study, settled: Plan) -> None:
    """Refuse a share of the revolutions of a row at standstill."""
    assert study.spectrum
    for number, variant in enumerate(settled.variants):
        row = number % len(study.spectrum.shares)
        if variant.idle and not variant.idle.speed and study.spectrum.shares[row]:
            raise BadCase(
                f"{study.path.name}: [duty] row {row + 1} is at standstill and has a share of the "
                "revolutions; give shares of the time"
            )


def _checked(base: Base, rows: Sequence[Values], *, cycle: bool) -> list[Variant | Impossible]:
    """Variants with some values of the keys each, or why there is no such case."""
    read = variants_of(base)
    return [_variant(read, values, cycle=cycle) for values in rows]


def _variant(read: Variants, values: Values, *, cycle: bool) -> Variant | Impossible:
    from flexbearing.runs.validate import require_possible
    from flexbearing.studies.idle import idle
    from flexbearing.studies.rings import levels, rings
    from flexbearing.studies.thin_oil import too_thin

    if cycle and (found := idle(read, values)):
        return found
    try:
        case = read.case(values)
        require_possible(case, FAMILIES[case.kind])
    except BadCase as problem:
        return Impossible(excerpt("; ".join(str(problem).splitlines()), LONGEST))
    thin = too_thin(case) if cycle else ""
    return Variant(values, identity(case), rings(case), levels(case), read.in_si(case), thin=thin)


def _first(settled: Plan) -> Head | None:
    """The first case that can be computed."""
    for variant in settled.variants:
        if variant.identity and not variant.idle:
            return variants_of(settled.base).known(variant.values, variant.in_si)
    return None


def _rollers(case: Head | None) -> int:
    """How many rollers a case has."""
    return getattr(getattr(case, "bearing", None), "rollers", 0)


def _is_side_by_side(case: Head | None) -> bool:
    """Whether cases like this one are solved together."""
    from flexbearing.runs.side_by_side import needs_own_run

    if not isinstance(case, Case) or needs_own_run(case):
        return False
    # A roller on half-spaces or a field below takes as long as a run, however many states are side by side.
    return case.bearing.contact == "slices" and not case.outputs.subsurface_stresses


def compute(
    settled: Prepared,
    output: Path = FOLDER,
    where: Placement = HERE,
    *,
    retry_failed: bool = False,
    tell: Tell = lambda progress: None,
) -> Table:
    """Compute the variants of a study.

    Raises
    ------
    BadCase
        for variants that cannot be computed; nothing is computed then
    BadOutput, NotStored
        as for `flexbearing.studies.run.run`
    """
    from flexbearing.studies.worker import RowRequest, condense, rows

    settled.plan.require_sound()
    if where.slurm:
        settled = replace(settled, study=settled.study.reading(where.slurm))
    folder, name = require_folder_name(output), settled.study.name
    cache = str(folder / f"{name}.rings") if configured().folder is None else None
    study = settled.study
    wish = RowRequest(
        settled.outputs, study.search, settled.files(folder), study.final, study.spectrum is not None
    )
    work = Work(partial(rows, wish=wish, cache=cache), partial(condense, cache=cache))
    with limited_to(where.jobs):
        table = run(settled, output, work, where.engine(settled.plan), retry_failed=retry_failed, tell=tell)
    if settled.study.drawn and not settled.part:
        table = told_of_scatter(settled, table, folder)
    if cache is not None and settled.part is None:
        _without_rings(Path(cache))
    return table


def _without_rings(folder: Path) -> None:
    """Remove the rings of a study, and their folder where it holds nothing else."""
    Cache(folder).clear()
    with suppress(OSError):  # there are other files in it, or it was never made
        folder.rmdir()
