"""Sliced rollers on both raceways: load, traction, rolling shear, film."""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.film import Film, FilmLaw, starved_film
from quasidynamic.contact.line import EXPONENT, SMALLEST_LOAD, LoadLaw, Slices
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.traction import RollingShear, TractionLaw
from quasidynamic.parts.oil_properties import Lubricant


class RacewayState(NamedTuple):
    """Forces of the raceways on the rollers, with derivatives.

    Array shapes: 2 raceways (inner, outer), C cases, Z rollers, M axial modes, K slices.
    """

    slice_load: NDArray  # (2, C, Z, K) [N/m]
    force: NDArray  # (2, M, C, Z) [N] conjugate to the shape coefficients; [:, 0] is the load
    force_by_approach: NDArray  # (2, M, M, C, Z) [N/m]
    traction: NDArray  # (2, C, Z) [N] signed like the sliding
    traction_by_approach: NDArray  # (2, M, C, Z) [N/m]
    traction_by_sliding: NDArray  # (2, C, Z) [N s/m]
    traction_by_entrainment: NDArray  # (2, C, Z) [N s/m]
    traction_by_film: NDArray  # (2, C, Z) [N/m]
    rolling: RollingShear  # (2, C, Z) each
    film: Film  # (2, C, Z) each; derivatives by load [m/N] instead of line load


@dataclass(frozen=True, kw_only=True)
class Raceways:
    """Both raceways with their rollers: laws and constants of the pairs, inner first."""

    law: LoadLaw
    traction: TractionLaw
    film_law: FilmLaw
    lubrication: Lubrication
    slices: Slices
    drop: NDArray  # (K, 2, 1, 1) or (K, 2, C, 1) drop of roller and raceway [m]
    radius: NDArray  # (2, 1, 1) or (2, C, 1) [m] reduced
    modulus: NDArray  # (2, 1, 1) or (2, C, 1) [Pa] E'

    @cached_property
    def softness(self) -> NDArray:
        """Approach of a straight roller at either raceway per load^0.9 (2, 1 or C, 1) [m/N^0.9]."""
        return (self.law.coefficient * self.slices.length) ** (-1 / EXPONENT)

    @cached_property
    def smallest_load(self) -> NDArray:
        """Load of a roller (2, 1 or C, 1) [N] under which its film is held: `SMALLEST_LOAD` E' R l."""
        return SMALLEST_LOAD * self.slices.length * self.modulus * self.radius

    @cached_property
    def _squared_smallest_load(self) -> NDArray:
        return self.smallest_load**2

    @property
    def oil(self) -> Lubricant:
        """The oil at the inlets."""
        return self.lubrication.oil

    def state(self, approach: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> RacewayState:
        """Load [N], traction, inlet shear and film [m] of all rollers at both raceways, with derivatives.

        The approach (2, M, C, Z) [m] are coefficients of the axial modes, film included, profile drop not;
        the sliding (2, C, Z) [m/s] is raceway over roller surface, the entrainment (2, C, Z) [m/s] the mean
        surface speed, > 0; the traction law uses the film (2, C, Z) [m].

        Source
        ------
        The laws named in `law`, `traction`, `film_law` and `lubrication`, summed over slices.
        """
        slices = self.slices  # first axis from here on: what is the same for all of them broadcasts
        q, stiffness = self.law(slices.spread(approach.swapaxes(0, 1)) - self.drop)
        pull = self.traction(q, sliding, entrainment, film)
        force = slices.summed(q).swapaxes(0, 1)
        load = force[:, 0]
        return RacewayState(
            slice_load=q.transpose(1, 2, 3, 0),
            force=force,
            force_by_approach=slices.paired(stiffness).transpose(2, 0, 1, 3, 4),
            traction=slices.total(pull.force),
            traction_by_approach=slices.summed(pull.by_load * stiffness).swapaxes(0, 1),
            traction_by_sliding=slices.total(pull.by_sliding),
            traction_by_entrainment=slices.total(pull.by_entrainment),
            traction_by_film=slices.total(pull.by_film),
            rolling=self.rolling(load, entrainment),
            film=self.film(load, sliding, entrainment),
        )

    def rolling(self, load: NDArray, entrainment: NDArray) -> RollingShear:
        """Inlet shear at roller loads (2, C, Z) [N] and mean surface speeds [m/s]."""
        geometry = (self.radius, self.modulus, self.slices.length)
        return self.lubrication.rolling(load, entrainment, geometry, self.oil)

    def film(self, load: NDArray, sliding: NDArray, entrainment: NDArray) -> Film:
        """Film of roller loads (2, C, Z) [N], at the mean load per length; derivatives by load [m/N]."""
        floored = np.sqrt(load * load + self._squared_smallest_load)
        line_load = floored / self.slices.length
        film = self.film_law(line_load, sliding, entrainment)
        if self.lubrication.inlet_length is not None:
            film = starved_film(film, line_load, self.radius, self.modulus, self.lubrication.inlet_length)
        by_load = film.by_line_load * load / (self.slices.length * floored)
        return Film(film.thickness, by_load, film.by_sliding, film.by_entrainment)
