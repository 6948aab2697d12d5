"""The study file: which values the keys of a case take, and which outputs are wanted of every variant."""

from flexbearing.studies.file.axes import Axis
from flexbearing.studies.file.read import Study, read

__all__ = ["Axis", "Study", "read"]
