"""Rolling shear in the inlet of a lubricated contact, of line contacts but for one law of ellipses.

Every law returns the same quantity: the shear force F of one raceway on one roller, by the pressure gradient
in the inlet (F_t of Biboulet and Houpert). The pressure force that belongs to it is 2 F (1 -/+ gamma) on the
roller at the inner/outer raceway; the "pumping force" of other texts is that one.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.parts.oil_properties import Lubricant

LOAD_ROUNDING = 1e-3  # of M: the rigid-isoviscous branch begins like sqrt(M), infinitely steep
RIGID = 1.4 / 0.985  # F / (l E' R U2^0.75 sqrt M) of a rigid contact with constant viscosity
ELASTIC = 1.45 / 0.985  # F / (l E' R U2^0.75) of an elastohydrodynamic one

BLUNT = (
    0.77,
    1.8,
)  # F / (2 a E' R U2^0.75) of a rigid and of an elastohydrodynamic ellipse, without their groups
HALF_WAY = 6.6  # [-] M of an ellipse halfway between both

Geometry = tuple[NDArray | float, ...]


class RollingShear(NamedTuple):
    """Shear force [N] of the inlet on either surface, with its derivatives."""

    force: NDArray
    by_load: NDArray  # [-]
    by_entrainment: NDArray  # [N s/m]


RollingLaw = Callable[[NDArray, NDArray, Geometry, Lubricant], RollingShear]


class _Groups(NamedTuple):
    """Load and speed without units."""

    speed: NDArray  # U2 = 2 eta0 u / (E' R)
    root_speed: NDArray  # sqrt U2
    weight: NDArray  # l E' R sqrt U2 [N]
    regime: NDArray  # M = Q / (l E' R sqrt U2)


class _Ceiling(NamedTuple):
    """F / (l E' R U2^0.75) of a law away from zero load, as a function of U2 and M + LOAD_ROUNDING."""

    value: NDArray | float
    slope_by_speed: NDArray | float = 0.0  # d ln value / d ln U2
    slope_by_regime: NDArray | float = 0.0  # d ln value / d ln(M + LOAD_ROUNDING)


def biboulet_houpert(load: NDArray, entrainment: NDArray, geometry: Geometry, oil: Lubricant) -> RollingShear:
    r"""Inlet shear force, blending rigid-isoviscous and elastohydrodynamic contacts.

    .. math:: \frac{F}{l E' R} = \frac{U_2^{0.75}}{0.985}\,
              \frac{1.4 \sqrt M}{[1 + (\frac{1.4}{1.45} \sqrt M)^{10}]^{1/10}},\quad
              U_2 = \frac{2\eta_0 u}{E' R},\; M = \frac{W}{\sqrt{U_2}},\; W = \frac{Q}{l E' R}

    F is F_t of the source; the pressure force is F_n = 2 F, exactly, on the equivalent cylinder.
    sqrt(M) is rounded to M / sqrt(M + LOAD_ROUNDING).

    Parameters
    ----------
    load : array (...)
        Q [N], >= 0
    entrainment : array (...)
        u, mean of the surface speeds [m/s], > 0
    geometry : tuple of arrays (...)
        reduced radius R [m], E' [Pa], length l [m]; anything that broadcasts with the load
    oil : Lubricant
        eta0 at the inlet

    Source
    ------
    Biboulet and Houpert, Proc. IMechE J 224 (2010), Part 1, Eq. (42).

    Valid
    -----
    M from 0.2 to 200, flooded, isothermal.
    """
    groups = _groups(load, entrainment, geometry, oil)
    return _below_rigid_limit(groups, _Ceiling(ELASTIC), load, entrainment)


def dowson_higginson(load: NDArray, entrainment: NDArray, geometry: Geometry, oil: Lubricant) -> RollingShear:
    r"""Inlet shear force of the classical skidding programs, independent of the load.

    .. math:: \frac{F}{l E' R} = 9.2\, G^{-0.3} U^{0.7},\quad U = \frac{\eta_0 u}{E' R},\; G = \alpha E'

    F is half of the pumping force 18.4 (1 -/+ gamma) G^-0.3 U^0.7 of the same source. At M of a few and below
    it is blended, as in `biboulet_houpert`, with the rigid-isoviscous contact, which no inlet exceeds: 2 to 3
    percent less than printed at M = 2.

    Arguments as of `biboulet_houpert`, alpha at the inlet; >= 0, zero without load.

    Source
    ------
    Dowson and Higginson, Elastohydrodynamic Lubrication (1966), as used by Harris, Rolling Bearing Analysis.

    Valid
    -----
    Elastohydrodynamic, flooded, isothermal.
    """
    groups = _groups(load, entrainment, geometry, oil)
    material = 9.2 * 0.5**0.7 * (oil.pressure_viscosity * geometry[1]) ** -0.3
    return _below_rigid_limit(groups, _Ceiling(material * groups.speed**-0.05, -0.05), load, entrainment)


def zhou_hoeprich(load: NDArray, entrainment: NDArray, geometry: Geometry, oil: Lubricant) -> RollingShear:
    r"""Inlet shear force that rises with the load.

    .. math:: \frac{F}{l E' R} = 18.62\, U_2^{0.648} W^{0.246} G^{-0.352}

    F is F_t, half of the pressure force. Blended with the rigid-isoviscous contact as `dowson_higginson`.

    Arguments as of `biboulet_houpert`, alpha at the inlet; >= 0, zero without load.

    Source
    ------
    Zhou and Hoeprich, J. Tribology 113 (1991), in the normalisation of Biboulet and Houpert (2010), Eq. (38).

    Valid
    -----
    Tapered roller bearings, flooded, isothermal.
    """
    groups = _groups(load, entrainment, geometry, oil)
    material = 18.62 * (oil.pressure_viscosity * geometry[1]) ** -0.352
    by_speed = 0.648 + 0.246 / 2 - 0.75  # W = M sqrt(U2)
    rise = (groups.regime + LOAD_ROUNDING) ** 0.246
    ceiling = _Ceiling(material * groups.speed**by_speed * rise, by_speed, 0.246)
    return _below_rigid_limit(groups, ceiling, load, entrainment)


def goksem_hargreaves(
    load: NDArray, entrainment: NDArray, geometry: Geometry, oil: Lubricant
) -> RollingShear:
    r"""Inlet shear force of an inlet that heats itself.

    .. math:: \frac{F}{l E' R} = \frac{K W}{G},\quad
              \ln K = (0.658228 + 0.0106383\, L^{0.31746}) \ln D
              - [0.162625 + \ln(1 + 0.411483\, L^{0.707071})],\\
              D = 11.8122\, G U W^{-1.5},\; L = \eta_0 \beta u^2 / k

    F is F_t, half of the pressure force. An oil with beta = 0 gives the isothermal law, within half a percent
    2.74 U2^0.658 W^0.0126 G^-0.342. Blended with the rigid-isoviscous contact as `dowson_higginson`; the
    latter without heating.

    Arguments as of `biboulet_houpert`; alpha, beta and the conductivity k are those at the inlet. The force
    is >= 0, zero without load; at L above 0.5 it falls slowly with a growing load.

    Source
    ------
    Goksem and Hargreaves, J. Lubrication Technology 100 (1978), as programmed in a public torque code.

    Valid
    -----
    Elastohydrodynamic, flooded.
    """
    groups = _groups(load, entrainment, geometry, oil)
    material = oil.pressure_viscosity * geometry[1]
    regime = groups.regime + LOAD_ROUNDING
    thermal = oil.viscosity * oil.temperature_viscosity / oil.conductivity * entrainment**2  # L
    steeper, weaker = 0.0106383 * thermal**0.31746, 0.411483 * thermal**0.707071
    exponent = 0.658228 + steeper
    root = np.sqrt(groups.speed)
    log_drive = np.log(0.5 * 11.8122 * material * np.sqrt(root) / (regime * np.sqrt(regime)))
    gain = np.exp(exponent * log_drive - 0.162625) / (1 + weaker)
    by_log_thermal = 0.31746 * steeper * log_drive - 0.707071 * weaker / (1 + weaker)
    ceiling = _Ceiling(
        gain * regime / (material * np.sqrt(root)),
        0.25 * exponent - 0.25 + 2 * by_log_thermal,  # L ~ U2^2
        1 - 1.5 * exponent,
    )
    return _below_rigid_limit(groups, ceiling, load, entrainment)


def ellipse_shear(load: NDArray, entrainment: NDArray, geometry: Geometry, oil: Lubricant) -> RollingShear:
    r"""Inlet shear force of an ellipse, from rigid-isoviscous to elastohydrodynamic ones.

    .. math:: \frac{F}{2 a E' R} = U_2^{0.75} \left[\frac{0.77\, \beta^{-1/3} \kappa^{0.12} U_2^{-1/12}
              - 1.8\, \beta^{-1/4}}{1 + M/6.6} + 1.8\, \beta^{-1/4}\right],\quad
              M = \beta^{1/4} \frac{\kappa Q}{E' R^2} U_2^{-3/4}

    U2 as of `biboulet_houpert`. Heavy contacts have 1.8/1.47 times the shear of a line contact as long: oil
    is sheared beside the ellipse too. Light ones are blended with the rigid line contact as long, as in
    `dowson_higginson`, below the source, whose shear exceeds what the traction of light balls overcomes.

    Parameters
    ----------
    load : array (...)
        Q [N], >= 0
    entrainment : array (...)
        u, mean of the surface speeds [m/s], > 0
    geometry : tuple of arrays (...)
        R along the rolling direction [m], E' [Pa], length 2 a across it [m], kappa = b/a [-] and
        beta = b E' / (pi p0 R) [-]
    oil : Lubricant
        eta0 at the inlet

    Source
    ------
    Biboulet and Houpert, Proc. IMechE J 224 (2010), Part 2, Eqs (30) to (32).

    Valid
    -----
    kappa below 1, Q/(2 a E' R sqrt(U2)) from 4 on and M up to 800, flooded, isothermal. 2 a far below the
    diameter of the ball, which cuts off some percent of the shear at 0.4 times it (Eq. 35 of the source).
    """
    radius, _, length, ratio, beta = geometry
    groups = _groups(load, entrainment, geometry, oil)
    per_regime = beta**0.25 * ratio * length / radius * groups.speed**-0.25
    shifted = per_regime * (groups.regime + LOAD_ROUNDING)  # M
    light = BLUNT[0] * beta ** (-1 / 3) * ratio**0.12 * groups.speed ** (-1 / 12)
    heavy = BLUNT[1] * beta**-0.25
    share = 1 / (1 + shifted / HALF_WAY)
    value = heavy + (light - heavy) * share
    by_regime = (heavy - light) * share * (1 - share) / value
    ceiling = _Ceiling(value, -(light * share / value) / 12 - by_regime / 4, by_regime)
    return _below_rigid_limit(groups, ceiling, load, entrainment)


ROLLING_LAWS: dict[str, RollingLaw] = {
    "biboulet-houpert": biboulet_houpert,
    "dowson-higginson": dowson_higginson,
    "zhou-hoeprich": zhou_hoeprich,
    "goksem-hargreaves": goksem_hargreaves,
}
BALL_ROLLING_LAWS = ROLLING_LAWS | {
    "biboulet-houpert": ellipse_shear
}  # the others: lines as long as the ellipse


def _groups(load: NDArray, entrainment: NDArray, geometry: Geometry, oil: Lubricant) -> _Groups:
    radius, modulus, length = geometry[:3]
    elastic = modulus * radius
    speed = 2 * oil.viscosity / elastic * entrainment
    root_speed = np.sqrt(speed)
    weight = length * elastic * root_speed
    return _Groups(speed, root_speed, weight, load / weight)


def _below_rigid_limit(
    groups: _Groups, ceiling: _Ceiling, load: NDArray, entrainment: NDArray
) -> RollingShear:
    """Smooth lesser of a law and the rigid-isoviscous limit, with derivatives."""
    regime = groups.regime
    shifted = regime + LOAD_ROUNDING
    part = regime / shifted
    square = (RIGID / ceiling.value) ** 2 * part * regime  # of the limit over the law
    fourth = square * square
    tenth = fourth * fourth * square
    total = 1 + tenth
    share = tenth / total  # of the law in the logarithmic slopes; the rest is the limit's
    tenth_root = np.exp(0.1 * np.log(total))
    per_load = RIGID * np.sqrt(groups.root_speed / shifted) / tenth_root  # F / Q
    force = per_load * load
    rigid = 1 - 0.5 * part
    by_log_load = rigid + share * (ceiling.slope_by_regime * part - rigid)
    by_log_speed = 0.75 + share * ceiling.slope_by_speed - 0.5 * by_log_load  # M ~ U2^-0.5
    return RollingShear(force, per_load * by_log_load, force * by_log_speed / entrainment)
