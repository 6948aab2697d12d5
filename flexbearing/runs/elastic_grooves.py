"""What a user must know of elastic grooves: contacts off their stations, patches unlike the contacts."""

from math import degrees, sqrt

from numpy.typing import NDArray

from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.four_point import FourPointCase
from quasidynamic.balance.balls.elastic_grooves import extrapolated
from quasidynamic.note import Note, information, outside

GAUSSIAN = sqrt(5.0)  # semi-axis of an ellipse of Hertz over the standard deviation of its pressure
UNLIKE = 1.5  # width of patches over that of the largest contact, or the inverse, from which there is a note


def notes(
    case: FastCase | FourPointCase, angles: NDArray, loads: NDArray, across: NDArray
) -> tuple[Note, ...]:
    """Notes on elastic grooves of a case that is solved, under contacts by race (2, ...).

    Contact angles are in rad, loads in N, the semi-axes `across` along the arc in m.
    """
    from flexbearing.rings import grooves  # finite elements are not described between rigid rings

    race_notes: tuple[Note, ...] = ()
    for race, (name, arguments) in enumerate(zip(grooves.RACES, grooves.parts(case), strict=True)):
        if arguments is None:
            continue
        stations = arguments[2].stations
        assert stations  # of every part with a groove
        first, last = extrapolated(stations.angles)
        beyond = ((angles[race] < first) | (angles[race] > last)) & (loads[race] > 0)
        if beyond.any():
            race_notes += (
                outside(
                    "beyond-stations",
                    f"{int(beyond.sum())} contacts press the {name} groove outside {degrees(first):.1f} to "
                    f"{degrees(last):.1f} deg, where it is taken as stiff as there",
                ),
            )
        usual = float(across[race].max()) / GAUSSIAN  # of the heaviest ball
        if usual and not 1 / UNLIKE < stations.width / usual < UNLIKE:
            race_notes += (
                information(
                    "patch-width",
                    f"balls press the {name} groove by patches of {1e3 * stations.width:.2g} mm, the largest "
                    f"contact is like one of {1e3 * usual:.2g} mm: give that as "
                    f"{grooves.accuracy_of(case)[0]}.patch_width to see what it changes",
                ),
            )
    return race_notes
