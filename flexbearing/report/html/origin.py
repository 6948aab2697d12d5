"""What was computed, where, when and with which versions."""

from flexbearing.report.html.document import Table
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
    """Levels of accuracy, and what set them."""
    rows = [
        (name, choice["level"], "the case" if choice["fixed"] else "accuracy.target")
        for name, choice in (reader.attributes.get("choices") or {}).items()
    ]
    return Table(("choice", "level", "set by"), tuple(rows)) if rows else None
