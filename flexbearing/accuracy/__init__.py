"""Accuracy on order: levels of discretisation, climbed until the estimated error is small enough."""

from flexbearing.accuracy.ladder import Choice, Found, Unusable, Verdict, climb

__all__ = ["Choice", "Found", "Unusable", "Verdict", "climb"]
