"""Signals that end a program, as an exception that everything on the way can clean up after."""

import os
import signal
import sys

_NAMES = "SIGINT", "SIGTERM", "SIGHUP"
_AGAIN = 0.01  # [s]


class Interrupted(KeyboardInterrupt):
    """A signal asks the program to end; notes say what was kept."""

    def __init__(self, number: int):
        super().__init__(signal.Signals(number).name)
        self.number = number


_noticed: list[int] = []  # signals that raise
_received: list[Interrupted] = []


def notice() -> None:
    """Let the first signal that ends a program raise `Interrupted`; a second one ends it at once.

    Signals that are ignored stay so, as `nohup` and shells require it. Outside of the main thread, where
    Python knows no signals, nothing changes.
    """
    sys.excepthook, sys.unraisablehook = _uncaught, _unraisable
    for name in _NAMES:
        number = getattr(signal, name, None)
        if number is None or signal.getsignal(number) in (signal.SIG_IGN, None):
            continue
        try:
            signal.signal(number, _stop)
        except ValueError:  # another thread
            return
        _noticed.append(number)


def received() -> Interrupted | None:
    """The interruption that a signal caused, however it ended on its way."""
    return _received[-1] if _received else None


def leave() -> None:
    """Let signals end the program as they would without it."""
    while _noticed:
        signal.signal(_noticed[-1], signal.SIG_DFL)
        _noticed.pop()


def _stop(number: int, _: object) -> None:
    leave()
    _received.append(Interrupted(number))
    raise _received[-1]


def _uncaught(kind, problem, trace) -> None:
    """C libraries print so what they turn into an error of their own."""
    if not isinstance(problem, Interrupted):
        sys.__excepthook__(kind, problem, trace)


def _unraisable(problem) -> None:
    """Send a signal again that came where nothing can be raised: in a destructor, in a callback."""
    if not isinstance(problem.exc_value, Interrupted):
        sys.__unraisablehook__(problem)
        return
    from threading import Timer

    notice()
    again = Timer(_AGAIN, os.kill, (os.getpid(), problem.exc_value.number))
    again.daemon = True
    again.start()
