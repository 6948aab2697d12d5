"""How results of ball bearings are shown."""

from flexbearing.report import (
    angular_figures,
    angular_tables,
    ball_page,
    four_point_figures,
    four_point_tables,
)
from flexbearing.report.look import Look

FOUR_POINT = Look(four_point_tables.summary, ball_page.four_point_page, four_point_figures.pictures)
ANGULAR = Look(angular_tables.summary, ball_page.angular_page, angular_figures.pictures)
