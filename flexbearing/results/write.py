"""A result file that is stored while the run goes on and gets its name when complete."""

import logging
from collections.abc import Mapping
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path
from threading import RLock, Timer
from typing import Any, ClassVar, Literal, Self

from numpy.typing import ArrayLike

from flexbearing.case import BadCase
from flexbearing.case.family import Family
from flexbearing.files import BadOutput, NotStored, lock, parts_of, require_output, write
from flexbearing.files.atomic import host, part_name
from flexbearing.quantities.layout import Layout
from flexbearing.results import hdf5_read
from flexbearing.results.attributes import encoded
from flexbearing.results.checks import NotInLayout
from flexbearing.results.content import ITERATIONS, MEANINGS, Content, meanings, named_axes, scales
from flexbearing.results.hdf5_write import image
from flexbearing.results.record import Others, Record
from flexbearing.results.result import Result

CASE = ".toml"
LATEST = 0.5  # [s] that anything finished stays in memory only
log = logging.getLogger(__name__)


class ResultFile:
    """The result file of a run; its only writer.

    What is finished goes to a ``.part`` file within a second, always as a whole file that can be read, until
    :meth:`finish` writes the result and gives it its name: a name without ``.part`` promises a complete file.
    A run that breaks off leaves the ``.part`` file with all that it reached, and says so in a note of the
    exception; one that finds its input bad leaves none.

    A file that is already there stays until the new one is complete; `inputs` are files that are read and
    that the result must not replace, other arguments are those of a `Record`.
    Raises `NotInLayout` as it does; `BadOutput` for a name that cannot be written, or that another run is
    writing (on entering).

    Examples
    --------
    ::

        with ResultFile("case.h5", {"title": "squirrel cage"}, family) as file:
            for number, state in enumerate(states, start=1):
                file.iteration(number, state)
            file.block("rigid", rigid)
            file.block("flexible", flexible)
            result = file.finish(status="converged", ...)
    """

    stores: ClassVar[bool] = True

    def __init__(
        self,
        path: str | Path,
        attributes: Mapping[str, Any],
        family: Family,
        inputs: tuple[Path, ...] = (),
        others: Others = "searched",
    ):
        self.path, self.others = Path(path), others
        self._place = _require_place(path, inputs)  # where a link leads
        self.part = part_name(self._place)
        self._record = Record(attributes, family)
        self._open = ExitStack()
        self._is_open = False
        self._guard = RLock()  # of all that the timer reads
        self._timer: Timer | None = None
        self._problem: Exception | None = None  # met by the timer

    def __enter__(self) -> Self:
        self._open.enter_context(lock(self._place))
        self._is_open = True
        return self

    def __exit__(self, kind: object, problem: BaseException | None, trace: object) -> None:
        try:
            if self._is_open:  # not finished
                with self._guard:
                    self._is_open = False
                    if self._timer is not None:
                        self._timer.cancel()
                if isinstance(problem, BadCase):  # of bad input there is no result, as exit code 2 promises
                    self.part.unlink(missing_ok=True)
                elif (kept := "" if isinstance(problem, NotStored) else self._kept()) and problem is not None:
                    problem.add_note(kept)
            elif problem is not None:  # a signal that came a moment later
                problem.add_note(f"complete: {self.path}")
        finally:
            self._open.close()

    def iteration(self, number: int, values: Mapping[str, ArrayLike]) -> None:
        """Add an iteration to the `Record`, which is stored soon.

        Raises `NotInLayout` where the record takes no such iteration; `NotStored` if earlier ones could not
        be stored.
        """
        self._require_open()
        with self._guard:
            self._record.iteration(number, values)
        self._store_soon()

    def block(
        self, name: Literal["rigid", "flexible"], values: Mapping[str, ArrayLike], *, converged: bool = True
    ) -> None:
        """Add an end state to the `Record`, which is stored soon.

        Raises `NotInLayout` where the record takes no such block; `NotStored` if what came before could not
        be stored.
        """
        self._require_open()
        with self._guard:
            self._record.block(name, values, converged=converged)
        self._store_soon()

    def finish(self, **attributes: Any) -> Result:
        """Write the result, make sure of it and give it its name.

        Raises `NotInLayout` for an unknown or missing attribute, or one that contradicts what was written;
        `NotStored` if it could not be written; what had its name before is unchanged.
        """
        self._require_open()
        result = replace(self._record.finish(**attributes), path=self.path)
        _write_whole(self._place, result)
        with self._guard:
            self._is_open = False
            if self._timer is not None:
                self._timer.cancel()
        _remove_parts(self._place)
        return result

    def _store_soon(self) -> None:
        """Have the timer store what there is; what it could not store before is reported now."""
        with self._guard:
            if self._problem is not None:
                raise self._problem
            if self._timer is None:
                self._timer = Timer(LATEST, self._store_on_time)
                self._timer.daemon = True
                self._timer.start()

    def _store_on_time(self) -> None:
        with self._guard:
            self._timer = None
            if self._is_open:
                try:
                    self._store_part()
                except Exception as problem:  # of any kind: the run raises it
                    self._problem = problem

    def _store_part(self) -> None:
        """Store all there is so far as an unfinished result."""
        data = image(content_of(self._record.so_far()))
        write(self.part, data, beside=self._place, lasting=False)

    def _kept(self) -> str:
        """Store what there is when a run breaks off; says what was kept and where, nothing without it."""
        if not self._record.words:
            return ""
        try:
            self._store_part()
        except NotStored as problem:
            return f"what was finished could not be kept: {problem}"
        return f"{self._record.words} kept in {self.part}"

    def _require_open(self) -> None:
        if not self._is_open:
            raise NotInLayout(f"{self.path}: the result file is not open; write inside its with-block.")


def store(result: Result, path: Path, inputs: tuple[Path, ...] = ()) -> None:
    """Write the file of a result that is complete.

    Raises `BadOutput` for a name that cannot be written, or that another run is writing; `NotStored` if it
    could not be written; what had its name before is unchanged.
    """
    place = _require_place(path, inputs)
    with lock(place):
        _write_whole(place, result)
        _remove_parts(place)


def _require_place(path: str | Path, inputs: tuple[Path, ...]) -> Path:
    """Where a result goes; a name of cases is a slip that would cost one."""
    place = require_output(path, inputs)
    if Path(path).suffix == CASE:
        raise BadOutput(f"{path}: is the name of a case, and results are HDF5; choose one that ends in .h5.")
    return place


def _remove_parts(place: Path) -> None:
    """Remove parts of runs that ended: whoever holds the lock knows that those of this host did."""
    for part, where, process in parts_of(place):
        if where == host():
            with suppress(OSError):  # somebody else removed it
                part.unlink()
        else:
            log.info("%s is left of process %d on %s; remove it if that has ended", part, process, where)


def _write_whole(place: Path, result: Result) -> None:
    """Write a file whose bytes were seen to hold the result."""
    content = content_of(result)
    data = image(content)
    hdf5_read.require_held(data, content)
    write(place, data)


def content_of(result: Result) -> Content:
    """Content of the file of a result."""
    layout: Layout = result.family.layout()
    groups = {"rigid": result.rigid, "flexible": result.flexible, ITERATIONS: result.stacked}
    named = scales(layout, groups)
    arrays = {name: scale.values for name, scale in named.items()}
    units = {name: scale.unit for name, scale in named.items()}
    axes: dict[str, tuple[str, ...]] = {}
    for group, datasets in groups.items():
        for name, array in datasets.items():
            place, entry = f"{group}/{name}", layout[name]
            arrays[place], units[place], axes[place] = array, entry.unit, named_axes(layout, group, entry)
    attributes = {name: encoded(layout.attributes[name], value) for name, value in result.attributes.items()}
    return Content({**attributes, MEANINGS: meanings(layout)}, arrays, units, axes)
