"""Two partners that stay strangers: a bearing and the structures that carry its raceways."""

from flexbearing.coupling.loop import Ending, Iteration, newton, relaxed
from flexbearing.coupling.partners import Bearing, PartnerFailed, State, Structure

__all__ = ["Bearing", "Ending", "Iteration", "PartnerFailed", "State", "Structure", "newton", "relaxed"]
