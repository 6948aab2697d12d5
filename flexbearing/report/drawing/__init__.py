"""Drawings to scale of what a case describes; nothing is solved for them."""

from flexbearing.report.drawing.sheet import Drawing

__all__ = ["Drawing"]
