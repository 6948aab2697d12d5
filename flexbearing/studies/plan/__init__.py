"""What a study computes, settled before anything is: variants, their identities, tasks."""

from flexbearing.studies.plan.part import Part
from flexbearing.studies.plan.plan import Plan, Problem, plan
from flexbearing.studies.plan.task import Condensed, Corners, Ring, Row, Task, Variant

__all__ = ["Condensed", "Corners", "Part", "Plan", "Problem", "Ring", "Row", "Task", "Variant", "plan"]
