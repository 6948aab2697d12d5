"""Two partners that stay strangers: a bearing and the structures that carry its raceways."""

from flexbearing.coupling.acceleration import RULES, Rule, relaxed
from flexbearing.coupling.loop import Ending, Iteration, alternate, newton
from flexbearing.coupling.partners import Bearing, Condensed, PartnerFailed, State, Structure

__all__ = [
    "RULES",
    "Bearing",
    "Condensed",
    "Ending",
    "Iteration",
    "PartnerFailed",
    "Rule",
    "State",
    "Structure",
    "alternate",
    "newton",
    "relaxed",
]
