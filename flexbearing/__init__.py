"""Rolling bearings with thin, flexible rings: quasi-dynamics coupled with finite elements."""

from flexbearing.api import check, explain, read, run

__all__ = ["check", "explain", "read", "run"]
