"""How the seat of a plain ring widens its raceway, on the axial section."""

from fem.assembly.factorisation import threads
from fem.parts.resolution import Resolution
from fem.parts.rings import OuterRing
from fem.raceway.growth import RacewayGrowth
from fem.section.expansion import heating, radial_expansion
from fem.section.rigid_body_modes import body_of


def ring_seat_growth(part: OuterRing, resolution: Resolution) -> RacewayGrowth:
    """Growth of the raceway of a ring whose clamped face or seat expands.

    .. math:: w = R + w_{th}

    with the ring and its clamp expanding alike first, R the radius of the raceway, and then the ring
    shrinking by as much in a clamp that stays, :math:`w_{th}`.

    w [m] is per strain of the clamp beyond that of the ring.
    Raises `NotSolved` if a solve fails.

    Source
    ------
    Thermoelasticity by superposition; derived here.

    Valid
    -----
    Small displacement; the clamp expands evenly and carries all forces.
    """
    with threads(1):
        body = body_of(part, resolution)
        shrunk = heating(body, dict.fromkeys(part.materials, -1.0))
        growth = radial_expansion(body, shrunk, "raceway", resolution.axial_modes)
    growth[0] += part.raceway_diameter / 2
    return RacewayGrowth(growth[None], None)
