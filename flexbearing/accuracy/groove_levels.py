"""What a case of balls between elastic rings leaves open to the accuracy requested: a ladder a choice."""

from flexbearing.accuracy.case_levels import ABOVE, BELOW, WEIGHT, Cost, Ladder, counted, fixed, given
from flexbearing.accuracy.ladder import Choice
from flexbearing.case.balls.angular_contact import FastCase
from flexbearing.case.balls.groove_accuracy import ORDER

STATIONS = (5, 7, 9, 11, 13, 15)  # the last only measures
ORDERS = (2, 3, 4, 5, 6, 7)  # of elements that grow with them on the grooves
MESH_KEYS = ("element_order", "mesh_size")


def ladders(case: FastCase) -> tuple[Ladder, ...]:
    """Everything that can be resolved more or less finely; the width of the patches is that of contacts."""
    return _stations(case), _elements(case)


def _stations(case: FastCase) -> Ladder:
    """Stations grow two at a time, as their number is odd."""
    if given(case, "stations"):
        counts = tuple(case.accuracy.stations + more for more in (0, 2, 4))
        return fixed("stations", "stations", counts, Cost.SECTION)
    return counted("stations", "stations", STATIONS, Cost.SECTION)


def _elements(case: FastCase) -> Ladder:
    """Orders of the elements; a mesh that the case gives is only measured, by the next order."""
    fixed_by, order = given(case, *MESH_KEYS), case.accuracy.element_order or ORDER
    orders = (order, order + 1) if fixed_by else ORDERS
    choice = Choice(
        name="elements",
        levels=tuple(f"order {order}" for order in orders),
        weight=WEIGHT[Cost.SECTION],
        last=0 if fixed_by else None,
        fixed_by=fixed_by,
        above=ABOVE[Cost.SECTION],
        below=BELOW[Cost.SECTION],
    )
    return Ladder(choice, tuple({"element_order": order} for order in orders), cost=Cost.SECTION)
