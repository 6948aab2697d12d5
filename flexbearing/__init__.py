"""Rolling bearings with thin, flexible rings: quasi-dynamics coupled with finite elements."""

from flexbearing.api import check, explain, read, run
from flexbearing.studies.study import study

__all__ = ["check", "explain", "read", "run", "study"]
