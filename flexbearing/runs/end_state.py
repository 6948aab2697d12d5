"""An end state of a case with what the case adds to it: roughness, edge stress, static rating."""

from typing import TYPE_CHECKING

from flexbearing.build.ring_parts import outer_mass
from flexbearing.build.rough_surfaces import roughness
from flexbearing.case.roller import Case
from flexbearing.coupled.states import EndState
from flexbearing.coupling import LinearPair
from flexbearing.runs import life
from quasidynamic import Equilibrium

if TYPE_CHECKING:
    from quasidynamic.outcome.whole_roller import WholeRoller


def end_state(
    case: Case,
    state: Equilibrium,
    rings: LinearPair,
    *,
    error: float | None = None,
    whole: "WholeRoller | None" = None,
) -> EndState:
    """The equilibrium of a case between its rings.

    Parameters
    ----------
    case : Case
        of the state
    state : Equilibrium
        solved
    rings : LinearPair
        between which it was found
    error : float, optional
        estimated, of the life over the life
    whole : WholeRoller, optional
        the roller of the state that half-spaces answer for

    Returns
    -------
    EndState
    """
    bearing, slices = state.balance.roller.bearing, state.balance.roller.raceways.slices.count
    return EndState(
        state,
        rings,
        roughness(case),
        error,
        whole,
        edge_stress=life.edge_stress(case, slices),
        static_rating=life.static(case, bearing),
        outer_mass=outer_mass(case),
    )
