"""Notes of a result, for tests."""

from flexbearing.results import Result


def keys(result: Result, code: str) -> dict[str, str]:
    """Keys of the note of a code, with values to consider."""
    (note,) = [note for note in result.attributes["notes"] if note["code"] == code]
    return note["keys"]


def texts(result: Result) -> list[str]:
    """Texts of all notes, in their order."""
    return [note["text"] for note in result.attributes["notes"]]


def codes(result: Result, grade: str | None = None) -> list[str]:
    """Codes of all notes, or of those of a grade."""
    return [note["code"] for note in result.attributes["notes"] if grade in (None, note["grade"])]
