"""The answer of a result in a few lines, with the facts of the first page of its report."""

from flexbearing.report.card.card import Card, Item, Line
from flexbearing.report.card.facts import of_result

__all__ = ["Card", "Item", "Line", "of_result"]
