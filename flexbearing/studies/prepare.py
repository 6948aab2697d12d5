"""A study file, prepared and computed with the bearings of this program."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path

from flexbearing.cache import Cache, configured
from flexbearing.case import BadCase, Head
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.roller import Case
from flexbearing.case.variants import Variants
from flexbearing.families import FAMILIES
from flexbearing.files import require_folder_name
from flexbearing.printable import one_line
from flexbearing.program.shared_map import shared_map
from flexbearing.program.threads import limited_to
from flexbearing.studies.file import Study, read
from flexbearing.studies.file.read import Source
from flexbearing.studies.placement import Placement
from flexbearing.studies.plan import Impossible, Plan, Variant, plan
from flexbearing.studies.plan.task import Base, Values, identity
from flexbearing.studies.prepared_study import PreparedStudy, variants_of
from flexbearing.studies.run import Tell, Work, run
from flexbearing.studies.scatter import add_scatter
from flexbearing.studies.table import Table, duty
from flexbearing.studies.table.collected import collected, estimated, require_outputs, with_errors
from flexbearing.studies.table.drawn import drawn

FOLDER, HERE = Path("results"), Placement()
TellChecked = Callable[[int, int], None]


def prepare_source(
    source: Source, tell: TellChecked = lambda done, total: None, case: Head | None = None
) -> PreparedStudy:
    """Read a study, from its file or as a dictionary, and prepare what it computes.

    Raises `BadCase` one line for each problem of the study file, or of the case that its variants are made
    of.
    """
    return prepare(read(source, FAMILIES, case), tell, bounded=True)


def prepare(
    study: Study, tell: TellChecked = lambda done, total: None, *, bounded: bool = False
) -> PreparedStudy:
    """What a study computes, see `prepare_source`; `bounded`: a duty cycle may have idle and thin rows."""
    family = FAMILIES[study.kind]
    lives = duty.texts(study.spectrum).values() if study.spectrum else ()
    require_outputs(study, lives, "duty", FAMILIES)
    drawn(study, collected(study, FAMILIES, elastic=True, rollers=1), FAMILIES)  # names that none has
    with shared_map() as mapped:
        checked = partial(_checked, cycle=bounded and study.spectrum is not None)
        planned = plan(study, checked, mapped, tell)
    if study.spectrum and study.spectrum.measure == "revolutions":
        _require_turning(study, planned)
    elastic, first = any(variant.rings for variant in planned.variants), _first(planned)
    if study.spectrum and study.spectrum.life == "modified_life":
        _require_modified(study, planned, first)
    planned = replace(
        planned, side_by_side=not study.full and _is_side_by_side(first), in_cells=_is_in_cells(first)
    )
    rollers = 0 if "bearing.rollers" in planned.base.keys else _rollers(first)
    columns = collected(study, FAMILIES, elastic=elastic, rollers=rollers)
    plot, columns = drawn(study, columns, FAMILIES)
    if not planned.corners:
        return PreparedStudy(study, planned, columns, plot)
    layout = family.layout()
    return PreparedStudy(study, planned, with_errors(columns, layout), plot, estimated(lives, layout))


def _require_turning(study: Study, planned: Plan) -> None:
    """Refuse a share of the revolutions of a row at standstill."""
    assert study.spectrum
    for number, variant in enumerate(planned.variants):
        row = number % len(study.spectrum.shares)
        if variant.idle and not variant.idle.speed and study.spectrum.shares[row]:
            raise BadCase(
                f"{study.path.name}: [duty] row {row + 1} is at standstill and has a share of the "
                "revolutions; give shares of the time"
            )


def _require_modified(study: Study, planned: Plan, case: Head | None) -> None:
    """Refuse the modified life of cases whose life nothing modifies."""
    life = getattr(case, "life", None)
    if life and life.is_basic and not any(key.startswith("life.") for key in planned.base.keys):
        raise BadCase(
            f'{study.path.name}: [duty] life = "modified_life": nothing modifies the life of the case; '
            'give [life] lubrication or reliability, or life = "life_L10"'
        )


def _checked(base: Base, rows: Sequence[Values], *, cycle: bool) -> list[Variant | Impossible]:
    """Variants with some values of the keys each, or why there is no such case."""
    read = variants_of(base)
    return [_variant(read, values, cycle=cycle) for values in rows]


def _variant(read: Variants, values: Values, *, cycle: bool) -> Variant | Impossible:
    from flexbearing.runs.validate import require_possible
    from flexbearing.studies.idle import idle, too_thin
    from flexbearing.studies.rings import levels, rings

    without_load: BadCase | None = None
    try:
        if cycle and (found := idle(read, values)):
            return found
    except BadCase as problem:
        without_load = problem  # once this is repaired, the row may be time without damage
    try:
        case = read.case(values)
        require_possible(case, FAMILIES[case.kind])
    except BadCase as problem:
        return Impossible(one_line(without_load or problem))
    thin = too_thin(case) if cycle else ""
    return Variant(values, identity(case), rings(case), levels(case), read.in_si(case), thin=thin)


def _first(planned: Plan) -> Head | None:
    """The first case that can be computed."""
    for variant in planned.variants:
        if variant.identity and not variant.idle:
            return variants_of(planned.base).known(variant.values, variant.in_si)
    return None


def _rollers(case: Head | None) -> int:
    """How many rollers a case has, in all rows."""
    return getattr(getattr(case, "bearing", None), "all_rollers", 0)


def _is_side_by_side(case: Head | None) -> bool:
    """Whether cases like this one are solved together."""
    from flexbearing.runs.side_by_side import needs_own_run

    if not isinstance(case, Case) or needs_own_run(case):
        return False
    # Half-spaces, fields below and probes take as long as a run, however many states are side by side.
    fields = case.outputs.subsurface_stresses or case.outputs.probes is not None
    return case.bearing.contact == "slices" and not fields


def _is_in_cells(case: Head | None) -> bool:
    """Whether contacts of cases like this one are divided into cells, or their friction is in the balance."""
    if isinstance(case, FastCase):
        return case.operation.by_friction or case.friction.model != "full_sliding"
    if isinstance(case, Case):
        return case.bearing.contact == "half_space"
    return isinstance(case, FourPointCase) and case.bearing.balls is not None


def compute(
    prepared: PreparedStudy,
    output: Path = FOLDER,
    placement: Placement = HERE,
    *,
    retry_failed: bool = False,
    tell: Tell = lambda progress: None,
) -> Table:
    """Compute the variants of a study.

    Raises `BadCase` for variants that cannot be computed; nothing is computed then; `BadOutput`, `NotStored`
    as for `flexbearing.studies.run.run`.
    """
    from flexbearing.studies.worker import RowRequest, condense, rows

    prepared.plan.require_sound()
    if placement.slurm:
        prepared = replace(prepared, study=prepared.study.reading(placement.slurm))
    folder, name = require_folder_name(output), prepared.study.name
    cache = str(folder / f"{name}.rings") if configured().folder is None else None
    study = prepared.study
    request = RowRequest(
        prepared.outputs, study.search, prepared.files(folder), study.final, study.spectrum is not None
    )
    work = Work(partial(rows, request=request, cache=cache), partial(condense, cache=cache))
    with limited_to(placement.jobs):
        engine = placement.engine(prepared.plan)
        table = run(prepared, output, work, engine, retry_failed=retry_failed, tell=tell)
    if prepared.study.drawn and not prepared.part:
        table = add_scatter(prepared, table, folder)
    if cache is not None and prepared.part is None:
        _without_rings(Path(cache))
    return table


def _without_rings(folder: Path) -> None:
    """Remove the rings of a study, and their folder where it holds nothing else."""
    Cache(folder).clear()
    with suppress(OSError):  # there are other files in it, or it was never made
        folder.rmdir()
