"""Where tasks of a study are computed; what they compute is a function that is passed in."""

from flexbearing.program.worker_processes import Done
from flexbearing.studies.engine.attempts import DIED, Engine, EngineLost, TaskResult, completed, finished

__all__ = ["DIED", "Done", "Engine", "EngineLost", "TaskResult", "completed", "finished"]
