"""Rolling bearings with thin, flexible rings: quasi-dynamics coupled with finite elements.

Names are loaded when they are first used.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from flexbearing.api import explain as explain, read as read, run as run
    from flexbearing.case import BadCase as BadCase
    from flexbearing.files import BadOutput as BadOutput, NotStored as NotStored
    from flexbearing.notebook import Case as Case, new as new
    from flexbearing.outputs import (
        AbsentOutput as AbsentOutput,
        UnknownOutput as UnknownOutput,
        WrongUnit as WrongUnit,
    )
    from flexbearing.results import BadResult as BadResult
    from flexbearing.studies.study import study as study

    __version__: str

EXPORTS = {
    "api": ("explain", "read", "run"),
    "case": ("BadCase",),
    "files": ("BadOutput", "NotStored"),
    "notebook": ("Case", "new"),
    "outputs": ("AbsentOutput", "UnknownOutput", "WrongUnit"),
    "results": ("BadResult",),
    "studies.study": ("study",),
}


def __getattr__(name: str) -> Any:
    """Load a public name with its module."""
    if name == "__version__":
        from importlib.metadata import version

        return version(__name__)
    for module, names in EXPORTS.items():
        if name in names:
            value = globals()[name] = getattr(import_module(f"{__name__}.{module}"), name)
            return value
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*(name for names in EXPORTS.values() for name in names), "__version__"])
