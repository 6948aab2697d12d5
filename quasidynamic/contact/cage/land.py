"""Oil film between the cage and the land that guides it."""

from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.note import Note, outside
from quasidynamic.parts.oil_properties import Lubricant

if TYPE_CHECKING:  # balls load no rollers
    from quasidynamic.parts.ball_cage import BallCage
    from quasidynamic.parts.roller_bearing import Cage

ECCENTRICITY_LIMIT = 0.995  # beyond it the film functions go on along their tangent, see `land_notes`
LANDS = ("outer", "inner")  # rings whose land may guide a cage
OFFSET_ITERATIONS = 60  # Newton's method on a convex function from above: a light land takes about twenty
OFFSET_TOLERANCE = 1e-14  # of the clearance
SMALLEST_OFFSET = 1e-9  # of the clearance: a centred cage has no direction
SHARPNESS = 8  # of the smooth maximum; the factor is 9 percent above the greater one where two regimes meet


class LandTorque(NamedTuple):
    """Torque of the land on the cage."""

    torque: NDArray  # [N m] signed like the speed difference
    by_speed: NDArray  # [N m s]
    by_eccentricity: NDArray  # [N m]


class LandOffset(NamedTuple):
    """Offset of the cage in its land."""

    offset: NDArray  # (..., 2) [m] components y and z
    by_force: NDArray  # (..., 2, 2) [m/N] component of the offset, component of the force
    by_speed: NDArray  # (..., 2) [m s]


class LandForce(NamedTuple):
    """Force of the land on the cage."""

    force: NDArray  # (..., 2) [N] components y and z
    by_offset: NDArray  # (..., 2, 2) [N/m] component of the force, component of the offset
    by_speed: NDArray  # (..., 2) [N s]


def land_drag(cage: "Cage | BallCage", oil: Lubricant) -> float:
    r"""Torque of the guiding land per speed difference, concentric and laminar.

    .. math:: M/\Delta\omega = 2 \pi \eta_0 R^3 L / c

    Parameters
    ----------
    cage : Cage or BallCage
        land radius R, total width L, radial clearance c
    oil : Lubricant
        eta0

    Returns
    -------
    float
        [N m s]; zero when rollers or balls guide the cage

    Source
    ------
    Petroff (1883).

    Valid
    -----
    Full oil film, no Taylor vortices, concentric cage.
    """
    if cage.guidance not in LANDS:
        return 0.0
    radius = cage.land_diameter / 2
    return 2 * np.pi * oil.viscosity * radius**3 * cage.land_width / (cage.land_clearance / 2)


def land_torque(
    speed_difference: NDArray | float,
    cage: "Cage | BallCage",
    oil: Lubricant,
    eccentricity: NDArray | float = 0.0,
) -> LandTorque:
    r"""Torque of the guiding land, laminar, with vortices or turbulent.

    .. math:: M = \frac{2 \pi \eta_0 R^3 L\, \Delta\omega}{c \sqrt{1 - e^2}} \frac{f}{f_L}

    Parameters
    ----------
    speed_difference : array (...)
        guiding ring minus cage [rad/s]
    cage : Cage or BallCage
        land radius R, total width L, radial clearance c
    oil : Lubricant
        eta0, density
    eccentricity : array (...)
        e, offset of the cage centre over c [-], >= 0

    Returns
    -------
    LandTorque
        odd in the speed difference, with continuous derivatives; zero when rollers or balls guide the cage

    Source
    ------
    Petroff (1883); eccentric short bearing after DuBois and Ocvirk, NACA Report 1157 (1953);
    f/f_L see `couette_factor`; one when the cage's `land_flow` is taken as laminar.

    Valid
    -----
    Land full of oil; e up to `ECCENTRICITY_LIMIT`. The factor is that of a concentric gap.
    """
    if cage.guidance not in LANDS:
        nothing = np.zeros(np.broadcast_shapes(np.shape(speed_difference), np.shape(eccentricity)))
        return LandTorque(nothing, nothing, nothing)
    resistance: Any = land_drag(cage, oil)
    slope: Any = 0.0
    if cage.land_flow == "vortices":
        radius, clearance = cage.land_diameter / 2, cage.land_clearance / 2
        reynolds = oil.density * radius * clearance / oil.viscosity * np.abs(speed_difference)
        factor, slope = couette_factor(reynolds, clearance / radius)
        resistance = resistance * factor
    if isinstance(eccentricity, float) and eccentricity == 0.0:  # as in nearly every evaluation
        crowding, crowding_slope = 1.0, 0.0
    else:
        crowding, crowding_slope = _film_power(eccentricity, -0.5)
    return LandTorque(
        torque=resistance * crowding * speed_difference,
        by_speed=resistance * crowding * (1 + slope) + np.zeros(np.shape(speed_difference)),
        by_eccentricity=resistance * crowding_slope * speed_difference,
    )


def land_force(
    offset: NDArray, speed_sum: NDArray | float, cage: "Cage", oil: Lubricant, lands: int = 2
) -> LandForce:
    r"""Force of a steadily eccentric land on the cage: short bearing, half of the film cavitated.

    .. math:: F_r = \frac{\eta_0 |u| L^3 e^2}{c^2 (1-e^2)^2},\quad
              F_t = \frac{\pi \eta_0 u L^3 e}{4 c^2 (1-e^2)^{3/2}},\quad u = R (\omega_c + \omega_{ring})

    F_r pushes the cage back to the centre, F_t along the offset turned by 90 degrees in the sense of positive
    speed: it drives a whirl. Both hold for a cage inside and for a cage around its land.

    Parameters
    ----------
    offset : array (..., 2)
        cage centre from the centre of the guiding ring, components y and z [m]; angles count from z to y
    speed_sum : array (...)
        cage plus guiding ring [rad/s]; F_r has a kink where it changes sign
    cage : Cage
        land radius R, total width, radial clearance c
    oil : Lubricant
        eta0
    lands : int
        number of equal lands that share the total width, each of width L

    Returns
    -------
    LandForce
        of all lands on the cage, with its derivatives; zero when the rollers guide the cage

    Source
    ------
    DuBois and Ocvirk, NACA Report 1157 (1953), half Sommerfeld condition.

    Valid
    -----
    L far below the diameter, laminar, full oil supply, no squeeze; e up to `ECCENTRICITY_LIMIT`.
    """
    speed = np.asarray(speed_sum, dtype=float)
    shape = np.broadcast_shapes(offset.shape[:-1], speed.shape)
    if cage.guidance == "rollers":
        return LandForce(np.zeros((*shape, 2)), np.zeros((*shape, 2, 2)), np.zeros((*shape, 2)))
    clearance, unit = np.asarray(cage.land_clearance / 2), np.asarray(_force_unit(cage, oil, lands))
    ratio = offset / clearance[..., None]
    size = np.sqrt((ratio**2).sum(-1))
    direction = ratio / np.maximum(size, 1e-300)[..., None]
    back, back_slope = _film_power(size, -2.0)
    along, along_slope = _film_power(size, -1.5)
    # F_r along the offset and F_t before its turn, each a size(e) times the vector e
    radial, radial_by = _central(ratio, direction, size * back, size * back_slope + back)
    tangential, tangential_by = _central(ratio, direction, np.pi / 4 * along, np.pi / 4 * along_slope)
    turned = np.array([[0.0, 1.0], [-1.0, 0.0]])  # (y, z) by 90 degrees from z to y
    sense = np.sign(speed)[..., None]
    by_speed = unit[..., None] * (tangential @ turned.T - sense * radial)
    stiffness = (unit * speed / clearance)[..., None, None]
    by_offset = stiffness * (turned @ tangential_by - sense[..., None] * radial_by)
    return LandForce(by_speed * speed[..., None], by_offset, by_speed)


def land_offset(force: NDArray, speed_sum: NDArray | float, cage: "Cage", oil: Lubricant) -> LandOffset:
    """Offset of a cage at which its land carries a force (..., 2) [N]: the inverse of `land_force`.

    The speed sum is not zero. The offset is from the centre of the guiding ring, with its derivatives by
    force and speed; not a number for a force that is not finite.

    Source
    ------
    `land_force`; both parts of the force grow with the offset, so that its size gives it.

    Valid
    -----
    As `land_force`. A centred cage has no direction: its offset is at least `SMALLEST_OFFSET` c.
    """
    clearance = cage.land_clearance / 2
    unit = _force_unit(cage, oil, lands=2) * np.abs(speed_sum)
    ratio = _eccentricity(np.hypot(force[..., 0], force[..., 1]) / unit)
    along = np.stack([ratio * clearance, np.zeros_like(ratio)], axis=-1)
    unturned = land_force(along, speed_sum, cage, oil).force
    turn = np.arctan2(force[..., 1], force[..., 0]) - np.arctan2(unturned[..., 1], unturned[..., 0])
    offset = along[..., :1] * np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    land = land_force(offset, speed_sum, cage, oil)
    by_force = np.linalg.inv(land.by_offset)
    return LandOffset(offset, by_force, -(by_force @ land.by_speed[..., None])[..., 0])


def _force_unit(cage: "Cage", oil: Lubricant, lands: int) -> float:
    """Force of all lands per speed at the land [N s], before its dependence on the eccentricity."""
    radius, clearance = cage.land_diameter / 2, cage.land_clearance / 2
    return oil.viscosity * radius * lands * (cage.land_width / lands) ** 3 / clearance**2


def _eccentricity(force: NDArray) -> NDArray:
    """Eccentricity ratio at which the film carries a force in its own unit, by Newton from above."""
    limit = _film_force(np.array(ECCENTRICITY_LIMIT))
    # Beyond the limit the force grows at least along the tangent of its value there.
    ratio = np.maximum(ECCENTRICITY_LIMIT, force / limit[0])
    for _ in range(OFFSET_ITERATIONS):
        value, slope = _film_force(ratio)
        before, ratio = ratio, np.maximum(ratio - (value - force) / slope, SMALLEST_OFFSET)
        moved = np.abs(ratio - before) > OFFSET_TOLERANCE * ratio
        if not moved.any():
            return ratio
    return np.where(moved, np.nan, ratio)


def _film_force(ratio: NDArray) -> tuple[NDArray, NDArray]:
    """Size of the film force in its unit at an eccentricity ratio > 0, with its slope."""
    back, back_slope = _film_power(ratio, -2.0)
    along, along_slope = _film_power(ratio, -1.5)
    radial, tangential = ratio**2 * back, np.pi / 4 * ratio * along
    size = np.hypot(radial, tangential)
    radial_slope = ratio * (2 * back + ratio * back_slope)
    tangential_slope = np.pi / 4 * (along + ratio * along_slope)
    return size, (radial * radial_slope + tangential * tangential_slope) / size


def land_notes(eccentricity: NDArray | float) -> tuple[Note, ...]:
    """Tell where eccentricity ratios [-] leave the validity of `land_force`; empty inside it."""
    worst = float(np.max(eccentricity))
    if worst <= ECCENTRICITY_LIMIT:
        return ()
    return (
        outside(
            "cage-land",
            f"cage land: eccentricity ratio {worst:.3g} is above {ECCENTRICITY_LIMIT}; the film force goes "
            "on along its tangent there and stands for a contact that is not modelled",
        ),
    )


def _film_power(eccentricity: NDArray | float, power: float) -> tuple[NDArray, NDArray]:
    """(1 - e^2)^power and its derivative; beyond `ECCENTRICITY_LIMIT` along the tangent there."""
    inside = np.minimum(eccentricity, ECCENTRICITY_LIMIT)
    open_film = 1 - inside**2
    value = open_film**power
    slope = -2 * power * inside * value / open_film
    return value + slope * (eccentricity - inside), slope


def _central(ratio: NDArray, direction: NDArray, size: NDArray, slope: NDArray) -> tuple[NDArray, NDArray]:
    """Vector field size(e) * ratio of the offset ratio, with its matrix of derivatives."""
    outer = ratio[..., :, None] * direction[..., None, :]
    return size[..., None] * ratio, size[..., None, None] * np.eye(2) + slope[..., None, None] * outer


class CouetteFactor(NamedTuple):
    """Friction over its laminar value."""

    factor: NDArray  # [-] >= 1
    slope: NDArray  # d ln(factor) / d ln(speed)


def couette_factor(reynolds: NDArray, gap_ratio: NDArray | float) -> CouetteFactor:
    r"""How much vortices and turbulence raise the friction of a laminar Couette flow.

    .. math:: \frac{f}{f_L} = \max\left[1,\; 1.3 \left(\frac{Ta}{41}\right)^{0.539474},\;
              3.0 \left(\frac{Re}{2500}\right)^{0.85596}\right],\quad
              Ta = Re \sqrt{c/R},\; Re = \rho V c / \eta

    The maximum is smooth, a root of the sum of powers (`SHARPNESS`). As printed, they hold below Ta = 41,
    above it, or from Re = 2500, and jump between; their maximum leaves 1 at Ta = 25 or Re = 693.

    Parameters
    ----------
    reynolds : array (...)
        Re [-] with the full speed difference V of the surfaces and the gap c, >= 0
    gap_ratio : array (...)
        c/R [-], > 0

    Returns
    -------
    CouetteFactor
        1 at rest

    Source
    ------
    Rumbarger, Filetti and Gubernick, J. Lubrication Technology 95 (1973). Its f_L = 16/Re is the friction of
    a tube and eight times that of a Couette flow with this Re, 2/Re: only the ratio is used.

    Valid
    -----
    Gap far below the radius; the faster surface inside. With the faster one outside no vortices form, and the
    Taylor factor overestimates.
    """
    vortex_exponent, turbulent_exponent = SHARPNESS * 0.539474, SHARPNESS * 0.85596
    vortex = 1.3**SHARPNESS * (np.sqrt(gap_ratio) / 41 * reynolds) ** vortex_exponent
    turbulent = 3.0**SHARPNESS * (reynolds / 2500) ** turbulent_exponent
    total = 1 + vortex + turbulent
    slope = (0.539474 * vortex + 0.85596 * turbulent) / total
    return CouetteFactor(total ** (1 / SHARPNESS), slope)
