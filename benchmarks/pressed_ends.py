"""How well pressed ends of slices are told, by half-spaces: `python -m benchmarks.pressed_ends [seed]`.

Random rollers, profiles, tilts and loads; prints how many of those whose slices miss the peak by more than
10 % are told, and how many of the others.
"""

import sys
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq
from threadpoolctl import threadpool_limits

from benchmarks.machine import describe
from benchmarks.slicing import ARCMIN, MODULUS, STEEL
from flexbearing.findings.running import PRESSED_ENDS
from quasidynamic.contact.half_space import elastic_pair
from quasidynamic.contact.line import (
    LoadLaw,
    fujiwara_kawase,
    half_width,
    johns_gohar,
    palmgren,
    peak_pressure,
    reduced_radius,
)
from quasidynamic.contact.pressure.roller import RollerOnRaceway
from quasidynamic.outcome.pressed_ends import LineContacts, in_cells, is_smooth, number_of_cells
from quasidynamic.outcome.sliced_peak import CELLS, TOLERANCE
from quasidynamic.parts.profile import Crowned, Logarithmic, Profile, Straight, TangentCrowned

CONTACTS, WRONG = 300, 0.1
PROFILES = "straight", "rounded", "crowned", "tangent", "iso16281", "johns_gohar", "fujiwara_kawase"


def between(rng: np.random.Generator, low: float, high: float) -> float:
    """A number of a logarithmic scale."""
    return float(np.exp(rng.uniform(np.log(low), np.log(high))))


@dataclass(frozen=True)
class Drawn:
    """A random roller on a raceway."""

    profile: Profile
    length: float  # [m]
    radius: float  # [m] reduced
    force: float  # [N]
    tilt: float  # [rad]
    slices: int

    @classmethod
    def of(cls, rng: np.random.Generator) -> "Drawn":
        """Rollers of 5 to 40 mm, 0.6 to 4 diameters long; 0.4 to 3 GPa if the load were spread evenly."""
        diameter = between(rng, 5e-3, 40e-3)
        length, raceway = diameter * between(rng, 0.6, 4), diameter * rng.uniform(1.5, 8)
        radius = reduced_radius(diameter / 2, rng.choice([raceway, -raceway - diameter]))
        load, design = (
            2 * np.pi * radius * between(rng, low, 3e9) ** 2 / MODULUS * length for low in (0.4e9, 0.8e9)
        )
        profile = _profile(rng, diameter, length, design, radius)
        tilt = rng.choice([0, rng.uniform(0, 3), rng.uniform(0, 10)]) * ARCMIN
        return cls(profile, length, radius, load, tilt, int(rng.choice([20, 30, 40, 60])))

    def shape(self, count: int) -> NDArray:
        """Tilt less drop in the middles of cells [m]."""
        places = ((np.arange(count) + 0.5) / count - 0.5) * self.length
        return self.tilt * places - self.profile.drop(places, self.length)

    def sliced(self) -> NDArray:
        """Loads per length of the slices [N/m]."""
        law, shape = LoadLaw(palmgren(STEEL, STEEL, self.length), 1e-12), self.shape(self.slices)

        def missing(approach: float) -> float:
            return law(approach + shape)[0].mean() * self.length - self.force

        return law(brentq(missing, -1e-2, 1e-2, xtol=1e-15) + shape)[0]

    def indicated(self, loads: NDArray) -> float:
        """Error of the peak of the slices as a run has it [-]."""
        along = peak_pressure(loads, self.radius, MODULUS)
        slender = half_width(loads.mean(), self.radius, MODULUS) / self.length
        if is_smooth(along, slender):
            return 0.0
        cells, known = int(number_of_cells(slender)), (self.length, self.radius, MODULUS)
        contact = LineContacts(
            np.array([self.force]), self.shape(cells)[None], np.array([np.nan]),
            *(np.array([each]) for each in known), in_cells(loads[None], cells),
        )  # fmt: skip
        return float(contact.peak_error(np.array([along.max()]))[0])

    def is_wrong(self, loads: NDArray) -> bool:
        """Whether half-spaces have another peak by more than 10 %, or one at a sharp end, without bound."""
        roller = RollerOnRaceway(
            pair=elastic_pair(STEEL, STEEL), radius=self.radius, length=self.length,
            drop=lambda place: self.profile.drop(place, self.length), cells=CELLS, tolerance=TOLERANCE,
        )  # fmt: skip
        whole = roller.tilted(self.force, self.tilt)
        sliced = float(peak_pressure(loads.max(), self.radius, MODULUS))
        return whole.peak_at_ends or abs(sliced / whole.peak_pressure - 1) > WRONG


def _profile(
    rng: np.random.Generator, diameter: float, length: float, design: float, radius: float
) -> Profile:
    name, deep, middle = rng.choice(PROFILES), between(rng, 1e-6, 60e-6), rng.uniform(0.2, 0.9) * length
    if name == "straight":
        return Straight()
    if name == "rounded":
        end = rng.uniform(0.02, 0.1) * length
        return TangentCrowned(straight_length=length - 2 * end, crown_radius=rng.uniform(5, 80) * end)
    if name == "crowned":
        return Crowned(straight_length=0.0, crown_radius=length**2 / 8 / deep)
    if name == "tangent":
        return TangentCrowned(straight_length=middle, crown_radius=(length - middle) ** 2 / 8 / deep)
    if name == "iso16281":
        return Logarithmic(amplitude=rng.uniform(0.2, 1.2) * 0.00035 * diameter)
    if name == "johns_gohar":
        return johns_gohar(design, length, MODULUS, radius)
    return fujiwara_kawase(
        design, length, MODULUS, load_factor=rng.uniform(1, 2.5), crowned_share=rng.uniform(0.3, 1),
        end_drop=deep,
    )  # fmt: skip


def main(seed: int) -> None:
    print(describe())
    rng, told, wrong = np.random.default_rng(seed), [], []
    with threadpool_limits(limits=1):
        for _ in range(CONTACTS):
            drawn = Drawn.of(rng)
            loads = drawn.sliced()
            told.append(drawn.indicated(loads) > PRESSED_ENDS.limit)
            wrong.append(drawn.is_wrong(loads))
    told, wrong = np.array(told), np.array(wrong)
    print(f"seed {seed}: {CONTACTS} contacts, slices of {wrong.sum()} miss the peak by more than 10 %")
    print(f"of these told: {told[wrong].sum()} ({told[wrong].mean():.1%})")
    print(f"told without cause: {told[~wrong].sum()} of {(~wrong).sum()} ({told[~wrong].mean():.1%})")


if __name__ == "__main__":
    main(int(sys.argv[1], 16) if len(sys.argv) > 1 else 0)
