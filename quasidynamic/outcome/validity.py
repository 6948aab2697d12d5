"""Where a solved state of a roller bearing leaves what its laws hold for."""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.cage import land_notes
from quasidynamic.contact.cage.land import couette_factor
from quasidynamic.contact.drag import drag_notes
from quasidynamic.contact.film.thickness import meniscus_factor
from quasidynamic.contact.line import half_width
from quasidynamic.contact.traction.adore import AdoreType
from quasidynamic.contact.traction.asperity_friction import Carter, RoundedCoulomb, full_slip_creep
from quasidynamic.contact.traction.mixed import Mixed
from quasidynamic.contact.traction.rheology import BairWiner, Eyring
from quasidynamic.note import Note, outside
from quasidynamic.outcome.capacity import TABULATED
from quasidynamic.outcome.equilibrium import Equilibrium
from quasidynamic.parts.material import Material

LOADED = 3e-4  # of the largest load: a roller below it at the inner raceway decides nothing
HEATED_INLET = 1.0  # [-] slide-to-roll ratio, `inlet_heating_factor`
ISOTHERMAL = 0.01  # [-] slide-to-roll ratio, `Eyring`
FAST_SOURCE = 5.0  # [-] Peclet number, `thermal_thinning`
REGIME = (0.2, 200.0)  # [-] M of `biboulet_houpert`
SHORT_INLETS = (1.0, 0.5, 0.25)  # [half-widths of the contact] examples
SPARSE = 0.1  # [-] assumed: share of oil below which nobody would call a contact flooded
STEEL = 206e9, 0.1  # [Pa] modulus of bearing steel, and by how much of it steels differ (assumed)
LENGTHS = (0.5, 2.5)  # [-] assumed: length over diameter of rollers "about as long as thick", `palmgren`
SMALL = 0.1  # [-] assumed: half-width over reduced radius or length that is no longer "far below"
TOUCHING = 0.1  # [-] assumed: share of the load on asperities whose friction matters
VORTICES = 41.0  # [-] Taylor number, `couette_factor`
TURBULENCE = 2500.0  # [-] Reynolds number, `couette_factor`


def validity(state: Equilibrium) -> tuple[Note, ...]:
    """Say which limits of its laws a solved state is beyond.

    One note of grade "outside validity" for each limit, with the value reached; none inside all of them.

    Source
    ------
    The section Valid of every law; limits that a law gives in words have numbers of ours, marked `assumed`.

    Valid
    -----
    Contacts of loaded rollers only, those with an inner load above `LOADED` of the largest load [-].
    """
    return tuple(note for check in _CHECKS for note in check(state))


def _slide_to_roll(state: Equilibrium) -> Iterator[Note]:
    lubrication, law = state.balance.roller.lubrication, _fluid(state)
    ratio = np.max(np.abs(state.sliding) / state.entrainment, where=_loaded(state), initial=0.0)
    reached = f"slide-to-roll ratio of loaded contacts up to {ratio:.3g}"
    if lubrication.inlet_heating and ratio > HEATED_INLET:
        yield outside("slide-to-roll", f"film: {reached}; heating of the inlet is a trend only above 1")
    if not isinstance(law, Eyring | BairWiner):
        return
    if not law.film_heating and ratio > ISOTHERMAL:
        yield outside(
            "slide-to-roll",
            f"traction: {reached}; an isothermal film overestimates traction above {ISOTHERMAL:g}",
            {"lubricant.film_heating": "true"},
        )
    if law.film_heating and ratio > 1.0:
        yield outside("slide-to-roll", f"traction: {reached}; film heating is an order of magnitude above 1")


def _peclet(state: Equilibrium) -> Iterator[Note]:
    law = _fluid(state)
    if not (isinstance(law, Eyring | BairWiner) and law.film_heating):
        return
    number = state.entrainment * _half_width(state)[:, None] / law.walls.diffusivity
    least = np.min(number, where=_loaded(state), initial=np.inf)
    if least < FAST_SOURCE:
        yield outside(
            "peclet-number",
            f"traction: Peclet number of loaded contacts down to {least:.3g}; the temperature of the film "
            "is an "
            f"order of magnitude below {FAST_SOURCE:g}",
        )


def _asperity_slip(state: Equilibrium) -> Iterator[Note]:
    raceways = state.balance.roller.raceways
    law = raceways.traction
    if not isinstance(law, Mixed):
        return
    friction = law.asperities
    if isinstance(friction, Carter):
        share = float(_half_width(state).max() / raceways.slices.width)
        if share > 1.0:
            yield outside(
                "slice-creep",
                f"asperity friction: half-width up to {share:.2g} widths of a slice; shear between "
                "slices is neglected",
            )
    if isinstance(friction, RoundedCoulomb):
        carried = law.share(state.film / np.reshape(law.roughness, (-1, 1)))[0]
        touching = _loaded(state) & (carried > TOUCHING)
        mean = half_width(state.loads / raceways.slices.length, raceways.radius[:, 0], raceways.modulus[:, 0])
        slipping = full_slip_creep(carried * friction.coefficient, mean, raceways.radius[:, 0])
        speed = float(np.min(slipping * state.entrainment, where=touching, initial=np.inf))
        if friction.sign_speed > speed:
            yield outside(
                "sign-speed",
                f"asperity friction: its sign changes over {friction.sign_speed:.2g} m/s, though rolling "
                f"elastic surfaces slip as a whole from {speed:.2g} m/s on: slips of cage and rollers are "
                "those of the rounding",
                {"lubricant.mixed.asperity_friction": "carter"},
            )


def _regime(state: Equilibrium) -> Iterator[Note]:
    raceways = state.balance.roller.raceways
    elastic = (raceways.modulus * raceways.radius)[:, 0]
    speed = 2 * raceways.oil.viscosity * state.entrainment / elastic
    number = state.loads / (raceways.slices.length * elastic * np.sqrt(speed))
    race, roller = np.unravel_index(np.argmax(state.loads), number.shape)
    low, high = REGIME
    if not low <= number[race, roller] <= high:
        yield outside(
            "film-regime",
            f"film and rolling shear: load number M = {number[race, roller]:.3g} of the most loaded roller "
            f"is outside {low:g} to {high:g}, where the inlet of an elastohydrodynamic contact was computed",
        )


def _flooding(state: Equilibrium) -> Iterator[Note]:
    lubrication = state.balance.roller.lubrication
    if lubrication.inlet_length is not None:
        yield outside("flooding", "rolling shear: its law is that of flooded inlets, the film is starved")
    elif lubrication.oil_fraction < SPARSE:
        yield outside(
            "flooding",
            "film: inlets are computed as fully flooded, though only "
            f"{lubrication.oil_fraction:.2g} of the mixture around the rollers is oil, so films may be "
            f"thinner: {_left_in_short_inlets(state)} (by the formula of short inlets; how far the "
            "oil reaches is not known)",
            {"lubricant.inlet_length": ""},
        )


def _left_in_short_inlets(state: Equilibrium) -> str:
    """Share of the smallest film that is left where the oil begins close before that contact."""
    raceways, loads = state.balance.roller.raceways, state.loads
    widths = half_width(loads / raceways.slices.length, raceways.radius[:, 0], raceways.modulus[:, 0])
    at = np.unravel_index(np.argmin(np.where(loads > LOADED * loads.max(), state.film, np.inf)), loads.shape)
    radius = np.broadcast_to(raceways.radius[:, 0], loads.shape)[at]
    factors = (meniscus_factor(widths[at], state.film[at], radius, inlet).factor for inlet in SHORT_INLETS)
    left = ", ".join(f"{100 * float(factor):.2g} %" for factor in factors)
    where = ", ".join(f"{inlet:g}" for inlet in SHORT_INLETS)
    return f"with oil that begins {where} half-widths before the contact the smallest film keeps {left}"


def _materials(state: Equilibrium) -> Iterator[Note]:
    bearing = state.balance.roller.bearing
    parts: dict[str, Material] = {
        "rollers": bearing.roller.material,
        "inner ring": bearing.inner_ring,
        "outer ring": bearing.outer_ring,
    }
    modulus, spread = STEEL
    other = [
        f"{name} {part.youngs_modulus / 1e9:.3g} GPa"
        for name, part in parts.items()
        if abs(part.youngs_modulus / modulus - 1) > spread
    ]
    if other:
        law = "load law and " if bearing.contact_law == "iso16281" else ""
        yield outside(
            "material", f"{law}life: their laws are for bearing steel; Young's modulus of {', '.join(other)}"
        )


def _proportions(state: Equilibrium) -> Iterator[Note]:
    bearing = state.balance.roller.bearing
    slenderness, (short, long) = bearing.roller.length / bearing.roller.diameter, LENGTHS
    if not short <= slenderness <= long:
        yield outside(
            "roller-length",
            f"load law: rollers {slenderness:.3g} times as long as thick; it was measured on rollers of "
            f"{short:g} "
            f"to {long:g}",
        )
    low, high = TABULATED
    if not low <= bearing.diameter_ratio <= high:
        yield outside(
            "roller-diameter",
            f"life: roller over pitch diameter {bearing.diameter_ratio:.3g} is outside {low:g} to {high:g}",
        )


def _contact_size(state: Equilibrium) -> Iterator[Note]:
    raceways = state.balance.roller.raceways
    smallest = np.minimum(raceways.radius[:, 0, 0], raceways.slices.length)
    share = float((_half_width(state) / smallest).max())
    if share > SMALL:
        yield outside(
            "contact-size",
            f"contact: half-width up to {share:.2g} of its radius or length; Hertz requires far less",
        )


def _land_flow(state: Equilibrium) -> Iterator[Note]:
    cage, oil, points = (
        state.balance.roller.bearing.cage,
        state.balance.roller.lubrication.oil,
        state.balance.points,
    )
    if cage.guidance == "rollers":
        return
    speed = points.guiding_speed(cage.guidance)[0, 0] - state.cage_speed
    radius, gap = cage.land_diameter / 2, cage.land_clearance / 2
    reynolds = oil.density * radius * gap / oil.viscosity * abs(speed)
    taylor = reynolds * np.sqrt(gap / radius)
    factor = float(couette_factor(reynolds, gap / radius).factor)
    if cage.land_flow == "laminar" and (taylor > VORTICES or reynolds > TURBULENCE):
        yield outside(
            "land-flow",
            f"cage land: Taylor number {taylor:,.0f}, Reynolds number {reynolds:,.0f}; laminar up to "
            f"{VORTICES:g} and {TURBULENCE:g}, and computed as laminar: vortices raise the friction of the "
            f"land {factor:.2g} times, and with it the drive or drag of the cage",
            {"bearing.cage.land_flow": "vortices"},
        )
    outer_faster = abs(points.outer_speed[0, 0]) > abs(state.cage_speed)
    if cage.land_flow == "vortices" and taylor > VORTICES and cage.guidance == "outer" and outer_faster:
        yield outside("land-flow", "cage land: no vortices form where the outer surface is the faster one")


def _land_centre(state: Equilibrium) -> Iterator[Note]:
    if state.cage_offset is not None:
        clearance = state.balance.roller.bearing.cage.land_clearance
        yield from land_notes(np.hypot(*state.cage_offset) / (clearance / 2))


def _drag(state: Equilibrium) -> Iterator[Note]:
    bearing, lubrication = state.balance.roller.bearing, state.balance.roller.lubrication
    if lubrication.drag_coefficient is None:
        speed = abs(state.cage_speed) * bearing.pitch_diameter / 2
        oil = lubrication.oil
        yield from drag_notes(oil.density * bearing.roller.diameter / oil.viscosity * speed)


def _churning(state: Equilibrium) -> Iterator[Note]:
    gap, radius = (
        state.balance.roller.lubrication.churning_gap,
        state.balance.roller.bearing.roller.diameter / 2,
    )
    if gap is not None and gap > SMALL * radius:
        yield outside(
            "churning-gap",
            f"churning: gap of {gap / radius:.2g} roller radii; its law requires a gap far below the radius",
        )


def _traction_data(state: Equilibrium) -> Iterator[Note]:
    law = _fluid(state)
    if isinstance(law, AdoreType):
        yield from law.rheology.notes(law.oil.temperature, state.peak_pressure)


_CHECKS: tuple[Callable[[Equilibrium], Iterator[Note]], ...] = (
    _slide_to_roll,
    _peclet,
    _asperity_slip,
    _regime,
    _flooding,
    _materials,
    _proportions,
    _contact_size,
    _land_flow,
    _land_centre,
    _drag,
    _churning,
    _traction_data,
)


def _loaded(state: Equilibrium) -> NDArray:
    """Contacts (2, Z) of the rollers that carry load; others slide at the outer raceway as they like."""
    inner = state.loads[0]
    return np.broadcast_to(inner > LOADED * state.loads.max(), state.loads.shape)


def _fluid(state: Equilibrium) -> object:
    """Traction law of the film, with or without asperities around it."""
    law = state.balance.roller.raceways.traction
    return law.fluid if isinstance(law, Mixed) else law


def _half_width(state: Equilibrium) -> NDArray:
    """Half-width (2) of the most loaded slice [m]."""
    raceways = state.balance.roller.raceways
    largest = state.slice_loads.max(axis=(1, 2))
    return half_width(largest, raceways.radius[:, 0, 0], raceways.modulus[:, 0, 0])
