"""How results of a slow ball bearing are shown."""

from flexbearing.report.balls.four_point_figures import balls, pictures
from flexbearing.report.balls.four_point_page import page
from flexbearing.report.family_report import FamilyReport

REPORT = FamilyReport(page, pictures, balls=balls)
