"""Film, traction and friction of tapered rollers that roll without slip in the middle of their contacts."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.drag import churning_torque
from quasidynamic.contact.drag.orbit_drag import roller_drag_force
from quasidynamic.contact.film import FilmLaw, starved_film
from quasidynamic.contact.line.load_law import SMALLEST_LOAD
from quasidynamic.contact.lubrication import Lubrication
from quasidynamic.contact.traction.film_strip import friction_intensity
from quasidynamic.errors import ImpossiblePart
from quasidynamic.tapered import TaperedLoads

SIDE = np.array([1.0, -1.0])[:, None, None]  # of the roller's surface along its motion: inner, outer contact


@dataclass(frozen=True)
class TaperedFriction:
    r"""What rollers and rib resist motion with, and where it becomes heat. Z rollers, K slices; inner first.

    With the speeds of the raceway and of the roller's surface at places s of a contact, in the frame of the
    cage and along its motion,

    .. math:: v_r = (\Omega - \omega_c)(r + s \sin\alpha),\quad v_w = \pm\omega_w (D/2 + s \sin\varepsilon),

    slices slide by u = v_r - v_w, zero in the middle, and roll by (v_r + v_w)/2. Tractions of u, the shear R
    of the inlet on both surfaces, friction of the rib, drag and churning act on the roller; forces T of both
    raceways in the middle of the contacts, where nothing slides, keep it in balance about the axis of the
    bearing and about its own:

    .. math:: T_i r_i + T_o r_o = F_D r_m - A,\quad (T_i - T_o) D/2 = M_C - B

    with A and B what the other forces of the raceways and of the rib add up to. So the power that the rings
    put in is the heat of all causes.

    Source
    ------
    Statics and kinematics of rigid rollers, derived here; the laws of rollers for every slice.

    Valid
    -----
    As long as T is below what film and asperities transmit; friction has no part in the loads. The moments
    that would skew the rollers are left to cage and rib without friction.
    """

    loads: TaperedLoads
    lubrication: Lubrication
    rib_friction: float  # [-] Coulomb

    def __post_init__(self):
        if not self.loads.operation.relative_speed:
            raise ImpossiblePart("friction of rings that turn alike, or not at all: nothing rolls")

    # -- motion --------------------------------------------------------------------------------

    @cached_property
    def radii(self) -> tuple[NDArray, NDArray]:
        """Of the raceways from the axis of the bearing, and of the roller from its own (2, 1, K) [m]."""
        bearing, s = self.loads.bearing, self.loads.slices.centres
        cone, cup = np.sin([bearing.cone_angle, bearing.cup_angle])
        raceways = np.array([bearing.inner_radius + s * cone, bearing.outer_radius + s * cup])
        roller = bearing.roller.diameter / 2 + s * np.sin(bearing.taper)
        return raceways[:, None], np.broadcast_to(roller, (2, 1, len(s)))

    @cached_property
    def speeds(self) -> tuple[NDArray, NDArray]:
        """Of raceways and rollers' surfaces against the cage, along its motion (2, 1, K) [m/s]."""
        operation, (raceways, rollers) = self.loads.operation, self.radii
        rings = np.array([operation.inner_speed, operation.outer_speed]) - self.loads.speeds.orbit
        return rings[:, None, None] * raceways, SIDE * self.loads.speeds.spin * rollers

    @cached_property
    def sliding(self) -> NDArray:
        """Of the raceways over the rollers (2, 1, K) [m/s]; rounded to zero in the middle of the contacts."""
        raceways, rollers = self.speeds
        return raceways - rollers

    @cached_property
    def rolling(self) -> NDArray:
        """Mean of both surface speeds (2, 1, K) [m/s], signed."""
        raceways, rollers = self.speeds
        return (raceways + rollers) / 2

    # -- laws ----------------------------------------------------------------------------------

    @cached_property
    def _radius(self) -> NDArray:
        return np.array([self.loads.reduced_radius(race) for race in (0, 1)])[:, None]

    @property
    def _modulus(self) -> NDArray:
        return self.loads.moduli[:, None, None]

    @property
    def _smallest(self) -> NDArray:
        """Load per length (2, 1, K) [N/m] under which a film is held."""
        return SMALLEST_LOAD * self._modulus * self._radius

    @property
    def loaded_film(self) -> NDArray:
        """Film of every slice (2, Z, K) [m], zero without load."""
        return np.where(self.loads.slice_loads > self._smallest, self.film, 0.0)

    @cached_property
    def film(self) -> NDArray:
        """Film of every slice at its own load per length (2, Z, K) [m]; of open slices that of hardly any."""
        laws, line_load = self.lubrication, np.hypot(self.loads.slice_loads, self._smallest)
        law = FilmLaw(
            formula=laws.film,
            radius=self._radius,
            modulus=self._modulus,
            oil=laws.oil,
            inlet_heating=laws.inlet_heating,
        )
        film = law(line_load, self.sliding, np.abs(self.rolling))
        if laws.inlet_length is not None:
            film = starved_film(film, line_load, self._radius, self._modulus, laws.inlet_length)
        return film.thickness

    @cached_property
    def traction(self) -> NDArray:
        """Of every slice on the roller, along the motion (2, Z, K) [N]."""
        loads, laws = self.loads, self.lubrication
        law = laws.traction(
            radius=self._radius, modulus=self._modulus, length=loads.slices.length, oil=laws.oil
        )
        pull = law(loads.slice_loads, self.sliding, np.abs(self.rolling), self.film)
        return pull.force * loads.slices.widths

    @cached_property
    def inlet_shear(self) -> NDArray:
        """Shear of every slice's inlet (2, Z, K) [N] on either surface, against the rolling; >= 0."""
        loads, laws = self.loads, self.lubrication
        widths = loads.slices.widths
        geometry = self._radius, self._modulus, widths
        return laws.rolling(loads.slice_loads * widths, np.abs(self.rolling), geometry, laws.oil).force

    @cached_property
    def rib_force(self) -> NDArray:
        """Friction of the rib on the rollers' ends (Z) [N] along the motion."""
        return np.sign(self.loads.speeds.rib_sliding) * self.rib_friction * self.loads.rib_loads

    @cached_property
    def drag(self) -> float:
        """Force of the mixture on one roller against its way around the bearing [N], signed like that."""
        laws, bearing = self.lubrication, self.loads.bearing
        speed = np.asarray(self.loads.speeds.orbit * bearing.pitch_diameter / 2)
        area = bearing.roller.length * bearing.roller.diameter
        stream = laws.oil, laws.oil_fraction, laws.drag_coefficient
        return float(roller_drag_force(speed, area, bearing.roller.diameter, *stream)[0])

    @cached_property
    def churning(self) -> float:
        """Torque of the mixture against the spin of a roller [N m], signed like it; zero without a gap."""
        laws, bearing = self.lubrication, self.loads.bearing
        if laws.churning_gap is None:
            return 0.0
        spin = np.asarray(self.loads.speeds.spin)
        torque = churning_torque(
            spin, bearing.roller, laws.oil, oil_fraction=laws.oil_fraction, gap=laws.churning_gap
        )
        return float(torque.torque)

    # -- balance -------------------------------------------------------------------------------

    @cached_property
    def _by_slices(self) -> tuple[NDArray, NDArray]:
        """Torques of tractions and inlets that the rings must put in, and those on the spin (2, Z) [N m]."""
        raceways, rollers = self.radii
        shear = np.sign(self.rolling) * self.inlet_shear
        on_rings = (raceways * (self.traction + shear)).sum(-1)
        on_rollers = (SIDE * rollers * (self.traction - shear)).sum(-1)
        return on_rings, on_rollers

    @cached_property
    def rolling_traction(self) -> NDArray:
        """T of both raceways (2, Z) [N] along the motion, in the middle of the contacts, without sliding."""
        bearing = self.loads.bearing
        on_rings, on_rollers = (each.sum(0) for each in self._by_slices)
        about_bearing = self.drag * bearing.pitch_diameter / 2
        about_bearing = about_bearing - on_rings - self.rib_force * bearing.rib_radius
        about_roller = self.churning - on_rollers - self.rib_force * bearing.rib.depth
        inner, outer, half = bearing.inner_radius, bearing.outer_radius, bearing.roller.diameter / 2
        difference = about_roller / half
        on_inner = (about_bearing + difference * outer) / (inner + outer)
        return np.array([on_inner, on_inner - difference])

    @cached_property
    def traction_share(self) -> NDArray:
        """T and sliding tractions over the load (2, Z) [-], zero without load: what films must transmit."""
        pull = np.abs(self.rolling_traction) + np.abs(self.traction).sum(-1)
        loads = self.loads.loads
        return np.divide(pull, loads, out=np.zeros_like(pull), where=loads > 0)

    @cached_property
    def torques(self) -> NDArray:
        """Torque that each roller makes the inner and the outer ring need (2, Z) [N m] along their motion."""
        bearing = self.loads.bearing
        middle = np.array([bearing.inner_radius, bearing.outer_radius])[:, None]
        on_rings = self._by_slices[0] + middle * self.rolling_traction
        on_rings[0] += self.rib_force * bearing.rib_radius
        return on_rings

    @property
    def torque(self) -> NDArray:
        """Torque that keeps the inner and the outer ring turning (2) [N m]."""
        return self.torques.sum(1)

    @property
    def power(self) -> float:
        """Power that both rings put in [W]."""
        operation = self.loads.operation
        return float(self.torque @ [operation.inner_speed, operation.outer_speed])

    # -- heat ----------------------------------------------------------------------------------

    @cached_property
    def sliding_heat(self) -> NDArray:
        """Heat of the sliding of each roller on both raceways (2, Z) [W]."""
        return (self.traction * self.sliding).sum(-1)

    @property
    def friction_intensity(self) -> NDArray:
        """Largest heat of sliding per area (2, Z) [W/m2] of the slices of each contact."""
        load = self.loads.slice_loads
        pull = self.traction / self.loads.slices.widths
        return friction_intensity(pull, self.sliding, load, self._radius, self._modulus).max(-1)

    @cached_property
    def rolling_heat(self) -> NDArray:
        r"""Heat of the inlets of each roller (2, Z) [W], 2 R |u| of both surfaces.

        Source
        ------
        Work of the shear on both surfaces, whose mean speed is u.
        """
        return (2 * self.inlet_shear * np.abs(self.rolling)).sum(-1)

    @cached_property
    def rib_heat(self) -> NDArray:
        """Heat of each roller's end on the rib (Z) [W]."""
        return self.rib_force * self.loads.speeds.rib_sliding

    @property
    def drag_heat(self) -> float:
        """Heat of the drag on all rollers [W]."""
        bearing, orbit = self.loads.bearing, self.loads.speeds.orbit
        return bearing.all_rollers * self.drag * orbit * bearing.pitch_diameter / 2

    @property
    def churning_heat(self) -> float:
        """Heat of the churning around all rollers [W]."""
        return self.loads.bearing.all_rollers * self.churning * self.loads.speeds.spin
