"""Where tasks of a study are computed; what they compute is a function that is passed in."""

from flexbearing.program.processes import Done
from flexbearing.studies.engine.attempts import DIED, TaskResult, completed, finished
from flexbearing.studies.engine.engine import Engine, EngineLost

__all__ = ["DIED", "Done", "Engine", "EngineLost", "TaskResult", "completed", "finished"]
