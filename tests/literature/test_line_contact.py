"""Two textbook problems of a lubricated roller bearing: Hertz contact and film, inner and outer raceway.

Sources: inputs of Hamrock, Fundamentals of Fluid Film Lubrication (bearing problem), and of the exercise of
DTU course 41524 (github.com/VictorLier/Tribology), whose stored pressure profiles are copied too. Outputs
computed independently from the closed forms W = w'/(E'R), b = R sqrt(8W/pi), p0 = E' sqrt(W/2pi), and the
film formulas 2.65 U^0.7 G^0.54 W^-0.13 and 1.714 U^0.694 G^0.568 W^-0.128.

The approach of the bodies by the closed form (2WR/pi)(ln(2pi/W) - 1) is left out: the load laws of this
package are Palmgren's and that of ISO/TS 16281.
"""

from dataclasses import dataclass

import numpy as np
import pytest
from pytest import approx

from quasidynamic import FORMULAS, Lubricant, Material
from quasidynamic.contact.film import FilmLaw
from quasidynamic.contact.line import half_width, peak_pressure, reduced_radius
from quasidynamic.motion.roller_speeds import rolling_cage_speed
from quasidynamic.parts.material import contact_modulus


@dataclass(frozen=True)
class Problem:
    raceways: tuple[float, float]  # [m] diameters
    roller: float  # [m] diameter, and length
    rollers: int
    load: float  # [N]
    speed: float  # [rad/s] of the inner ring
    modulus: float  # [Pa]
    pressure_viscosity: float  # [1/Pa]
    entrainment: float  # [m/s] printed; then inner, outer:
    radius: tuple[float, float]  # [mm]
    speed_group: tuple[float, float]
    load_group: tuple[float, float]
    half_width: tuple[float, float]  # [um]
    pressure: tuple[float, float]  # [GPa]
    dowson: tuple[float, float]  # [um]
    pan_hamrock: tuple[float, float]  # [um]

    @property
    def oil(self):
        return Lubricant(
            temperature=313.0,
            viscosity=0.01,
            pressure_viscosity=self.pressure_viscosity,
            temperature_viscosity=0.0,
            conductivity=0.13,
            density=850.0,
        )

    @property
    def elastic(self):
        steel = Material(youngs_modulus=self.modulus, poisson_ratio=0.3, density=7850)
        return contact_modulus(steel, steel)

    @property
    def radii(self):
        inner, outer = self.raceways
        return np.array([reduced_radius(self.roller / 2, side) for side in (inner / 2, -outer / 2)])

    @property
    def line_load(self):
        """Of the most loaded roller, which carries 4/Z of the load."""
        return 4 * self.load / self.rollers / self.roller


PROBLEMS = {
    "Hamrock": Problem(
        raceways=(64e-3, 96e-3),
        roller=16e-3,
        rollers=9,
        load=10800.0,
        speed=524.0,
        modulus=207.5e9,
        pressure_viscosity=2.2e-8,
        entrainment=10.0608,
        radius=(6.4, 9.6),
        speed_group=(6.8941e-11, 4.5960e-11),
        load_group=(2.0557e-4, 1.3705e-4),
        half_width=(146.43, 179.34),
        pressure=(1.3043, 1.0649),
        dowson=(0.39254, 0.46731),
        pan_hamrock=(0.36464, 0.43479),
    ),
    "DTU": Problem(
        raceways=(69.5e-3, 85.5e-3),
        roller=8e-3,
        rollers=20,
        load=8000.0,
        speed=837.0,
        modulus=210e9,
        pressure_viscosity=2.0e-8,
        entrainment=16.0441,
        radius=(3.5871, 4.4129),
        speed_group=(1.9382e-10, 1.5755e-10),
        load_group=(2.4161e-4, 1.9639e-4),
        half_width=(88.975, 98.687),
        pressure=(1.4310, 1.2902),
        dowson=(0.42465, 0.46422),
        pan_hamrock=(0.39123, 0.42804),
    ),
}


@pytest.fixture(params=PROBLEMS.values(), ids=PROBLEMS.keys())
def problem(request):
    return request.param


def test_entrainment_of_a_rolling_bearing(problem):
    inner, outer = problem.raceways
    cage = rolling_cage_speed(problem.speed, 0.0, problem.roller / ((inner + outer) / 2))
    assert (problem.speed - cage) * inner / 2 == approx(problem.entrainment, rel=1e-5)
    assert cage * outer / 2 == approx(problem.entrainment, rel=1e-5)


def test_groups_of_speed_and_load(problem):
    elastic = problem.elastic * problem.radii
    assert problem.radii * 1e3 == approx(problem.radius, rel=2e-5)
    assert problem.oil.viscosity * problem.entrainment / elastic == approx(problem.speed_group, rel=2e-5)
    assert problem.line_load / elastic == approx(problem.load_group, rel=3e-5)


def test_hertz_contact(problem):
    strip = half_width(problem.line_load, problem.radii, problem.elastic)
    pressure = peak_pressure(problem.line_load, problem.radii, problem.elastic)
    assert strip * 1e6 == approx(problem.half_width, rel=4e-5)
    assert pressure / 1e9 == approx(problem.pressure, rel=5e-5)


def films(problem, formula):
    """Film at both raceways [m]."""
    law = FilmLaw(
        formula=FORMULAS[formula],
        radius=problem.radii,
        modulus=problem.elastic,
        oil=problem.oil,
        inlet_heating=False,
    )
    return law(np.full(2, problem.line_load), np.zeros(2), np.full(2, problem.entrainment)).thickness


@pytest.mark.parametrize("formula", ["dowson", "pan_hamrock"])
def test_film(problem, formula):
    assert films(problem, formula) * 1e6 == approx(getattr(problem, formula), rel=2e-5)


STORED = ((1.80e-6, 1.430717), (1.99e-6, 1.289921))  # place [m] and pressure [GPa], inner and outer


def beside_the_middle():
    """Pressure at the places of the largest stored values [GPa]."""
    problem, (beside, _) = PROBLEMS["DTU"], np.transpose(STORED)
    strip = half_width(problem.line_load, problem.radii, problem.elastic)
    peak = peak_pressure(problem.line_load, problem.radii, problem.elastic)
    return peak * np.sqrt(1 - (beside / strip) ** 2) / 1e9


def test_stored_pressure_profiles():
    """Largest stored values, next to the middle."""
    assert beside_the_middle() == approx([pressure for _, pressure in STORED], rel=2e-6)
