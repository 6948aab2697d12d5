"""Numbers of tables as sentences have them."""

from math import degrees

from flexbearing.report.html.document import Number
from flexbearing.report.html.reader import Reader


def rounded(number: Number, times: float = 1.0) -> str:
    """A number of a table, or a multiple of it, with three digits for a sentence: 489,719 is 490,000."""
    value = times * number.size
    return f"{float(f'{value:.3g}'):,.10g}"


def load_axis(reader: Reader) -> str:
    """Where the radial load acts, against the z axis.

    It is along z unless the case gives `operation.load_direction`, the azimuth of the load.
    """
    azimuth = degrees(reader.attributes["case_si"].get("operation", {}).get("load_direction") or 0.0)
    return f"at azimuth {azimuth:.4g}° (operation.load_direction)" if azimuth else "along z"
