"""How results of a slow ball bearing are shown."""

from flexbearing.report.four_point_figures import pictures
from flexbearing.report.four_point_page import page
from flexbearing.report.look import Look

LOOK = Look(page, pictures)
