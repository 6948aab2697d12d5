"""What a person sees while a case runs: stages, iterations, the end."""

import logging
from collections.abc import Callable
from time import perf_counter
from typing import TYPE_CHECKING, Protocol, Self

from flexbearing.printable import printable

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import TaskID

    from flexbearing.coupling import Iteration

EVERY = 10.0  # [s] between the lines of a stage that goes on

log = logging.getLogger("flexbearing.run")


class Report(Protocol):
    """Listens to a run."""

    def stage(self, text: str, fraction: float | None) -> None:
        """Take note of a stage that begins, or of how much of it is done (0 to 1)."""
        ...

    def iteration(self, iteration: "Iteration") -> None:
        """Take note of an exchange between bearing and rings."""
        ...


class Silent:
    """Listens to what is only a part of a stage, and reports nothing."""

    def stage(self, text: str, fraction: float | None) -> None:
        """Take no note of a stage."""

    def iteration(self, iteration: "Iteration") -> None:
        """Take no note of an iteration."""


def _to_the_log(text: str) -> None:
    log.info("%s", text)


class Logged:
    """Tells every stage and iteration, to the log or elsewhere, a line each, and how far a long stage is."""

    def __init__(self, tell: Callable[[str], None] = _to_the_log):
        self._tell, self._last, self._told = tell, "", 0.0

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing to tidy up."""

    def stage(self, text: str, fraction: float | None) -> None:
        """Log a stage when it begins, and its part that is done, if there is one, every `EVERY` seconds."""
        now = perf_counter()
        if text != self._last:
            self._tell(text)
        elif fraction is not None and now - self._told >= EVERY:
            self._tell(f"{text}: {100 * fraction:.0f} % done")
        else:
            return
        self._last, self._told = text, now

    def iteration(self, iteration: "Iteration") -> None:
        """Log number, largest load change and largest load of an iteration."""
        self._tell(line(iteration))


def line(iteration: "Iteration") -> str:
    """One line for one iteration."""
    largest = iteration.state.forces[0, :, 0].max()
    return (
        f"iteration {iteration.number:3d}: largest load change {iteration.load_change:.2e}, "
        f"largest roller load {largest:8.1f} N"
    )


class OnTerminal:
    """Shows stages as bars and iterations as lines, on a terminal; a context manager."""

    def __init__(self, console: "Console"):
        from rich.progress import (  # only terminals pay for it
            BarColumn,
            Progress,
            TextColumn,
            TimeElapsedColumn,
        )

        columns = (
            TextColumn("{task.description}", markup=False),
            BarColumn(bar_width=20),
            TimeElapsedColumn(),
        )
        self._bars = Progress(*columns, console=console)
        self._task: TaskID | None = None
        self._text = ""

    def __enter__(self) -> Self:
        try:
            self._bars.start()
        except BaseException:  # an interruption: the cursor was hidden
            self._bars.stop()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        self._finish()
        self._bars.stop()

    def stage(self, text: str, fraction: float | None) -> None:
        """Begin a bar for a new stage, or fill the one at work."""
        if text != self._text or self._task is None:
            self._finish()
            self._task, self._text = self._bars.add_task(printable(text), total=None), text
        if fraction is not None:
            self._bars.update(self._task, total=1.0, completed=fraction)

    def iteration(self, iteration: "Iteration") -> None:
        """Print one line above the bars."""
        self._bars.console.print(line(iteration), highlight=False)

    def _finish(self) -> None:
        if self._task is not None:
            self._bars.update(self._task, total=1.0, completed=1.0)
            self._bars.stop_task(self._task)
