"""How results of a fast angular-contact ball bearing are shown."""

from flexbearing.report.angular_contact_figures import pictures
from flexbearing.report.angular_contact_page import page
from flexbearing.report.look import Look

LOOK = Look(page, pictures)
