"""Files that are read: plain ones of limited size, their text, and the numbers in them.

Every file that a user, another program or another machine wrote is opened here. What is in it belongs to
the rooms that know the format.
"""

from flexbearing.inputs.archive import unpacked
from flexbearing.inputs.cells import cells, numbered_cells, require_different
from flexbearing.inputs.file import (
    Stamp,
    Unreadable,
    content,
    is_folder,
    is_plain,
    lines,
    opened,
    size,
    stamp,
    text,
)
from flexbearing.inputs.number import BadNumber, number, whole

__all__ = [
    "BadNumber",
    "Stamp",
    "Unreadable",
    "cells",
    "content",
    "is_folder",
    "is_plain",
    "lines",
    "number",
    "numbered_cells",
    "opened",
    "require_different",
    "size",
    "stamp",
    "text",
    "unpacked",
    "whole",
]
