"""Reference page of optimisation files, from their declarations."""

from flexbearing.case.explain import table_of_keys
from flexbearing.optimise.file import BOUND
from flexbearing.optimise.schema import DUTY_LIFE, OptimisationFile
from flexbearing.optimise.variables import BOUNDS

OF_STUDIES = ("|`over.", "|`duty.")  # rows that the page of study files has


def reference_page() -> str:
    """The page in Markdown."""
    return "\n".join(
        [
            "# Keys of an optimisation file",
            "",
            "[How to use them](../howto/optimise.md).",
            "",
            "In `[set]`, `[vary]`, `[over]`, `[duty]` and `[[verify]]` every other name is a dotted key of "
            "the case; `[over]` and `[duty]` are those [of a study](study.md).",
            "",
            f"- `[vary]`: {BOUNDS}.",
            f"- `[constrain]`: the name of an output, or {DUTY_LIFE}, and a bound such as {BOUND}.",
            "",
            *(line for line in table_of_keys(OptimisationFile) if not line.startswith(OF_STUDIES)),
            "",
        ]
    )
