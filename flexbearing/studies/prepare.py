"""A study file, settled and computed with the bearings of this program."""

from pathlib import Path

from flexbearing.families import FAMILIES
from flexbearing.studies.engine.serial import Serial
from flexbearing.studies.file import read
from flexbearing.studies.plan import plan
from flexbearing.studies.run import Prepared, Tell, run
from flexbearing.studies.table import Table
from flexbearing.studies.table.collected import collected

FOLDER = Path("results")


def prepared(file: str | Path) -> Prepared:
    """Read a study and settle what it computes.

    Parameters
    ----------
    file : path
        study file

    Returns
    -------
    Prepared
        also with variants that cannot be computed: `Plan.require_sound` refuses them

    Raises
    ------
    BadCase
        one line for each problem of the study file, or of the case that its variants are made of
    """
    from flexbearing.runs.validate import require_possible
    from flexbearing.studies.rings import rings

    study = read(file, FAMILIES)
    family = FAMILIES[study.kind]
    settled = plan(study, FAMILIES, lambda case: require_possible(case, family), rings)
    elastic = any(variant.rings for variant in settled.variants)
    return Prepared(study, settled, collected(study, FAMILIES, elastic=elastic))


def compute(
    settled: Prepared, output: Path = FOLDER, *, retry_failed: bool = False, tell: Tell | None = None
) -> Table:
    """Compute the variants of a study.

    Parameters
    ----------
    settled : Prepared
        the study
    output : Path
        folder of the table and of what is finished
    retry_failed : bool
        whether rows that failed are computed again
    tell : callable (Progress), optional
        hears of every task that is finished

    Returns
    -------
    Table

    Raises
    ------
    BadCase
        for variants that cannot be computed; nothing is computed then
    BadOutput, NotStored
        as for `flexbearing.studies.run.run`
    """
    from flexbearing.studies.worker import rows

    settled.plan.require_sound()
    return run(settled, output, rows, Serial(), retry_failed=retry_failed, tell=tell)
