"""What a study computes, known before anything is: variants, their identities, tasks."""

from flexbearing.studies.plan.plan import Impossible, Part, Plan, Problem, plan
from flexbearing.studies.plan.task import Condensed, Corners, Ring, Row, Task, Variant

__all__ = [
    "Condensed", "Corners", "Impossible", "Part", "Plan", "Problem", "Ring", "Row", "Task", "Variant", "plan",
]  # fmt: skip
