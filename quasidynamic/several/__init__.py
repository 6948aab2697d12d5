"""Several equilibria of one operating point: hints at them, a search, the one that rollers reach."""

from quasidynamic.several.indicator import several_likely
from quasidynamic.several.passage import after_passing_pitches
from quasidynamic.several.search import other_equilibria

__all__ = ["after_passing_pitches", "other_equilibria", "several_likely"]
