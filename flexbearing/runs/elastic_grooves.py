"""What a user must know of elastic grooves: contacts off their stations, patches unlike the contacts."""

from math import degrees, sqrt

import numpy as np

from flexbearing.case.balls.angular_contact import FastCase
from quasidynamic import AngularContactState
from quasidynamic.balance.balls.elastic_grooves import FURTHEST
from quasidynamic.note import Note, information, outside

GAUSSIAN = sqrt(5.0)  # semi-axis of an ellipse of Hertz over the standard deviation of its pressure
UNLIKE = 1.5  # width of patches over that of the largest contact, or the inverse, from which there is a note


def notes(case: FastCase, state: AngularContactState) -> tuple[Note, ...]:
    """Notes on the elastic grooves of a state; none between rigid rings."""
    if state.groove_displacement is None:
        return ()
    from flexbearing.rings import grooves  # finite elements are not described between rigid rings

    race_notes: tuple[Note, ...] = ()
    for race, (name, arguments) in enumerate(zip(grooves.RACES, grooves.parts(case), strict=True)):
        if arguments is None:
            continue
        stations, across = arguments[2].stations, state.semi_axes[0][race]
        assert stations  # of every part with a groove
        last = max(map(abs, stations.angles))
        beyond = (np.abs(state.contact_angles[race]) > last + FURTHEST) & (state.loads[race] > 0)
        if beyond.any():
            race_notes += (
                outside(
                    "beyond-stations",
                    f"{int(beyond.sum())} balls press the {name} groove beyond "
                    f"{degrees(last + FURTHEST):.1f} deg, where it is taken as stiff as there",
                ),
            )
        usual = float(across.max()) / GAUSSIAN  # of the heaviest ball
        if usual and not 1 / UNLIKE < stations.width / usual < UNLIKE:
            race_notes += (
                information(
                    "patch-width",
                    f"balls press the {name} groove by patches of {1e3 * stations.width:.2g} mm, the largest "
                    f"contact is like one of {1e3 * usual:.2g} mm: give that as accuracy.patch_width to see "
                    "what it changes",
                ),
            )
    return race_notes
