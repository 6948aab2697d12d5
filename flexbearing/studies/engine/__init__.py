"""Where tasks of a study are computed; what they compute is a function that is passed in."""

from flexbearing.studies.engine.attempts import DIED, Ended, completed, finished
from flexbearing.studies.engine.engine import Done, Engine

__all__ = ["DIED", "Done", "Ended", "Engine", "completed", "finished"]
