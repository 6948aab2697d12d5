"""What Python programs call for a study; nothing is loaded before."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flexbearing.case import Head
    from flexbearing.studies.file.read import Source
    from flexbearing.studies.prepared_study import Progress
    from flexbearing.studies.table import Table


def study(  # noqa: PLR0913  # an argument for each option
    source: "Source",
    output: str | Path = "results",
    *,
    jobs: int | None = None,
    scheduler: str | None = None,
    slurm: str | Path | None = None,
    tls: Sequence[str | Path] = (),
    retry_failed: bool = False,
    tell: "Callable[[Progress], None]" = lambda progress: None,
) -> "Table":
    """Compute the variants of a study.

    Rows that a former call with the same folder finished are taken from there.

    Parameters
    ----------
    source : path or mapping
        study file, or the same as a dictionary: {"case": "x.toml", "over": {...}}; its case may be a
        `flexbearing.Case`
    output : path
        folder of the table and of what is finished so far
    jobs : int, optional
        processes that compute, a core each; 1 is this one alone. Without it as many as there are cores, where
        the study is long enough to be worth it
    scheduler : str, optional
        address of a running Dask scheduler that computes instead, tls://HOST:PORT or tcp://HOST:PORT
    slurm : path, optional
        profile of a SLURM cluster whose jobs compute instead
    tls : sequence of path, optional
        for both, PEM files of the authority, of a certificate that it signed, and of its key
    retry_failed : bool
        whether rows that failed are computed again
    tell : callable (Progress), optional
        hears of every task that is finished

    Returns
    -------
    Table
        also with rows that failed: their status says how

    Raises
    ------
    BadCase
        for a wrong study file, variants that cannot be computed, or what is missing for several jobs; nothing
        is computed then
    BadOutput
        for a folder that cannot be written, an output that is read or where the same study runs already
    NotStored
        when there is no room left; what is finished stays

    >>> table = study("thickness.toml")                                      # doctest: +SKIP
    >>> table["life [h]"].values                                             # doctest: +SKIP
    """
    from flexbearing.program.threads import limited_to
    from flexbearing.studies.placement import Placement
    from flexbearing.studies.prepare import compute, prepare_source

    placement = Placement(jobs, scheduler, None if slurm is None else Path(slurm), tuple(map(Path, tls)))
    with limited_to(jobs):
        prepared = prepare_source(source, case=_case(source))
    return compute(prepared, Path(output), placement, retry_failed=retry_failed, tell=tell)


def _case(source: "Source") -> "Head | None":
    """What a `flexbearing.Case` of a dictionary holds; None of a path."""
    return None if isinstance(source, str | Path) else getattr(source.get("case"), "head", None)
