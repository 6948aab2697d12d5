"""A result for people: numbers, text, pictures."""

from flexbearing.report.figures import convergence, deviations, polar_loads
from flexbearing.report.shown import summary, text, write_figures

__all__ = ["convergence", "deviations", "polar_loads", "summary", "text", "write_figures"]
