"""The answer of a result in a few lines, with the facts of the first page of its report."""

from flexbearing.report.card.facts import of_result
from flexbearing.report.card.layout import Card, Item, Line

__all__ = ["Card", "Item", "Line", "of_result"]
