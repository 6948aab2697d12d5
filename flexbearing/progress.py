"""What a person sees while a command works: a bar on a terminal, lines elsewhere, never silent for long."""

import logging
import sys
from collections.abc import Callable
from math import inf
from threading import Event, Thread
from time import perf_counter
from typing import TYPE_CHECKING, Protocol, Self

from flexbearing.printable import printable

if TYPE_CHECKING:
    from rich.console import Console
    from rich.progress import TaskID

    from flexbearing.coupling import Iteration

EVERY = 3.0  # [s] between the lines of a stage that goes on

log = logging.getLogger("flexbearing.run")


class Report(Protocol):
    """Listens to a run."""

    def stage(self, text: str, fraction: float | None) -> None:
        """Take note of a stage that begins, or of how much of it is done (0 to 1); details follow a colon."""
        ...

    def iteration(self, iteration: "Iteration") -> None:
        """Take note of an exchange between bearing and rings."""
        ...

    def line(self, text: str) -> None:
        """Take note of what is worth a line that stays."""
        ...


def shown(text: str) -> "Lines | OnTerminal":
    """Progress of a command on the error stream, called so until its first stage."""
    if not sys.stderr.isatty():
        return Lines(text)
    from rich.console import Console

    from flexbearing.program.streams import terminal_errors

    return OnTerminal(Console(file=terminal_errors()), text)


class Silent:
    """Listens to what is only a part of a stage, and reports nothing."""

    def stage(self, text: str, fraction: float | None) -> None:
        """Take no note of a stage."""

    def iteration(self, iteration: "Iteration") -> None:
        """Take no note of an iteration."""

    def line(self, text: str) -> None:
        """Take no note of it."""


def _to_the_log(text: str) -> None:
    log.info("%s", text)


class Logged:
    """Reports every stage, in the log or elsewhere, and how far a long one is; details for debugging."""

    def __init__(self, tell: Callable[[str], None] = _to_the_log):
        self._tell, self._last, self._told = tell, "", -inf

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        """Nothing to tidy up."""

    def stage(self, text: str, fraction: float | None) -> None:
        """Log a stage when it begins, and its part that is done, if there is one, every `EVERY` seconds."""
        last, self._last = self._last, text
        if text != last and ":" not in text:
            self._told = -inf
            self._detail(text)
        elif fraction is not None:
            self._detail(f"{text}: {100 * fraction:.0f} % done")
        elif text != last:
            self._detail(text)

    def iteration(self, iteration: "Iteration") -> None:
        """Log number, largest load change and largest load of an iteration, every `EVERY` seconds."""
        self._detail(line(iteration))

    def line(self, text: str) -> None:
        """Log a line."""
        self._tell(text)

    def _detail(self, text: str) -> None:
        """Tell what is news after `EVERY` seconds without any; else it is for those who debug."""
        if (now := perf_counter()) - self._told < EVERY:
            log.debug("%s", text)
            return
        self._told = now
        self._tell(text)


def line(iteration: "Iteration") -> str:
    """One line for one iteration."""
    largest = iteration.state.loads[0].max()
    return (
        f"iteration {iteration.number:3d}: largest load change {iteration.load_change:.2e}, "
        f"largest load {largest:8.1f} N"
    )


class Lines(Logged):
    """Lines on the error stream: what is at work, and since when, wherever `EVERY` seconds had none."""

    def __init__(self, text: str):
        super().__init__(self._write)
        self._ended, self._last = Event(), text
        self._began = self._told = perf_counter()  # what ends sooner needs no line

    def __enter__(self) -> Self:
        Thread(target=self._repeat, daemon=True).start()
        return self

    def __exit__(self, *_: object) -> None:
        self._ended.set()

    def stage(self, text: str, fraction: float | None) -> None:
        """Take note of a stage, for the next line."""
        if text.partition(":")[0] != self._last.partition(":")[0]:
            self._began = perf_counter()
        self._last = text
        self._detail(text if fraction is None or ":" in text else f"{text}: {100 * fraction:.0f} % done")

    def line(self, text: str) -> None:
        """Print a line at once."""
        self._told = perf_counter()
        self._write(text)

    def _write(self, text: str) -> None:
        sys.stderr.write(f"{printable(text)}\n")
        sys.stderr.flush()

    def _repeat(self) -> None:
        while not self._ended.wait(max(EVERY - (perf_counter() - self._told), EVERY / 30)):
            self._detail(f"{self._last}, {perf_counter() - self._began:.0f} s")


class OnTerminal:
    """Shows the stage at work as a bar with its iteration, on a terminal; nothing of it stays."""

    def __init__(self, console: "Console", text: str = ""):
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
        self._bars = Progress(*columns, console=console, transient=True)
        self._task: TaskID | None = None
        self._text = text

    def __enter__(self) -> Self:
        try:
            self._bars.start()
        except BaseException:  # an interruption: the cursor was hidden
            self._bars.stop()
            raise
        if self._text:
            self.stage(self._text, None)
        return self

    def __exit__(self, *_: object) -> None:
        self._finish()
        self._bars.stop()

    def stage(self, text: str, fraction: float | None) -> None:
        """Begin a bar for a new stage, or fill the one at work."""
        if text.partition(":")[0] != self._text.partition(":")[0] or self._task is None:
            self._finish()
            self._task = self._bars.add_task(printable(text), total=None)
        elif text != self._text:
            self._bars.update(self._task, description=printable(text))
        self._text = text
        if fraction is not None:
            self._bars.update(self._task, total=1.0, completed=fraction)

    def iteration(self, iteration: "Iteration") -> None:
        """Show the iteration at work behind its stage."""
        if self._task is not None:
            self._bars.update(self._task, description=printable(f"{self._text}: {line(iteration)}"))

    def line(self, text: str) -> None:
        """Print a line that stays, above the bar."""
        self._bars.console.print(printable(text), markup=False, highlight=False, soft_wrap=True)

    def _finish(self) -> None:
        if self._task is not None:
            self._bars.remove_task(self._task)
