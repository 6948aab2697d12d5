"""Traction of a fluid film from the rheology of the oil."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.contact.hertz import half_width
from quasidynamic.contact.traction import Traction
from quasidynamic.errors import NotSolved, require_positive
from quasidynamic.parts.lubricant import Lubricant


@dataclass(frozen=True, kw_only=True)
class Walls:
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


STEEL_WALLS = Walls()


@dataclass(frozen=True, kw_only=True)
class Eyring:
    r"""Eyring film with a limiting shear stress, isothermal or with its own heating.

    .. math:: \tau = \min[\tau_E \sinh^{-1}(\eta u_s/(\tau_E h)),\; \Lambda \bar p],\quad
              \bar p = \tfrac{\pi}{4} p_0

    acting on the strip of width 2b; Roelands viscosity at the mean pressure. The cap is a kink.
    With `film_heating` the viscosity is that of the film temperature, see `viscosity_loss`; the
    stress then falls with the sliding once the heating outruns the shearing.

    Source
    ------
    Evans and Johnson (1986); Arana, Larranaga and Ulacia (2019), Eqs (7), (13) and (26) to (28);
    there tau_E = 2 Lambda/alpha.

    Valid
    -----
    Isothermal: slide-to-roll ratio below about 1 %, above it overestimates. Entrainment >= 0, film > 0.
    """

    radius: NDArray | float  # [m] R
    modulus: NDArray | float  # [Pa] E'
    length: float  # [m] l
    oil: Lubricant
    limiting_ratio: float  # [-] Lambda
    eyring_stress: float  # [Pa] tau_E
    film_heating: bool = False
    walls: Walls = STEEL_WALLS
    load_floor: float = 1.0  # [N] below it strip width over load keeps its value

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; without film heating the entrainment speed enters through the film alone."""
        strip = _strip(line_load, self)
        flow = _Flow(np.abs(sliding), film, *roelands(strip.pressure, self.oil))
        loss = viscosity_loss(strip, entrainment, film, self) if self.film_heating else None
        shear = _sheared(_EYRING, (self.eyring_stress, 0.0), strip, flow, loss)
        return _pulled(_capped(shear, self.limiting_ratio * strip.pressure), strip, line_load, sliding)


@dataclass(frozen=True, kw_only=True)
class BairWiner:
    r"""Film whose stress approaches its limit exponentially, isothermal or with its own heating.

    .. math:: \tau = \tau_L [1 - \exp(-\eta u_s/(\tau_L h))],\quad \tau_L = \Lambda \bar p,\quad
              \bar p = \tfrac{\pi}{4} p_0

    acting on the strip of width 2b; Roelands viscosity at the mean pressure. Smooth everywhere.

    Source
    ------
    Bair and Winer (1979); Wingertszahn et al. (2023), Eq (6), solved for the stress.
    Heating: see `Eyring`.

    Valid
    -----
    As `Eyring`; no elastic part of the shear.
    """

    radius: NDArray | float  # [m] R
    modulus: NDArray | float  # [Pa] E'
    length: float  # [m] l
    oil: Lubricant
    limiting_ratio: float  # [-] Lambda
    film_heating: bool = False
    walls: Walls = STEEL_WALLS
    load_floor: float = 1.0  # [N] below it strip width over load keeps its value

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; without film heating the entrainment speed enters through the film alone."""
        strip = _strip(line_load, self)
        flow = _Flow(np.abs(sliding), film, *roelands(strip.pressure, self.oil))
        loss = viscosity_loss(strip, entrainment, film, self) if self.film_heating else None
        limit = self.limiting_ratio * strip.pressure
        shear = _sheared(_BAIR_WINER, (limit, 0.5), strip, flow, loss)  # limit ~ load^(1/2)
        return _pulled(shear, strip, line_load, sliding)


@dataclass(frozen=True, kw_only=True)
class AdoreOil:
    r"""Viscosity of an oil as fitted to traction, which is not the one that forms the film.

    .. math:: \eta = \eta_{313}\, e^{c (313 - T)}\, e^{\alpha p},\quad \beta = \beta_{313} (T/313)^n

    Source
    ------
    Constants as coded in a public program of the ADORE line of Gupta; the primary was not seen.

    Valid
    -----
    The ranges are quoted from memory of the literature, no table of measurements was at hand.
    """

    name: str
    pressure_viscosity: float  # [1/Pa] alpha
    viscosity_313: float  # [Pa s] at 313 K
    decay: float  # [1/K] c
    thinning_313: float  # [1/K] beta at 313 K
    thinning_power: float  # [-] n
    fitted_temperature: tuple[float, float] = (300.0, 425.0)  # [K]
    fitted_pressure: tuple[float, float] = (0.7e9, 2.0e9)  # [Pa]

    def viscosity(self, temperature: float) -> float:
        """Viscosity at ambient pressure [Pa s]; temperature in K."""
        return self.viscosity_313 * np.exp(self.decay * (313.0 - temperature))

    def temperature_viscosity(self, temperature: float) -> float:
        """Beta [1/K]; temperature in K."""
        return self.thinning_313 * (temperature / 313.0) ** self.thinning_power

    def notes(self, temperature: ArrayLike, pressure: ArrayLike) -> tuple[str, ...]:
        """Say which of temperatures [K] and pressures [Pa] leave the fitted ranges; empty if none."""
        return _range_note(f"{self.name}: temperature", temperature, self.fitted_temperature, (1.0, "K")) + (
            _range_note(f"{self.name}: pressure", pressure, self.fitted_pressure, (1e9, "GPa"))
        )


ADORE_OILS = {
    name: AdoreOil(
        name=name,
        pressure_viscosity=alpha,
        viscosity_313=viscosity,
        decay=decay,
        thinning_313=thinning,
        thinning_power=power,
    )
    for name, alpha, viscosity, decay, thinning, power in (
        ("MIL-L-7808", 5.2214e-9, 0.11431, 0.033723, 0.041745, 0.60873),
        ("MIL-L-23699", 5.8015e-9, 0.26529, 0.036358, 0.033398, 1.3075),
        ("MIL-L-27502", 5.8015e-9, 0.21655, 0.039221, 0.032577, 1.0723),
        ("Santotrac 30", 9.4275e-9, 0.40063, 0.050459, 0.034104, 1.093),
        ("Santotrac 50", 7.2519e-9, 10.076, 0.044097, 0.020794, 6.2743),
        ("Mobil DTE SAE 30", 7.2516e-9, 0.28407, 0.023743, 0.028939, 2.1402),
    )
}


@dataclass(frozen=True, kw_only=True)
class AdoreType:
    r"""Newtonian film heated by its own shear, with a limiting stress.

    .. math:: \tau = \min\Big[\frac{\eta u_s}{h}\frac{\sinh^{-1}\sqrt\psi}{\sqrt{\psi(1+\psi)}},\;
              \Lambda \bar p\Big],\quad \psi = \frac{\eta \beta u_s^2}{8 k},\quad \bar p = \tfrac{\pi}{4} p_0

    acting on the strip of width 2b, eta and beta of `AdoreOil` at the mean pressure, k of `oil`.
    The stress has its maximum where sqrt(psi) = 1.51 and falls beyond. The law itself has no
    limiting stress; the cap is an addition, is a kink, and keeps high pressures physical.

    Source
    ------
    Shear: exact solution of a Newtonian film between walls of one temperature, viscosity exponential
    in the temperature, as in the ball bearing papers after Gupta. Pairing with the oil table: inferred.

    Valid
    -----
    `rheology.notes(temperature, pressure)` says where the oil data are left. Film > 0.
    """

    radius: NDArray | float  # [m] R
    modulus: NDArray | float  # [Pa] E'
    length: float  # [m] l
    oil: Lubricant  # its temperature and conductivity
    rheology: AdoreOil
    limiting_ratio: float  # [-] Lambda
    load_floor: float = 1.0  # [N] below it strip width over load keeps its value

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the entrainment speed enters through the film alone."""
        strip = _strip(line_load, self)
        temperature = self.oil.temperature
        log_thickening = self.rheology.pressure_viscosity * strip.pressure
        viscosity = self.rheology.viscosity(temperature) * np.exp(log_thickening)
        per_heat = self.rheology.temperature_viscosity(temperature) / (8 * self.oil.conductivity)
        # with z = sqrt(psi) = u_s sqrt(per_heat eta): tau = sqrt(eta/per_heat)/h asinh(z)/sqrt(1 + z^2)
        z = np.abs(sliding) * np.sqrt(per_heat * viscosity)
        squared = 1 + z * z
        curve = np.arcsinh(z) / np.sqrt(squared)
        steepness = (1 - z * curve) / squared  # d curve / dz
        scale = np.sqrt(viscosity / per_heat) / film
        stress = scale * curve
        shear = _Shear(
            stress=stress,
            # both scale and z go with the root of eta, and ln eta = alpha p with the root of the load
            by_log_load=0.25 * log_thickening * (stress + scale * steepness * z),
            by_sliding=viscosity / film * steepness,
            by_entrainment=np.zeros_like(stress),
            by_film=-stress / film,
        )
        return _pulled(_capped(shear, self.limiting_ratio * strip.pressure), strip, line_load, sliding)


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


class Loss(NamedTuple):
    """Fall of ln(viscosity) per heat flux tau u_s of the film [m2/W], with its derivatives."""

    value: NDArray | float
    by_log_load: NDArray | float  # d/d ln q of the floored load
    by_entrainment: NDArray | float  # [m s/W]
    by_film: NDArray | float  # [m/W]


def viscosity_loss(strip: "_Strip", entrainment: NDArray, film: NDArray, law: Eyring | BairWiner) -> Loss:
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
    strip : _Strip
        half-width b [m]
    entrainment : array (...)
        u [m/s], >= 0, taken for the speed of both walls
    film : array (...)
        h [m]
    law : Eyring or BairWiner
        its oil: beta [1/K] and k_oil; its walls: k and chi

    Returns
    -------
    Loss
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
    chi, b = law.walls.diffusivity, strip.half_width
    speed = entrainment * b + chi
    wall = law.oil.temperature_viscosity * np.sqrt(8 / (9 * np.pi)) / law.walls.conductivity
    wall = wall * b * np.sqrt(chi / speed)
    across = law.oil.temperature_viscosity / (8 * law.oil.conductivity)
    return Loss(
        value=across * film + wall,
        by_log_load=wall * (0.5 - 0.25 * entrainment * b / speed),  # b ~ load^(1/2)
        by_entrainment=-0.5 * wall * b / speed,
        by_film=across,
    )


class _Strip(NamedTuple):
    """Contact strip of the floored load."""

    load_share: NDArray  # d ln load / d ln q
    half_width: NDArray  # [m] b
    pressure: NDArray  # [Pa] mean


def _strip(line_load: NDArray, law: Eyring | BairWiner | AdoreType) -> _Strip:
    squared = line_load * line_load
    floored = squared + (law.load_floor / law.length) ** 2
    load = np.sqrt(floored)
    b = half_width(load, law.radius, law.modulus)
    return _Strip(load_share=squared / floored, half_width=b, pressure=load / (2 * b))


class _Flow(NamedTuple):
    """Shearing of the film before it warms."""

    speed: NDArray  # [m/s] |u_s|
    film: NDArray  # [m]
    viscosity: NDArray  # [Pa s]
    by_pressure: NDArray  # [s] of the viscosity


class _Shear(NamedTuple):
    """Stress [Pa], >= 0, with its derivatives; the load is the floored one."""

    stress: NDArray
    by_log_load: NDArray
    by_sliding: NDArray
    by_entrainment: NDArray
    by_film: NDArray


class _Curve(NamedTuple):
    """Stress over its scale as a function of the rate eta u_s/(scale h), rising."""

    value: Callable[[NDArray], tuple[NDArray, NDArray]]  # and its slope, at a rate
    start: Callable[[NDArray, NDArray], NDArray]  # guess of ln(hot rate) from ln(cold rate) and warmth


def _sheared(
    curve: _Curve, scale: tuple[NDArray | float, float], strip: _Strip, flow: _Flow, loss: Loss | None
) -> _Shear:
    r"""Stress of a film that warms by its own shear.

    .. math:: \tau = \sigma f(X e^{-a f}),\quad X = \eta u_s/(\sigma h),\quad a = \sigma u_s \cdot loss

    The derivatives follow from ``df = g (d ln X - f da)/(1 + a g)``, g = df/d ln(rate); `scale` is
    sigma with its power of the load.
    """
    sigma, power = scale
    rate_per_speed = flow.viscosity / (sigma * flow.film)
    flux = sigma * flow.speed  # heat flux at f = 1
    if loss is None:
        rate, thinning, a, loss = rate_per_speed * flow.speed, 1.0, 0.0, Loss(0.0, 0.0, 0.0, 0.0)
    else:
        cold = rate_per_speed * flow.speed + 1e-300  # its logarithm exists without sliding
        a = loss.value * flux
        rate = np.exp(_log_hot_rate(curve, np.log(cold), a))
        thinning = rate / cold
    f, slope = curve.value(rate)
    stress = sigma * f
    damping = 1 + a * slope * rate
    by_log_rate = sigma * slope * rate / damping
    log_viscosity = 0.5 * strip.pressure * flow.by_pressure / flow.viscosity  # by ln load: p ~ load^(1/2)
    warmer = f * flux
    return _Shear(
        stress=stress,
        by_log_load=power * stress
        + by_log_rate * (log_viscosity - power - power * a * f - warmer * loss.by_log_load),
        by_sliding=sigma * slope * rate_per_speed * thinning * (1 - a * f) / damping,
        by_entrainment=-by_log_rate * warmer * loss.by_entrainment,
        by_film=-by_log_rate * (1 / flow.film + warmer * loss.by_film),
    )


def _log_hot_rate(curve: _Curve, cold: NDArray, warmth: NDArray) -> NDArray:
    """Root y of y + warmth f(e^y) = cold, all logarithms of rates, to 1e-12.

    The left side rises with a slope of at least one, so the root is within the residual of any y;
    Newton steps that leave what is known of the root are replaced by halving.
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


def _eyring(rate: NDArray) -> tuple[NDArray, NDArray]:
    return np.arcsinh(rate), 1 / np.sqrt(1 + rate * rate)


def _eyring_start(cold: NDArray, warmth: NDArray) -> NDArray:
    # asinh(e^y) >= max(0, y + ln 2): never below the root, and Newton comes down without overshoot
    return np.minimum(cold, (cold - warmth * np.log(2.0)) / (1 + warmth))


def _bair_winer(rate: NDArray) -> tuple[NDArray, NDArray]:
    remaining = np.expm1(-rate)
    return -remaining, 1 + remaining


def _bair_winer_start(cold: NDArray, warmth: NDArray) -> NDArray:
    return np.maximum(cold - warmth, np.minimum(cold, 0.0))


_EYRING = _Curve(_eyring, _eyring_start)
_BAIR_WINER = _Curve(_bair_winer, _bair_winer_start)


def _capped(shear: _Shear, limit: NDArray) -> _Shear:
    """Stress cut at a limit that grows with the square root of the load; a kink.

    A film that warms needs no second look: less stress is less heat, and the colder film is stiffer.
    """
    below = shear.stress <= limit
    return _Shear(
        stress=np.minimum(shear.stress, limit),
        by_log_load=np.where(below, shear.by_log_load, 0.5 * limit),
        by_sliding=below * shear.by_sliding,
        by_entrainment=below * shear.by_entrainment,
        by_film=below * shear.by_film,
    )


def _pulled(shear: _Shear, strip: _Strip, line_load: NDArray, sliding: NDArray) -> Traction:
    """Force q tau/p_mean, signed like the sliding; p_mean ~ load^(1/2)."""
    sign = np.sign(sliding)
    coefficient = shear.stress / strip.pressure
    width = line_load / strip.pressure
    pull = sign * width
    return Traction(
        force=pull * shear.stress,
        by_load=sign
        * (coefficient + strip.load_share * (shear.by_log_load / strip.pressure - 0.5 * coefficient)),
        by_sliding=width * shear.by_sliding,
        by_entrainment=pull * shear.by_entrainment,
        by_film=pull * shear.by_film,
    )


def _range_note(
    name: str, value: ArrayLike, fitted: tuple[float, float], unit: tuple[float, str]
) -> tuple[str, ...]:
    lowest, highest = float(np.min(value)), float(np.max(value))
    if fitted[0] <= lowest and highest <= fitted[1]:
        return ()
    size, symbol = unit
    return (
        f"{name} {lowest / size:.4g} to {highest / size:.4g} {symbol} is extrapolated: "
        f"the fit covers {fitted[0] / size:.4g} to {fitted[1] / size:.4g} {symbol}",
    )
