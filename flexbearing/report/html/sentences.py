"""Numbers of tables as sentences have them."""

from flexbearing.report.html.document import Number


def rounded(number: Number, times: float = 1.0) -> str:
    """A number of a table, or a multiple of it, with three digits for a sentence: 489,719 is 490,000."""
    value = times * float(number.text.replace(",", ""))
    return f"{float(f'{value:.3g}'):,.10g}"
