"""Files of a user: where one may be written, who is writing it, how it appears whole or not at all.

What is in them belongs to the rooms that make them: results, report, cache.
"""

from flexbearing.files.atomic import NotStored, parts_of, write
from flexbearing.files.csv_rows import as_csv
from flexbearing.files.destination import (
    BadOutput,
    require_folder,
    require_folder_name,
    require_output,
    require_outputs,
)  # fmt: skip
from flexbearing.files.lock import lock

__all__ = [
    "BadOutput",
    "NotStored",
    "as_csv",
    "lock",
    "parts_of",
    "require_folder",
    "require_folder_name",
    "require_output",
    "require_outputs",
    "write",
]
