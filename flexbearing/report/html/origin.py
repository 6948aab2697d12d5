"""What was computed, where, when and with which versions."""

from collections.abc import Mapping

from flexbearing.quantities.coupling import LOAD_ERRORS
from flexbearing.report.html.document import Cell, Table
from flexbearing.report.html.reader import Reader
from flexbearing.results.content import digest
from flexbearing.results.write import content_of

_MACHINE = {"system": "operating system", "revision": "revision of the program's source (git commit)"}


def ending(reader: Reader) -> str:
    """How the run ended, in a sentence."""
    about = reader.attributes
    count, message = about["iterations"], about["message"]
    ended = f"Not converged ({about['status']}): {message or about['ending']}: no answer."
    words = f"Converged: {message}." if about["status"] == "converged" else ended
    return words + (f" {count} iterations of bearing and rings." if count else "")


def command(reader: Reader) -> str:
    """The command that repeats the run."""
    settings = "".join(f" --set '{each}'" for each in reader.attributes["case_overrides"])
    return f"flexbearing run {reader.case_name}{settings} -o AGAIN.h5"


def origin(reader: Reader) -> Table:
    """Versions, times, digest."""
    about = reader.attributes
    rows = [
        ("result file", str(reader.result.path or "none")),
        ("digest of its content (SHA-256)", digest(content_of(reader.result))),
        ("case file", about.get("case_file", "none")),
        ("computed", about["created"]),
        ("time it took", f"{about['wall_time_s']:.1f} s"),
        *(
            (_MACHINE.get(name, f"{name} of the computation"), str(value))
            for name, value in about.get("machine", {}).items()
        ),
        *((f"version of {name}", text) for name, text in about["versions"].items()),
    ]
    return Table(("origin", "value"), tuple(rows))


def attempts(reader: Reader) -> Table | None:
    """Methods of the coupling, in the order they were tried."""
    rows = [
        (name, str(each["iterations"]), each["status"], each["message"])
        for name, each in (reader.attributes.get("attempts") or {}).items()
    ]
    return Table(("method", "iterations", "status", "message"), tuple(rows)) if rows else None


def levels(reader: Reader) -> Table | None:
    """Levels of accuracy, what set them, and their estimated errors."""
    rows: list[tuple[Cell, ...]] = []
    for name, choice in (reader.attributes.get("choices") or {}).items():
        changes = [_change(choice["changes"], outputs) for outputs in (LOAD_ERRORS, ("life",))]
        errors = (None if change is None else change * choice["factor"] for change in changes)
        percent = (
            reader.units.number(share, "1", "%", ".2g", f"choices/{name}/{word}")
            for word, share in zip(("load", "life", "allowed"), (*errors, choice["allowed"]), strict=True)
        )
        rows.append((name, choice["level"], "the case" if choice["fixed"] else "accuracy.target", *percent))
    head = ("choice", "level", "set by", "load ± [%]", "life ± [%]", "allowed [%]")
    return Table(head, tuple(rows)) if rows else None


def _change(changes: Mapping[str, float], outputs: tuple[str, ...]) -> float | None:
    """The change of the one of these outputs that a bearing has."""
    return next((changes[output] for output in outputs if output in changes), None)


def accuracy(reader: Reader) -> str:
    """Whether the accuracy of the case is kept; empty where it has none."""
    errors = reader.attributes.get("error_estimate")
    if not errors:
        return ""
    met = "estimated to be kept" if errors["met"] else "NOT kept"
    return f"accuracy of {100 * errors['target']:g} % of loads and life: {met}"


def unusable(reader: Reader) -> list[str]:
    """Levels of accuracy that were not computed, and why."""
    choices = (reader.attributes.get("choices") or {}).values()
    return [f"{level}: {why}" for choice in choices for level, why in choice["unusable"].items()]
