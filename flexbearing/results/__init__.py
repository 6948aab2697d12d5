"""The file of a run: writing it, reading it, and the reference page of its content.

What is in it is declared in `quantities`; only this room loads h5py.
"""

from flexbearing.results.checks import NotInLayout
from flexbearing.results.read import BadResult, case_file, read
from flexbearing.results.record import Others, Record, Recorder
from flexbearing.results.result import Arrays, Result
from flexbearing.results.write import ResultFile, store

__all__ = [
    "Arrays",
    "BadResult",
    "NotInLayout",
    "Others",
    "Record",
    "Recorder",
    "Result",
    "ResultFile",
    "case_file",
    "read",
    "store",
]
