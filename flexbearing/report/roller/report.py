"""How results of a cylindrical roller bearing are shown."""

from flexbearing.report.family_report import FamilyReport
from flexbearing.report.roller.figures import pictures
from flexbearing.report.roller.page import page

REPORT = FamilyReport(page, pictures, deformed=True)
