"""How results of a cylindrical roller bearing are shown."""

from flexbearing.report import figures, page, tables
from flexbearing.report.look import Look

LOOK = Look(tables.summary, page.page, figures.pictures, deformed=True)
