"""The coupling loop between a bearing and what carries its raceways, two partners that exchange arrays.

Here belong the protocols of the partners, the pair of raceways, the rules and the loop; nothing that knows
what a bearing, a ring or a file is.
"""

from flexbearing.coupling.acceleration import RULES, Rule, relaxed
from flexbearing.coupling.loop import Iteration, StoppingCriterion, fixed_point, newton
from flexbearing.coupling.partners import Bearing, LinearRaceway, PartnerFailed, Raceway, State, Structure
from flexbearing.coupling.raceway_pair import LinearPair, RacewayPair

__all__ = [
    "RULES",
    "Bearing",
    "Iteration",
    "LinearPair",
    "LinearRaceway",
    "PartnerFailed",
    "Raceway",
    "RacewayPair",
    "Rule",
    "State",
    "StoppingCriterion",
    "Structure",
    "fixed_point",
    "newton",
    "relaxed",
]
