"""Accuracy on request: ladders of levels, climbed until the estimated error is small enough.

Here belong levels, trials and estimates; what a level computes is in `build`, `rings` and `coupled`.
"""

from flexbearing.accuracy.ladder import Choice, Selection, Unusable, Verdict, climb

__all__ = ["Choice", "Selection", "Unusable", "Verdict", "climb"]
