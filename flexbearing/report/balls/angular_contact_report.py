"""How results of a fast angular-contact ball bearing are shown."""

from flexbearing.report.balls.angular_contact_figures import balls, pictures
from flexbearing.report.balls.angular_contact_page import page
from flexbearing.report.family_report import FamilyReport

REPORT = FamilyReport(page, pictures, balls=balls)
