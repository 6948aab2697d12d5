"""What results of every bearing that is coupled with its rings say of the iterations and of the rings."""

from flexbearing.quantities import roller_records as records
from flexbearing.quantities.attributes import Attribute
from flexbearing.quantities.quantity import Quantity

LOAD_ERRORS = ROLLER_LOAD, BALL_LOAD = "roller_load", "ball_load"  # names of estimated errors
METHOD = Attribute("method", "text", "method of the coupling")
ATTEMPTS = Attribute(
    "attempts",
    "json",
    "methods of the coupling in the order they were tried, with their ends",
    form=records.ATTEMPTS,
)
STRESSES = Attribute(
    "stresses",
    "json",
    "largest stresses of the flexible parts at the end state, and of roller bearings the stiffness of their "
    "supports; absent without outputs.stresses",
    optional=True,
    form=records.STRESSES,
)
STRUCTURE = Attribute(
    "structure",
    "json",
    "figures of the finite elements: unknowns, seconds per stage; what lines, springs and fits carry",
    form=records.STRUCTURE,
)
CHOICES = Attribute(
    "choices",
    "json",
    "levels that accuracy.target led to, by choice: the level, whether the case fixes it, the level it "
    "was compared with, the changes found, the error over a change, and the error allowed; absent "
    "without a target",
    optional=True,
    form=records.CHOICES,
)
ERROR_ESTIMATE = Attribute(
    "error_estimate",
    "json",
    "estimated numerical errors of the flexible block, over the values but for the cage slip; the "
    "target, and whether it is met; absent without a target, empty where nothing could be estimated",
    optional=True,
    form=records.ERROR_ESTIMATE,
)
# fmt: off
ITERATIONS = (
    Quantity("load_change", "", "", "1", "iteration", "largest change of a load / largest load",
        source="step.load_change"),
    Quantity("mismatch", "", "", "1", "iteration",
        "deviation that the rings return, less the one that the bearing was given / largest deviation; "
        "0 where both are one system", source="step.mismatch"),
    Quantity("residual", "", "", "1", "iteration", "largest unbalanced force / applied load",
        source="step.state.residual"),
    Quantity("seconds", "", "", "s", "iteration", "time that the iteration took", source="seconds"),
)
# fmt: on
