"""Reports as one HTML file each, which opens without a network and prints; loaded when requested."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flexbearing.report.html.result import of_result as of_result
    from flexbearing.report.html.study import of_study as of_study
    from flexbearing.report.html.units import (
        IMPERIAL as IMPERIAL,
        METRIC as METRIC,
        SYSTEMS as SYSTEMS,
        Units as Units,
    )
    from flexbearing.report.html.write import html as html

EXPORTS = {"of_result": "result", "of_study": "study", "html": "write"}
EXPORTS |= dict.fromkeys(("IMPERIAL", "METRIC", "SYSTEMS", "Units"), "units")


def __getattr__(name: str) -> Any:
    """Load a public name with its module: the card of a result needs none of them."""
    if name not in EXPORTS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{EXPORTS[name]}"), name)
