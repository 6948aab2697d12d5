"""Traction of a Newtonian film that heats itself, with oil data of their own."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from quasidynamic.contact.line import SMALLEST_LOAD
from quasidynamic.contact.traction.film_strip import ShearStress, film_traction, limited_stress, loaded_strip
from quasidynamic.contact.traction.traction_law import Traction
from quasidynamic.note import Note, outside
from quasidynamic.parts.oil_properties import Lubricant


@dataclass(frozen=True, kw_only=True)
class AdoreOil:
    r"""Viscosity of an oil as fitted to traction, which is not the one that forms the film.

    .. math:: \eta = \eta_{313}\, e^{c (313 - T)}\, e^{\alpha p},\quad \beta = \beta_{313} (T/313)^n

    Source
    ------
    Constants as coded in a public program of the ADORE line of Gupta; the primary was not seen.

    Valid
    -----
    The ranges are quoted from memory of the literature, no table of measurements was available.
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

    def notes(self, temperature: ArrayLike, pressure: ArrayLike) -> tuple[Note, ...]:
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
    length: float  # [m] l, of no influence
    oil: Lubricant  # its temperature and conductivity
    rheology: AdoreOil
    limiting_ratio: float  # [-] Lambda
    smallest_load: float = SMALLEST_LOAD  # [-] q/(E' R) below which strip width over load keeps its value

    def __call__(self, line_load: NDArray, sliding: NDArray, entrainment: NDArray, film: NDArray) -> Traction:
        """Traction; the entrainment speed enters through the film alone."""
        strip = loaded_strip(line_load, self)
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
        shear = ShearStress(
            stress=stress,
            # both scale and z go with the root of eta, and ln eta = alpha p with the root of the load
            by_log_load=0.25 * log_thickening * (stress + scale * steepness * z),
            by_sliding=viscosity / film * steepness,
            by_entrainment=np.zeros_like(stress),
            by_film=-stress / film,
        )
        return film_traction(
            limited_stress(shear, self.limiting_ratio * strip.pressure), strip, line_load, sliding
        )


def _range_note(
    name: str, value: ArrayLike, fitted: tuple[float, float], unit: tuple[float, str]
) -> tuple[Note, ...]:
    lowest, highest = float(np.min(value)), float(np.max(value))
    if fitted[0] <= lowest and highest <= fitted[1]:
        return ()
    size, symbol = unit
    return (
        outside(
            "traction-data",
            f"{name} {lowest / size:.4g} to {highest / size:.4g} {symbol} is extrapolated: "
            f"the fit covers {fitted[0] / size:.4g} to {fitted[1] / size:.4g} {symbol}",
        ),
    )
