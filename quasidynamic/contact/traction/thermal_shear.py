"""Stress of a film that may warm by its own shear."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from quasidynamic.contact.traction.film_strip import LoadedStrip, ShearStress
from quasidynamic.errors import NotSolved, require_positive
from quasidynamic.parts.oil_properties import Lubricant


@dataclass(frozen=True, kw_only=True)
class WallProperties:
    """What conducts the heat of the film away; the numbers are those of bearing steel."""

    conductivity: float = 46.0  # [W/(m K)]
    density: float = 7850.0  # [kg/m3]
    heat_capacity: float = 460.0  # [J/(kg K)] per mass

    def __post_init__(self):
        for name in ("conductivity", "density", "heat_capacity"):
            require_positive(f"walls.{name}", getattr(self, name))

    @property
    def diffusivity(self) -> float:
        """Chi = k/(rho c) [m2/s]."""
        return self.conductivity / (self.density * self.heat_capacity)


STEEL_WALLS = WallProperties()


def roelands(pressure: NDArray, oil: Lubricant) -> tuple[NDArray, NDArray]:
    r"""Viscosity under pressure, and its derivative.

    .. math:: \eta = \eta_0 \exp\{(\ln\eta_0 + 9.67)[(1 + p/p_r)^Z - 1]\},\quad
              Z = \alpha p_r/(\ln\eta_0 + 9.67),\; p_r = 1.962\cdot 10^8\,\mathrm{Pa}

    Parameters
    ----------
    pressure : array (...)
        p [Pa]
    oil : Lubricant
        eta0 and alpha at the inlet

    Returns
    -------
    tuple of array (...)
        viscosity [Pa s], its derivative by pressure [s]

    Source
    ------
    Roelands (1966).
    """
    reference = 1.962e8
    span = np.log(oil.viscosity) + 9.67
    exponent = oil.pressure_viscosity * reference / span
    ratio = 1 + pressure / reference
    power = np.exp(exponent * np.log(ratio))  # four times faster than a power
    viscosity = oil.viscosity * np.exp(span * (power - 1))
    return viscosity, viscosity * span * exponent * power / (ratio * reference)


class ThermalThinning(NamedTuple):
    """Fall of ln(viscosity) per heat flux tau u_s of the film [m2/W], with its derivatives."""

    value: NDArray | float
    by_log_load: NDArray | float  # d/d ln q of the floored load
    by_entrainment: NDArray | float  # [m s/W]
    by_film: NDArray | float  # [m/W]


def thermal_thinning(
    strip: LoadedStrip, entrainment: NDArray, film: NDArray, oil: Lubricant, walls: WallProperties
) -> ThermalThinning:
    r"""How much of ln(viscosity) a heat flux takes away by warming film and walls.

    .. math:: \eta = \eta(\bar p)\, e^{-\beta \Delta T},\quad
              \Delta T = \Big[\frac{h}{8 k_{oil}} + \frac{2}{3}\sqrt{\frac{2}{\pi}}
              \frac{1}{k}\sqrt{\frac{\chi b}{u + \chi/b}}\Big] \tau u_s

    First term: heat tau u_s/h per volume, made evenly across the film and conducted to two walls of
    one temperature; the rise is that of the middle plane (the mean of the parabola is 2/3 of it).
    Second term: each wall takes half of the heat flux and passes the strip 2b with the speed u,
    one-dimensional conduction into the wall, mean over the strip. chi/b keeps the rise finite where
    the heat source is no longer fast.

    Parameters
    ----------
    strip : LoadedStrip
        half-width b [m]
    entrainment : array (...)
        u [m/s], >= 0, taken for the speed of both walls
    film : array (...)
        h [m]
    oil : Lubricant
        beta [1/K] and k_oil
    walls : WallProperties
        k and chi

    Returns
    -------
    ThermalThinning
        beta Delta T over tau u_s [m2/W]

    Source
    ------
    Carslaw and Jaeger (1959), secs 2.9 and 3.14; Archard (1959). Arana, Larranaga and Ulacia (2019),
    Eqs (26) to (28) with q/(2 b l) as the heat flux: 1.06 = (4/3) sqrt(2/pi), half to each wall.

    Valid
    -----
    Peclet number u b/chi above about 5 and sliding below the entrainment speed; below, an order of
    magnitude. beta is that of ambient pressure.
    """
    chi, b = walls.diffusivity, strip.half_width
    speed = entrainment * b + chi
    wall = oil.temperature_viscosity * np.sqrt(8 / (9 * np.pi)) / walls.conductivity
    wall = wall * b * np.sqrt(chi / speed)
    across = oil.temperature_viscosity / (8 * oil.conductivity)
    return ThermalThinning(
        value=across * film + wall,
        by_log_load=wall * (0.5 - 0.25 * entrainment * b / speed),  # b ~ load^(1/2)
        by_entrainment=-0.5 * wall * b / speed,
        by_film=across,
    )


class ColdFilm(NamedTuple):
    """Film and its shearing at the temperature of the inlet."""

    speed: NDArray  # [m/s] |u_s|
    thickness: NDArray  # [m]
    viscosity: NDArray  # [Pa s]
    by_pressure: NDArray  # [s] of the viscosity


class FlowCurve(NamedTuple):
    """Stress over its scale as a function of the rate eta u_s/(scale h), rising."""

    value: Callable[[NDArray], tuple[NDArray, NDArray]]  # and its slope, at a rate
    start: Callable[[NDArray, NDArray], NDArray]  # guess of ln(hot rate) from ln(cold rate) and warmth


def self_heated_stress(
    curve: FlowCurve,
    scale: tuple[NDArray | float, float],
    strip: LoadedStrip,
    film: ColdFilm,
    thinning: ThermalThinning | None,
) -> ShearStress:
    r"""Stress of a film that warms by its own shear.

    .. math:: \tau = \sigma f(X e^{-a f}),\quad X = \eta u_s/(\sigma h),\quad a = \sigma u_s \theta

    The derivatives follow from ``df = g (d ln X - f da)/(1 + a g)``, g = df/d ln(rate).

    Parameters
    ----------
    curve : FlowCurve
        f [-] of the rate
    scale : tuple
        sigma, such as the Eyring stress [Pa], > 0, and its power of the load [-]
    strip : LoadedStrip
        mean pressure [Pa]
    film : ColdFilm
        u_s >= 0 [m/s], h [m] and eta [Pa s] at the temperature of the inlet
    thinning : ThermalThinning or None
        theta, fall of ln(viscosity) per heat flux [m2/W]; None for an isothermal film

    Returns
    -------
    ShearStress
        tau [Pa], with its derivatives

    Raises
    ------
    NotSolved
        when the temperature of the film is not found

    Source
    ------
    Flow curve at the viscosity of the warm film; root and derivatives are derived here.
    """
    sigma, power = scale
    rate_per_speed = film.viscosity / (sigma * film.thickness)
    flux = sigma * film.speed  # heat flux at f = 1
    if thinning is None:
        rate, hot_over_cold, a = rate_per_speed * film.speed, 1.0, 0.0
        thinning = ThermalThinning(0.0, 0.0, 0.0, 0.0)
    else:
        cold = rate_per_speed * film.speed + 1e-300  # its logarithm exists without sliding
        a = thinning.value * flux
        rate = np.exp(_log_hot_rate(curve, np.log(cold), a))
        hot_over_cold = rate / cold
    f, slope = curve.value(rate)
    stress = sigma * f
    damping = 1 + a * slope * rate
    by_log_rate = sigma * slope * rate / damping
    log_viscosity = 0.5 * strip.pressure * film.by_pressure / film.viscosity  # by ln load: p ~ load^(1/2)
    heat = f * flux
    return ShearStress(
        stress=stress,
        by_log_load=power * stress
        + by_log_rate * (log_viscosity - power - power * a * f - heat * thinning.by_log_load),
        by_sliding=sigma * slope * rate_per_speed * hot_over_cold * (1 - a * f) / damping,
        by_entrainment=-by_log_rate * heat * thinning.by_entrainment,
        by_film=-by_log_rate * (1 / film.thickness + heat * thinning.by_film),
    )


def _log_hot_rate(curve: FlowCurve, cold: NDArray, warmth: NDArray) -> NDArray:
    """Root y of y + warmth f(e^y) = cold, all logarithms of rates, to 1e-12.

    The left side rises with a slope of at least one, so the root is within the residual of any y;
    Newton steps that leave this bracket are replaced by halving.
    """
    tolerance, limit = 1e-12, 100
    y = curve.start(cold, warmth)
    low, high = -np.inf, np.inf
    for _ in range(limit):
        rate = np.exp(y)
        f, slope = curve.value(rate)
        residual = y + warmth * f - cold
        if not np.any(np.abs(residual) > tolerance * (1 + np.abs(cold))):
            return y
        low = np.maximum(low, y - np.maximum(residual, 0.0))
        high = np.minimum(high, y - np.minimum(residual, 0.0))
        newton = y - residual / (1 + warmth * slope * rate)
        y = np.where((newton < low) | (newton > high), 0.5 * (low + high), newton)
    worst = float(np.nanmax(np.abs(residual)))
    raise NotSolved(f"film temperature: residual {worst:.1e} of ln(viscosity) after {limit} steps")


def _bair_winer(rate: NDArray) -> tuple[NDArray, NDArray]:
    """1 - exp(-rate) and its slope."""
    remaining = np.expm1(-rate)
    return -remaining, 1 + remaining


EYRING = FlowCurve(
    value=lambda rate: (np.arcsinh(rate), 1 / np.sqrt(1 + rate * rate)),
    # asinh(e^y) >= max(0, y + ln 2): never below the root, and Newton comes down without overshoot
    start=lambda cold, warmth: np.minimum(cold, (cold - warmth * np.log(2.0)) / (1 + warmth)),
)
BAIR_WINER = FlowCurve(
    value=_bair_winer,
    start=lambda cold, warmth: np.maximum(cold - warmth, np.minimum(cold, 0.0)),
)
