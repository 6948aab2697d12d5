"""Rolling bearings with thin, flexible rings: quasi-dynamics coupled with finite elements."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from flexbearing.results import Result

__all__ = ["run"]


def run(
    case: str | Path,
    output: str | Path | None = None,
    overrides: Sequence[str] = (),
    *,
    start: "str | Path | Result | None" = None,
) -> "Result":
    """Compute a case file and return its result; see `flexbearing.runs.run_case.run`.

    >>> result = run("case.toml")                                    # doctest: +SKIP
    >>> result.flexible["inner_load"].max()                          # doctest: +SKIP
    """
    from flexbearing.runs.run_case import run as compute  # loads what computing needs, when it is needed

    return compute(case, output, overrides, start=start)
