"""The file of a run: its layout, writing it, reading it."""

from flexbearing.results.checks import NotInLayout
from flexbearing.results.layout import FORMAT, TABLE, Dataset
from flexbearing.results.read import BadResult, Result, read
from flexbearing.results.write import ResultFile

__all__ = [
    "FORMAT",
    "TABLE",
    "BadResult",
    "Dataset",
    "NotInLayout",
    "Result",
    "ResultFile",
    "read",
]
