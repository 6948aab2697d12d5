"""Two partners that stay strangers: a bearing and the structures that carry its raceways."""

from flexbearing.coupling.acceleration import RULES, Rule, relaxed
from flexbearing.coupling.loop import Iteration, StoppingCriterion, fixed_point, newton
from flexbearing.coupling.partners import Bearing, Condensed, PartnerFailed, State, Structure

__all__ = [
    "RULES",
    "Bearing",
    "Condensed",
    "Iteration",
    "PartnerFailed",
    "Rule",
    "State",
    "StoppingCriterion",
    "Structure",
    "fixed_point",
    "newton",
    "relaxed",
]
