"""How results of a cylindrical roller bearing are shown."""

from functools import partial

from flexbearing.quantities.roller import LAYOUT
from flexbearing.report import roller_figures, roller_page
from flexbearing.report.look import Look
from flexbearing.report.summary_values import summary

LOOK = Look(partial(summary, layout=LAYOUT), roller_page.page, roller_figures.pictures, deformed=True)
