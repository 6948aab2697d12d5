"""Rolling bearings with thin, flexible rings: quasi-dynamics coupled with finite elements."""

from flexbearing.api import check, explain, read, read_result, run, summary

__all__ = ["check", "explain", "read", "read_result", "run", "summary"]
