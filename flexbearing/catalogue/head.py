"""The head of a case from a catalogue: where its numbers come from, and the command that writes it."""

from pathlib import Path

from flexbearing.catalogue.entries import ENTRIES, LIKES
from flexbearing.catalogue.lines import WIDTH
from flexbearing.catalogue.page import Page
from flexbearing.printable import printable


def origin(page: Page, file: Path, title: str, source: str) -> list[str]:
    """Source of the numbers, and the command."""
    words = [f"flexbearing new {_quoted(file.name)}", f"--like {page.like}"]
    estimated = {*LIKES[page.like].two_of} & {*page.assumed}
    words += [
        f"{ENTRIES[name].option} {_quoted(value.text)}"
        for name, value in page.values.items()
        if name not in estimated
    ]
    words += [f"{name} {_quoted(text)}" for name, text in (("--title", title), ("--source", source)) if text]
    rows = [f"  {words[0]}"]
    for word in words[1:]:
        if len(rows[-1]) + len(word) > WIDTH - 5:
            rows[-1] += " \\"
            rows.append("     ")
        rows[-1] += f" {word}"
    whence = f"From a catalogue: {one_line(source)}." if source else "From the page of a catalogue."
    return [whence, "Written by", "", *rows]


def one_line(text: str) -> str:
    """Write a text so that it is one line of a comment."""
    return printable(" ".join(text.split()))


def _quoted(text: str) -> str:
    """Write a text as a word of a command line, where it needs it."""
    plain = one_line(text)
    for special in '\\"$`':
        plain = plain.replace(special, f"\\{special}")
    return plain if plain.replace(".", "").replace("-", "").isalnum() else f'"{plain}"'
