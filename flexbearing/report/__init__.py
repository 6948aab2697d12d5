"""A result for people: page and pictures; what is shown of a quantity is declared in `quantities`."""

from flexbearing.report.output import compared_pictures, laid_out, pictures, text, write_figures
from flexbearing.report.roller.figures import convergence, deviations, polar_loads

__all__ = [
    "compared_pictures",
    "convergence",
    "deviations",
    "laid_out",
    "pictures",
    "polar_loads",
    "text",
    "write_figures",
]
