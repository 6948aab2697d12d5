"""A bearing case as programs and notebooks hold it: changed, computed, varied, optimised."""

from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from flexbearing import api
from flexbearing.case import BadCase, Head

if TYPE_CHECKING:
    from flexbearing.derivatives.table import Sensitivities
    from flexbearing.goal.answer import Goal
    from flexbearing.optimise.answer import Optimum
    from flexbearing.report.drawing import Drawing
    from flexbearing.results import Result
    from flexbearing.studies.table import Table


class Case:
    """A case that was read and does not change.

    >>> case = Case("nu210.toml").with_({"operation.radial_load": "8 kN"})   # doctest: +SKIP
    >>> case.run()["life [h]"]                                               # doctest: +SKIP
    """

    def __init__(self, case: str | Path | Head, changes: api.Overrides = ()):
        """Read a case file, with keys that replace or add those of the file; raises `BadCase`."""
        self.head = case if isinstance(case, Head) else api.read_case(case, changes)

    def __repr__(self) -> str:
        return "\n  ".join([f"{self.head.title} ({self.head.kind})", *self.head.source.overrides])

    @cached_property
    def _family(self) -> Any:
        from flexbearing.families import FAMILIES

        return FAMILIES[self.head.kind]

    def with_(self, changes: Mapping[str, object]) -> "Case":
        """The same case with other values of some keys; None takes a key out. Raises `BadCase`."""
        from flexbearing.case.read import written
        from flexbearing.runs.run_case import reader

        return Case(reader(self.head, self._family)(written(changes)))

    def check(self) -> None:
        """Build everything that needs no mesh; raises `BadCase` where physics or geometry forbid it."""
        from flexbearing.runs.validate import require_possible

        require_possible(self.head, self._family)

    def run(
        self, output: str | Path | None = None, *, start: "str | Path | Result | None" = None
    ) -> "Result":
        """Compute the case, see `flexbearing.run`."""
        return api.compute(self.head, output=output, start=start)

    def drawings(self) -> "list[Drawing]":
        """Draw what the case describes, to scale."""
        return api.drawings(self.head)

    def sensitivity(self, of: str | Sequence[str] = (), by: str | Sequence[str] = ()) -> "Sensitivities":
        """How much a realistic step of each key changes the outputs, with derivatives.

        `of` names outputs, "life" or "all"; `by` keys, by default those that the case states.
        """
        names, keys = ([each] if isinstance(each, str) else each for each in (of, by))
        return api.sensitivities(self.head, names, keys)

    def goal(self, life: str) -> "Goal":
        """What to change for a life, "x2" or "20000 h": every lever alone, and the best pair."""
        from flexbearing.goal.search import goal
        from flexbearing.progress import Logged

        return goal(self.head, self._family, life, Logged())

    def sweep(
        self,
        over: Mapping[str, object],
        collect: Mapping[str, str] | Sequence[str] | None = None,
        *,
        output: str | Path | None = None,
        jobs: int = 1,
    ) -> "Table":
        """Compute the case over values of some keys, crossed: lists, or ranges such as "3 .. 14 mm, 12".

        `collect` names outputs, or columns with their outputs, by default the main ones. Nothing is stored
        without a folder `output`.
        """
        from flexbearing.studies.study import study

        columns = collect or self._main
        if not isinstance(columns, Mapping):
            columns = {output.partition(" [")[0]: output for output in columns}
        wanted = {"case": self, "name": "sweep", "over": dict(over), "collect": columns}
        if output is not None:
            return study(wanted, output, jobs=jobs)
        with TemporaryDirectory() as folder:
            return study(wanted, folder, jobs=jobs)

    @property
    def _main(self) -> dict[str, str]:
        """The outputs that results of the family are known by, the most detailed life first."""
        names = dict.fromkeys(self._family.layout().main)
        life = getattr(self.head, "life", None)
        first = () if life is None or life.is_basic else ("modified_life",)
        return {name: f"{name} [h]" if "life" in name else name for name in (*first, *names)}

    def optimise(self, study: str | Path | Mapping[str, Any], output: str | Path = "results") -> "Optimum":
        """Find the best design of an optimisation, a file or a dictionary, whose case this one is."""
        from flexbearing.optimise.run import optimise

        return optimise(study, output, case=self.head)

    def save(self, file: str | Path) -> Path:
        """Write the case as a file.

        Raises `BadOutput` where there is one already, or it cannot be written.
        """
        from flexbearing.case.write import text
        from flexbearing.files import BadOutput, require_output, write

        place = require_output(file, self.head.input_files)
        if place.exists():
            raise BadOutput(f"{file}: is there already.")
        write(place, text(self.head, {self.head.kind: self._family}).encode())
        return place


def new(like: str = "cylindrical_roller", *, title: str = "", source: str = "", **entries: str | int) -> Case:
    """Make a case of the page of a catalogue, `new("cylindrical_roller", bore="50 mm", ...)`.

    The entries are those of `flexbearing new`; what none gives is assumed.

    Raises `BadCase` for an entry that is unknown, missing or impossible.
    """
    from flexbearing.case import understood
    from flexbearing.catalogue.entries import ENTRIES
    from flexbearing.catalogue.new import case_text
    from flexbearing.families import FAMILIES

    if unknown := next((name for name in entries if name not in ENTRIES), None):
        raise BadCase(f"new: {unknown} is no entry; there are {', '.join(ENTRIES)}.")
    file = Path(f"{like}.toml")
    try:
        text, _ = case_text(like, {name: str(value) for name, value in entries.items()}, file, title, source)
    except BadCase as problem:
        raise BadCase(_in_words_of_python(str(problem))) from None
    return Case(understood(text, file, (), FAMILIES))


def _in_words_of_python(message: str) -> str:
    """Entries by their names, where the command line has options."""
    from flexbearing.catalogue.entries import ENTRIES

    for name, entry in ENTRIES.items():
        options = ", ".join(filter(None, (entry.option, entry.letter)))
        message = message.replace(options, name).replace(f"{entry.option}:", f"{name}:")
        message = message.replace(f"{entry.option} ", f"{name} ")
    return message.replace("--like ", "like ")
