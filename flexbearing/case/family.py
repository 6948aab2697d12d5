"""What differs from one bearing family to the next, as one record that case, runs and report receive."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from flexbearing.case.head import Head


@dataclass(frozen=True)
class Entry:
    """An object that is imported when it is requested, by calling this."""

    place: str  # module and name, "flexbearing.case.roller:Case"

    def __call__(self) -> Any:
        """Import the object."""
        module, _, name = self.place.partition(":")
        return getattr(import_module(module), name)


@dataclass(frozen=True, kw_only=True)
class Family:
    """A bearing family; its entries are functions without arguments: unused families are not loaded."""

    kind: str  # as the first key of a case file names it
    case: Callable[[], type[Head]]  # model of the case file
    build: Callable[[], Callable[[Any], object]]  # all that needs no mesh
    opening: Callable[[], Callable[[Any], dict[str, Any]]]  # root attributes known before anything is solved
    solve: Callable[[], Callable[..., dict[str, Any]]]  # case, result file, progress report: the ending
    layout: Callable[[], Any]  # a `flexbearing.quantities.layout.Layout`
    report: Callable[[], Any]  # a `flexbearing.report.family_report.FamilyReport`
    card: Callable[[], Callable[[Any], Any]]  # a result in a few lines: a `flexbearing.report.card.Card`
    write_report: Callable[[], Callable[..., Any]] = Entry("flexbearing.pages.make:report")
    ahead: Callable[[], Callable[[Any], Any]] | None = None  # begins beside what `solve` loads; a context
    profiles: Callable[[], Callable[[Any], Any]] | None = None  # along rollers: places, drops
    neighbouring_state: Callable[[], Callable[..., Any]] | None = None  # of a case that differs little
    initial_state: Callable[[], Callable[..., Any]] | None = None  # from another result; None: it has no such
    sensitivities: Callable[[], Callable[..., Any]] | None = None  # of outputs by keys; None: there are none
    levels: Callable[[], Any] | None = None  # a `flexbearing.accuracy.family.LevelsOfFamily`; None: no target
    rows: Callable[[], Callable[..., Any]] | None = None  # as `flexbearing.runs.rows.answers`; None: by runs
    catalogue: Callable[[], Any] | None = (
        None  # a `flexbearing.life.against_catalogue.Catalogue`; None: no ratings
    )


Families = Mapping[str, Family]  # by kind; the first is that of a file which names none
