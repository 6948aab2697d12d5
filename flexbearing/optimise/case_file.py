"""The case file of the best design, which `flexbearing run` takes."""

import os
from collections.abc import Mapping
from copy import deepcopy
from pathlib import Path
from typing import Any
from zlib import crc32

from flexbearing import inputs
from flexbearing.case.declarations import find
from flexbearing.case.head import Head, Source
from flexbearing.case.read import with_settings, written
from flexbearing.case.text import LARGEST, tables
from flexbearing.case.write import lines
from flexbearing.families import FAMILIES
from flexbearing.files import BadOutput
from flexbearing.studies.file import Study


def case_text(study: Study, settings: Mapping[str, Any], folder: Path) -> bytes:
    """The case of a study with some settings, as a file in a folder."""
    raw = deepcopy(tables(study.text))
    case = with_settings(
        raw, Source(str(study.case), study.text, (*study.settings, *written(settings))), FAMILIES
    )
    _rate(raw, case)
    named = {path.resolve() for path in case.named_files}
    _told_from(raw, study.case.parent, named, folder)
    found = ", ".join(settings)
    head = f"# {study.case.name} with what {study.path.name} found: {found}.\n"
    text = (head + "\n".join(lines(raw)) + "\n").encode()
    return _seal(text) + text


def _rate(raw: dict[str, Any], case: Head) -> None:
    """Write given ratings as those of the bearing that was found: it is the one of the file now."""
    catalogue = FAMILIES[case.kind].catalogue
    for name, rating in catalogue().rated(case).given.items() if catalogue else ():
        if rating.scale != 1:
            declaration = find(f"life.{name}", type(case))
            assert declaration
            assert declaration.kind
            raw["life"][name] = declaration.kind.written(rating.value, raw["life"][name])


def require_unedited(place: Path) -> None:
    """Refuse to replace a case that somebody else wrote, or edited after `case_text` made it.

    Raises `BadOutput` saying what to do.
    """
    if not place.exists():
        return
    try:
        first, end, text = inputs.content(place, LARGEST).partition(b"\n")
    except inputs.Unreadable as problem:
        raise BadOutput(f"{place}: {problem}; rename it.") from problem
    if first + end != _seal(text):
        raise BadOutput(f"{place}: was edited, or is another file, and would be replaced; rename it.")


def _seal(text: bytes) -> bytes:
    """The line before a text that says whether it was edited."""
    return b"# flexbearing optimise replaces this file while it is unchanged: %08x\n" % crc32(text)


def _told_from(table: dict[str, Any], before: Path, named: set[Path], folder: Path) -> None:
    for name, value in table.items():
        if isinstance(value, dict):
            _told_from(value, before, named, folder)
        elif isinstance(value, str) and (before / value).resolve() in named:
            table[name] = os.path.relpath((before / value).resolve(), folder.resolve())
