"""Making it happen: from a case to its result file."""

from flexbearing.compute.one import run

__all__ = ["run"]
