"""How results of a cylindrical roller bearing are shown."""

from flexbearing.report.look import Look
from flexbearing.report.roller_figures import pictures
from flexbearing.report.roller_page import page

LOOK = Look(page, pictures, deformed=True)
