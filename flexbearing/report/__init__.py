"""A result for people: summary, page, pictures; what is shown of a quantity is declared in `quantities`."""

from flexbearing.report.output import pictures, text, write_figures
from flexbearing.report.roller.figures import convergence, deviations, polar_loads
from flexbearing.report.summary_values import summary

__all__ = ["convergence", "deviations", "pictures", "polar_loads", "summary", "text", "write_figures"]
