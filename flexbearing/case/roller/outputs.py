"""The section [outputs] of a roller bearing."""

from flexbearing.case.outputs import LifeOutputs
from flexbearing.case.quantity import key


class Outputs(LifeOutputs):
    """What is computed beside the solution."""

    stresses: bool = key(
        "whether the largest stresses of the flexible parts at the end state, and the stiffness of their "
        "supports, are stored: a full solid for each part costs seconds",
        False,
    )
