r"""A raceway as a closed curved beam: compliance in azimuthal harmonics without a mesh.

The section moves as a rigid one (`fem.beam.curved_beam`); on top of it, the wall deflects below the rollers
like an elastic layer with a free back,

.. math:: W_n = \frac{1}{2\pi} G^T (K_n + K_s)^{-1} G + g_m(k t)\,h_n, \quad
          k^2 = \left(\frac{n}{R}\right)^2 + \left(\frac{m\pi}{l}\right)^2

with h the harmonics of the half-space (`fem.half_space.line_load`), t the thickness of the wall, and g the
deflection of a layer over that of a half-space, less what the beam does already. Short waves leave g = 1:
there ring and half-space agree, so that the remainder has a sum.

Source
------
Curved beam as in `fem.beam.curved_beam`; layer after Timoshenko, Goodier, Theory of Elasticity, sec. 24;
their sum is derived here.
"""

from functools import singledispatch
from math import ceil

import numpy as np
from numpy.typing import NDArray

from fem.beam.curved_beam import MOTIONS, CurvedBeam
from fem.beam.support_springs import (
    SupportCompliance,
    bars_around,
    carried,
    forces_in_the_middle,
    foundation,
    in_series,
    on_ground,
    tube_wall,
)
from fem.errors import NotSolved
from fem.half_space.line_load import indentation_harmonics
from fem.parts.boundary_conditions import ClampedFace, Foundation
from fem.parts.part import Part
from fem.parts.resolution import Resolution
from fem.parts.rings import Elastic, ImpossiblePart, OuterRing, RingOnShaft
from fem.parts.squirrel_cage import SquirrelCage
from fem.raceway.bar_response import BarResponse, of_revolution
from fem.raceway.harmonics import FEWEST, FINENESS, Responses
from fem.stages import Stage

SMALL = 0.1  # wave number times thickness below which g is its series: digits cancel
SERIES = 32 / 175, -2 / 7875  # of g, in s and s^3
FOLLOWS = 13 / 35  # mean square of a cubic from ring to clamp: part of a tube's length whose hoops count
WAVES = 10.0  # highest harmonic over R/thickness: there the wall deflects like a half-space
LARGE = 300.0  # beyond, sinh overflows; the quotient has been 1 since 20
U, W, V, THETA, CHI, PSI = range(len(MOTIONS))
MIRROR = np.diag([-1.0, 1.0, 1.0, -1.0, -1.0, 1.0])  # motions with x the other way round


def beam_responses(
    part: Part, resolution: Resolution, last: int, stage: Stage, face_modes: int = 0
) -> Responses:
    r"""Answers of a raceway to harmonics 0 .. `last`, its ring as a curved beam; bars are spread evenly.

    The part is an outer ring on a foundation or with a clamped face, a ring on bars and flange, or a ring on
    a hollow shaft, both together one section. Answers are those of the modes of the raceway, then those of
    `face_modes` axial modes of the outer surface of an outer ring, which moves with the section. Under all
    but the first two axial modes the section keeps its place.
    Raises `ImpossiblePart` if what holds the ring is no spring to ground.

    Valid
    -----
    Section small against the radius, width up to about :math:`2\sqrt{R t}`: it keeps its shape, also between
    bars at both of its ends, where it bends (18 % in the support of the paper's cage). A clamped
    face is taken as a wall that bends along x only, bars as spread Timoshenko beams, a shaft as walls that
    bend along x with hoops that fade like a clamped beam.
    """
    n, length, axial_modes = np.arange(last + 1), resolution.length, resolution.axial_modes
    with stage("condense"):
        loads = np.hstack([_section_loads(length, axial_modes), _section_loads(part.width, face_modes)])
        if isinstance(part, OuterRing | SquirrelCage):
            loads[THETA, 0] = part.offset
        moved = _section_motions(stiffness_of(part, n), loads)
        responses = loads.T @ moved
        responses[:, :axial_modes, :axial_modes] += _wall_responses(part, n, length, axial_modes)
    bars = _bar_response(part, moved[:, :, :axial_modes]) if isinstance(part, SquirrelCage) else None
    return Responses(responses, len(MOTIONS), 1, bar_response=bars)


def last_harmonic(part: Part, resolution: Resolution) -> int:
    """Choose the last harmonic: fine for the band, and beyond it the wall deflects like a half-space.

    Raises `NotSolved` if fewer harmonics are requested than any ring needs.
    """
    wish = resolution.harmonics
    if wish is not None and wish < FEWEST:
        raise NotSolved(f"{wish} harmonics are impossible, allowed are {FEWEST} or more")
    detail, thickness = resolution.length / resolution.axial_modes, beam_of(part).thickness
    return wish or ceil(part.raceway_diameter / 2 * max(FINENESS / detail, WAVES / thickness))


@singledispatch
def beam_of(part) -> CurvedBeam:
    """Beam that stands for the ring of a part.

    Raises `ImpossiblePart` for a part whose ring has no rectangular section.
    """
    raise ImpossiblePart(f"{type(part).__name__} is not known as a curved beam")


@beam_of.register
def _(part: OuterRing | SquirrelCage):
    if isinstance(part, SquirrelCage) and part.has_collar:
        raise ImpossiblePart("a ring with a collar is no curved beam of one section; allowed is one without")
    inside = part.raceway_diameter / 2
    return CurvedBeam(inside=inside, outside=inside + part.thickness, width=part.width, elastic=part.elastic)


@beam_of.register
def _(part: RingOnShaft):
    if not part.shaft_bore:
        raise ImpossiblePart("a solid shaft is no curved beam; allowed is a hollow one")
    inside, seat, outside = part.shaft_bore / 2, part.bore / 2, part.raceway_diameter / 2
    share = (outside - seat) / (outside - inside)
    mixed = Elastic(
        youngs_modulus=share * part.ring.youngs_modulus + (1 - share) * part.shaft.youngs_modulus,
        poisson_ratio=share * part.ring.poisson_ratio + (1 - share) * part.shaft.poisson_ratio,
    )
    return CurvedBeam(inside=inside, outside=outside, width=part.width, elastic=mixed)


@singledispatch
def stiffness_of(part, harmonics: NDArray) -> NDArray:
    """Stiffness (K, 6, 6) per radian of the ring of a part and of what holds it.

    Raises `ImpossiblePart` for a support that is no spring to ground.
    """
    raise ImpossiblePart(f"{type(part).__name__} is not known as a curved beam")


@stiffness_of.register
def _(part: SquirrelCage, harmonics):
    held = in_series(*_bars_and_flange(part))
    stiffness = beam_of(part).stiffness(harmonics) + held
    return stiffness + MIRROR @ held @ MIRROR if part.two_sided else stiffness


def _bars_and_flange(part: SquirrelCage) -> tuple[SupportCompliance, SupportCompliance]:
    """What holds the ring of a squirrel cage at +x, from the ring to the ground."""
    foot = part.width / 2 + part.bar_length
    section, span = (part.bar_width, part.bar_thickness), (part.width / 2, foot)
    end = foot + part.flange_length
    return (
        bars_around(part.bars, section, span, 0.0, part.elastic),
        tube_wall(beam_of(part).radius, part.thickness, (foot, end), 0.0, part.elastic),
    )


@stiffness_of.register
def _(part: OuterRing, harmonics):
    beam = beam_of(part)
    match part.support:
        case ClampedFace():
            held = on_ground(tube_wall(beam.radius, beam.thickness, (0.0, part.width / 2), 0.0, part.elastic))
        case Foundation(axial=axial, radial=radial, tangential=tangential):
            held = foundation((axial, radial, tangential), beam.outside, part.width, beam.thickness / 2)
        case other:
            raise ImpossiblePart(
                f"{type(other).__name__} is impossible below a curved beam; allowed are ClampedFace and "
                "Foundation"
            )
    return beam.stiffness(harmonics) + held


@stiffness_of.register
def _(part: RingOnShaft, harmonics):
    beam, side, end = beam_of(part), part.width / 2, part.shaft_length / 2
    tube = CurvedBeam(
        inside=part.shaft_bore / 2,
        outside=part.bore / 2,
        width=FOLLOWS * 2 * (end - side),
        elastic=part.shaft,
    )
    offset = tube.radius - beam.radius
    held = sum(
        on_ground(tube_wall(tube.radius, tube.thickness, (sign * side, sign * end), offset, part.shaft))
        for sign in (1, -1)
    )
    return beam.stiffness(harmonics) + held + carried(tube.stiffness(harmonics), offset)


def layer_share(wave, mode: int = 0) -> NDArray:
    r"""Deflection of a layer with a free back over that of a half-space, less the motion of a beam.

    .. math:: g_0 = f - \frac{6}{s^3} - \frac{6}{5s}, \quad g_1 = f - \frac{6}{s^3}, \quad g_2 = f, \quad
              f(s) = \frac{\sinh s \cosh s + s}{\sinh^2 s - s^2}

    A beam bends and shears under the mean of a load along the roller, it tilts under a linear one, and does
    not move under higher ones.

    Parameters
    ----------
    wave : array (...)
        s = k t, wave number times thickness, above 0 for all but the first axial mode
    mode : int
        m of the load along the roller

    Returns
    -------
    array (...)
        g [-]; that of the first axial mode is 32 s/175 for small s

    Source
    ------
    Timoshenko, Goodier, Theory of Elasticity, sec. 24 (sinusoidal load on one side of a strip).
    """
    s = np.asarray(wave, dtype=float)
    p = np.clip(s, SMALL, LARGE)
    whole = (np.sinh(p) * np.cosh(p) + p) / (np.sinh(p) ** 2 - p**2)
    bending, shear = 6 / p**3, 6 / (5 * np.maximum(s, SMALL))
    above = np.where(s < SMALL, SERIES[0] * s + SERIES[1] * s**3, whole - bending - shear)
    sheared = 6 / (5 * s) if mode > 0 else 0.0
    return above + sheared + (6 / s**3 if mode > 1 else 0.0)


def _section_loads(length: float, axial_modes: int) -> NDArray:
    """Loads (6, M) of axial modes on the rigid section, which only the first two move."""
    loads = np.zeros((len(MOTIONS), axial_modes))
    loads[W, :1] = 1.0
    loads[THETA, 1:2] = length / 2
    return loads


def _section_motions(K: NDArray, loads: NDArray) -> NDArray:
    """Motions (N + 1, 6, M) [m/N, rad/N] of the rigid section by loads of every harmonic."""
    # No load on the raceway turns the ring or, where nothing holds it axially, moves it along its axis.
    K[0, V, V] += np.abs(K[0]).max()
    if K[0, U, U] == 0:
        K[0, U, U] = 1.0
    return np.linalg.solve(K, np.broadcast_to(loads, (len(K), *loads.shape))) / (2 * np.pi)


def _bar_response(cage: SquirrelCage, moved: NDArray) -> BarResponse:
    """Section forces of the bars by the motions (N + 1, 6, M) of the section that they hold."""
    in_middle = forces_in_the_middle(*_bars_and_flange(cage)) * 2 * np.pi / cage.bars
    lever, forces = cage.bar_length / 2, []
    for end in cage.ends:
        seen = moved if end > 0 else MIRROR @ moved
        axial, radial, tangential, bending, sideways, torque = np.moveaxis(in_middle @ seen, 1, 0)
        forces += [
            -axial, bending + lever * radial, bending - lever * radial,
            sideways + lever * tangential, sideways - lever * tangential, torque,
        ]  # fmt: skip
    return of_revolution(cage.bars, np.stack(forces, axis=2))


def _wall_responses(part: Part, n: NDArray, length: float, axial_modes: int) -> NDArray:
    """Responses (N + 1, M, M) [m/N] of the wall below the rollers."""
    thickness, radius = beam_of(part).thickness, part.raceway_diameter / 2
    waves = thickness * np.hypot(n[:, None] / radius, np.pi / length * np.arange(axial_modes))
    share = np.sqrt([layer_share(wave, mode) for mode, wave in enumerate(waves.T)]).T
    half_space = indentation_harmonics(n, radius, length, axial_modes, part.materials["ring"])
    return half_space * share[:, :, None] * share[:, None]
