"""The section [outputs] of roller bearings."""

from flexbearing.case.outputs import RingOutputs
from flexbearing.case.quantity import key


class Outputs(RingOutputs):
    """What is computed beside the solution."""

    stresses: bool = key(
        "whether the largest stresses of the flexible parts at the end state, and the stiffness of their "
        "supports, are stored: a full solid for each part costs seconds",
        False,
    )
