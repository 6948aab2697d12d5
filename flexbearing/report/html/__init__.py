"""Reports as one HTML file each, which opens without a network and prints."""

from flexbearing.report.html.result import of_result
from flexbearing.report.html.study import of_study
from flexbearing.report.html.units import IMPERIAL, METRIC, SYSTEMS, Units
from flexbearing.report.html.write import html

__all__ = ["IMPERIAL", "METRIC", "SYSTEMS", "Units", "html", "of_result", "of_study"]
