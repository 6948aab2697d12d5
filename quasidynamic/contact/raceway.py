"""One sliced roller on one raceway: load, traction, rolling shear, film."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.film import dowson_minimum_film, inlet_heating_factor
from quasidynamic.contact.load import LoadLaw
from quasidynamic.contact.rolling import RollingShear, biboulet_houpert
from quasidynamic.contact.slices import Slices
from quasidynamic.contact.traction import TractionLaw
from quasidynamic.parts.lubricant import Lubricant

FILM_LOAD_FLOOR = 30.0  # [N] keeps the film of a grazing roller from depending on its own load


class ContactState(NamedTuple):
    """Forces of one raceway on its Z rollers, with derivatives; M axial shapes, K slices."""

    slice_load: NDArray  # (Z, K) [N/m]
    force: NDArray  # (Z, M) [N] conjugate to the shape coefficients; [:, 0] is the load
    force_by_approach: NDArray  # (Z, M, M) [N/m]
    traction: NDArray  # (Z) [N] signed like the sliding
    traction_by_approach: NDArray  # (Z, M) [N/m]
    traction_by_sliding: NDArray  # (Z) [N s/m]
    traction_by_entrainment: NDArray  # (Z) [N s/m]
    rolling: RollingShear  # (Z) each


@dataclass(frozen=True, kw_only=True)
class RacewayContact:
    """A raceway with its rollers: laws and constants of the pair."""

    law: LoadLaw
    traction: TractionLaw
    slices: Slices
    drop: NDArray  # (K) profile drop [m]
    radius: float  # [m] reduced
    modulus: float  # [Pa] E'
    oil: Lubricant
    inlet_heating: bool = True

    def state(self, approach: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> ContactState:
        """Evaluate the contact.

        Parameters
        ----------
        approach : array (Z, M)
            coefficients of the axial shapes [m], film included, profile drop not
        sliding : array (Z)
            raceway over roller surface [m/s]
        entrainment : array (Z)
            mean surface speed [m/s], > 0
        film : array (Z)
            thickness [m] used by the traction law

        Returns
        -------
        ContactState
        """
        slices = self.slices
        q, stiffness = self.law(approach @ slices.shape.T - self.drop)
        pull = self.traction(q, sliding[:, None], entrainment[:, None], film[:, None])
        force = q @ slices.shape * slices.width
        by_approach = (stiffness @ slices.products).reshape(*force.shape, -1) * slices.width
        return ContactState(
            slice_load=q,
            force=force,
            force_by_approach=by_approach,
            traction=pull.force.sum(1) * slices.width,
            traction_by_approach=(pull.by_load * stiffness) @ slices.shape * slices.width,
            traction_by_sliding=pull.by_sliding.sum(1) * slices.width,
            traction_by_entrainment=pull.by_entrainment.sum(1) * slices.width,
            rolling=biboulet_houpert(
                force[:, 0], entrainment, (self.radius, self.modulus, slices.length), self.oil
            ),
        )

    def film(self, load: NDArray, sliding: NDArray, entrainment: NDArray) -> NDArray:
        """Film thickness (Z) [m] at the mean load per length; floor `FILM_LOAD_FLOOR` on the load."""
        line_load = np.hypot(load, FILM_LOAD_FLOOR) / self.slices.length
        film = dowson_minimum_film(line_load, entrainment, self.radius, self.modulus, self.oil)
        if self.inlet_heating:
            film = film * inlet_heating_factor(entrainment, sliding, self.oil)
        return film
