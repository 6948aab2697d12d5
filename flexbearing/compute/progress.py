"""What a person sees while a case runs: stages, iterations, the end."""

import logging
from typing import Protocol

from rich.console import Console

from flexbearing.coupling import Iteration

log = logging.getLogger("flexbearing.run")


class Report(Protocol):
    """Listens to a run."""

    def stage(self, text: str, fraction: float | None) -> None:
        """Take note of a stage that begins, or of how much of it is done (0 to 1)."""
        ...

    def iteration(self, iteration: Iteration) -> None:
        """Take note of an exchange between bearing and rings."""
        ...


class Logged:
    """Sends every stage and iteration to the log, one line each."""

    def __init__(self):
        self._last = ""

    def stage(self, text: str, fraction: float | None) -> None:
        """Log a stage when it begins."""
        if text != self._last:
            log.info("%s", text)
        self._last = text

    def iteration(self, iteration: Iteration) -> None:
        """Log number, largest load change and largest load of an iteration."""
        log.info("%s", line(iteration))


def line(iteration: Iteration) -> str:
    """One line for one iteration."""
    largest = iteration.state.forces[0, :, 0].max()
    return (
        f"iteration {iteration.number:3d}: largest load change {iteration.load_change:.2e}, "
        f"largest roller load {largest:8.1f} N"
    )


class OnTerminal:
    """Shows stages with a bar and iterations as lines, on a terminal."""

    def __init__(self, console: Console):
        self._console = console
        self._last = ""

    def stage(self, text: str, fraction: float | None) -> None:
        """Print a stage when it begins; rewrite its line while it goes on."""
        share = "" if fraction is None else f" {100 * fraction:3.0f} %"
        new = text != self._last
        if new and self._last:
            self._console.print()
        self._console.print(f"\r[bold]{text}[/bold]{share}", end="", highlight=False)
        self._last = text

    def iteration(self, iteration: Iteration) -> None:
        """Print one line."""
        if self._last:
            self._console.print()
        self._last = ""
        self._console.print(line(iteration), highlight=False)
