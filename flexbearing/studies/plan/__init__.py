"""What a study computes, settled before anything is: variants, their identities, tasks."""

from flexbearing.studies.plan.plan import Plan, Problem, plan
from flexbearing.studies.plan.task import Row, Task, Variant

__all__ = ["Plan", "Problem", "Row", "Task", "Variant", "plan"]
