"""A result for people: numbers, text, pictures."""

from flexbearing.report.figures import convergence, deviations, polar_loads, write_figures
from flexbearing.report.page import text
from flexbearing.report.tables import summary

__all__ = ["convergence", "deviations", "polar_loads", "summary", "text", "write_figures"]
