"""The scalar outputs of a run by name, in any unit of the right kind.

Names, units and reductions follow from `quantities`; files, cases and models are unknown here.
"""

from flexbearing.outputs.names import (
    AbsentOutput,
    Output,
    RequestedOutput,
    UnknownOutput,
    of_rollers,
    outputs,
    requested,
)
from flexbearing.outputs.table import Outputs
from flexbearing.outputs.value import Value, WrongUnit

__all__ = [
    "AbsentOutput",
    "Output",
    "Outputs",
    "RequestedOutput",
    "UnknownOutput",
    "Value",
    "WrongUnit",
    "of_rollers",
    "outputs",
    "requested",
]
