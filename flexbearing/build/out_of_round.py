"""How raceways of fast balls that are not round approach the balls."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexbearing.case.raceway_waves import Waves
from quasidynamic.parts.raceway_waves import RacewayWaves

if TYPE_CHECKING:
    from flexbearing.case.balls.angular_contact import FastCase
    from flexbearing.case.balls.ring_room import Race

LOBES = 2  # of a cam


def raceway_waves(waves: Waves) -> RacewayWaves:
    """Waves of a case as bearings have them."""
    return RacewayWaves(numbers=waves.numbers, amplitudes=waves.amplitudes, crests=waves.crests)


def approaches(case: "FastCase", azimuths: NDArray) -> NDArray | None:
    """By how much waves bring both raceways closer to balls at azimuths (Z) [rad]: (Z) [m]; None: round.

    Raises `ImpossiblePart` if waves are too steep or too much curved.
    """
    bearing = case.bearing
    shapes: dict[Race, RacewayWaves] = {race: raceway_waves(each) for race, each in bearing.waves.items()}
    for race, waves in shapes.items():
        waves.require_gentle(
            f"bearing.form_error.{race}", bearing.groove_bottom(race), bearing.ball.diameter / 2
        )
    return np.sum([each.height(azimuths) for each in shapes.values()], axis=0) if shapes else None


def approaches_on_cam(case: "FastCase", azimuths: NDArray) -> NDArray:
    r"""By how much a cam brings the inner raceway closer to balls at azimuths (Z) [rad]: (Z) [m].

    .. math:: h = r(\varphi) - R + \frac{w_0^2}{R_o}, \quad
              r = \frac{a b}{\sqrt{b^2 \cos^2\varphi + a^2 \sin^2\varphi}} \text{ or } R + w_0 \cos 2\varphi
              \text{ or } R + w_0 \cos 2\varphi - \frac{w_0^2}{R}

    with a, b = R +- w_0 at the pitch radius R, phi from the major axis. The last term is that of the outer
    ring: pressed to R_o + w_0 cos 2 phi it would be longer by 2 pi w_0^2/R_o, which its length fights.

    Source
    ------
    Length of a curve in polar coordinates; derived here.

    Valid
    -----
    Small displacement otherwise: see `flexbearing.runs.not_round`.
    """
    inner, bearing = case.inner, case.bearing
    w, radius = inner.cam_amplitude or 0.0, bearing.pitch_diameter / 2
    phi, ring = azimuths - inner.cam_crest, bearing.groove_bottom("outer")
    longer = w**2 / ring
    if inner.cam_curve == "ellipse":
        a, b = radius + w, radius - w
        return a * b / np.hypot(b * np.cos(phi), a * np.sin(phi)) - radius + longer
    return w * np.cos(LOBES * phi) - (w**2 / radius if inner.cam_curve == "length_kept" else 0.0) + longer
