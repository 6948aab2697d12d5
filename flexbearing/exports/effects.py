"""Effects of assumed inputs from a result to the file next to its case, where later runs find them."""

from collections.abc import Iterator
from pathlib import Path

from flexbearing.case import BadCase, understood
from flexbearing.files import require_folder, require_output, write
from flexbearing.results import Result
from flexbearing.runs import effects_file


def export(result: Result, directory: Path) -> Iterator[Path]:
    """Write the effects of a result.

    Raises
    ------
    BadCase
        without that attribute
    BadOutput, NotStored
        if the file cannot be written
    """
    about = result.attributes
    if not about.get("assumed_effects"):
        raise BadCase(
            f"{result.place}: --to effects needs a result of a run with outputs.assumed_effects = true"
        )
    file = Path(about["case_file"])
    case = understood(about["case_text"], file, about["case_overrides"], {result.kind: result.family})
    path = require_output(require_folder(directory) / effects_file.name(file).name, result.files)
    write(path.resolve(), effects_file.content(case, about["assumed_effects"]))
    yield path
