"""The program `flexbearing`: from a command line to an exit code, with a line about what went wrong."""

import sys

from flexbearing.program import signals  # everything else is imported when signals are noticed

CONVERGED, NOT_CONVERGED, BAD_INPUT, INTERNAL = range(4)
SIGNALLED = 128  # and the number of the signal
DEBUG = "--debug"
SAVING = "run", "study", "optimise", "report", "plot", "export", "map", "pareto", "limits", "select"
TOLD_BY_CODE = (*SAVING, "check")  # commands whose exit code says what matters
HINTS = {  # by the name of what the operating system refused
    "ENOSPC": "Free space there, or choose another place; TMPDIR names the folder for temporary files.",
    "EDQUOT": "Free space there, or choose another place; TMPDIR names the folder for temporary files.",
    "EROFS": "Choose another place; TMPDIR names the folder for temporary files.",
    "EIO": "Look after the disk, or choose another place.",
    "EMFILE": "Permit more open files: ulimit -n.",
    "ENFILE": "Run fewer programs at a time.",
    "ENOMEM": "Run fewer cases at a time, or take larger elements.",
    "EAGAIN": "Run fewer programs at a time.",
}


def main() -> None:
    """Run the command line of this process; its exit code speaks of the computation."""
    import gc

    code, problem = INTERNAL, None
    try:
        signals.notice()
        gc.set_threshold(300_000)  # loading modules leaves nothing to collect
        from flexbearing.program.streams import prepare

        prepare()
        code = command(sys.argv[1:])
        signals.leave()
    except BaseException as ended:  # an interruption may arrive as another exception
        if signals.received() is None:
            raise
        problem = ended
    if problem and (interruption := signals.received()):
        code = _interrupted(interruption, problem, sys.argv[1:])
    code = _delivered(code, sys.argv[1:])
    gc.freeze()  # the interpreter need not search what ends with it: as long as a check takes
    sys.exit(code)


def command(words: list[str]) -> int:
    """Do what a command line says; no traceback reaches a user who does not require it by --debug."""
    from os import environ

    environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # a search through every installed package
    try:
        from flexbearing.cli import application

        arguments = [word for word in words if word != DEBUG]  # it may also stand behind the command
        application(arguments[0] if arguments else "")(arguments)
    except SystemExit as end:
        interruption = signals.received()
        if interruption and end.code == SIGNALLED + 2:  # what typer makes of every interruption
            raise interruption from None
        return end.code if isinstance(end.code, int) else CONVERGED
    except Exception as problem:
        if signals.received():
            raise
        if DEBUG in words:
            import traceback

            traceback.print_exc()
        return _told(problem)
    return CONVERGED


def _told(problem: Exception) -> int:
    """Say in a line what went wrong; returns the exit code."""
    code, words = _meaning(problem)
    if notes := getattr(problem, "__notes__", ()):
        words = "; ".join([words.rstrip("."), *notes])
    sys.stderr.write(f"{words}\n")
    return code


def _meaning(problem: Exception) -> tuple[int, str]:
    """Exit code and words for an exception; what a good case does without is not loaded before."""
    from flexbearing.case import BadCase

    if isinstance(problem, BadCase):
        return BAD_INPUT, str(problem)
    from flexbearing.files import BadOutput, NotStored

    if isinstance(problem, BadOutput | NotStored):
        return BAD_INPUT if isinstance(problem, BadOutput) else INTERNAL, str(problem)
    from flexbearing.results import BadResult, NotInLayout

    if isinstance(problem, BadResult | NotInLayout):
        return BAD_INPUT, str(problem)
    from flexbearing.inputs import Unreadable

    if isinstance(problem, Unreadable) and problem.path:
        return BAD_INPUT, f"{problem.path}: {problem}."
    return INTERNAL, _refused(problem) or f"internal error: {type(problem).__name__}: {problem}"


def _refused(problem: Exception) -> str:
    """Words for what the machine does not give; empty for anything else."""
    if isinstance(problem, MemoryError):
        return "out of memory: take larger elements or fewer slices, or run fewer cases at a time."
    from flexbearing.program.interpreter import Died

    if isinstance(problem, Died):
        return f"{problem}."
    if not isinstance(problem, OSError):
        return ""
    from errno import errorcode

    hint = HINTS.get(errorcode.get(problem.errno or 0, ""))
    where = f"{problem.filename}: " if problem.filename else ""
    return f"{where}{problem.strerror}. {hint}" if hint else ""


def _interrupted(interruption: signals.Interrupted, problem: BaseException, words: list[str]) -> int:
    """Say in a line what an interruption left behind; returns the exit code."""
    notes = [*getattr(interruption, "__notes__", ())]
    notes += [note for note in getattr(problem, "__notes__", ()) if note not in notes]
    if not notes and _name(words) in SAVING:
        notes = ["nothing was kept"]
    if sys.stderr.isatty():
        sys.stderr.write("\n")  # what was typed, ^C, is on a line of its own
    sys.stderr.write(": ".join(["interrupted", *filter(None, ["; ".join(notes)])]) + "\n")
    return SIGNALLED + interruption.number


def _delivered(code: int, words: list[str]) -> int:
    """The exit code, after the output has arrived; a reader that left has read enough."""
    from errno import EPIPE

    from flexbearing.program.streams import lost_output

    problem = lost_output()
    if problem is None or problem.errno == EPIPE:
        return code
    sys.stderr.write(
        f"standard output could not be written ({problem.strerror}): what it should hold is lost\n"
    )
    return code if _name(words) in TOLD_BY_CODE else code or INTERNAL


def _name(words: list[str]) -> str:
    """Name of the command; options before it take no values."""
    return next((word for word in words if not word.startswith("-")), "")


if __name__ == "__main__":
    main()
