"""Volume of an outer ring and of a squirrel cage in closed form."""

from functools import lru_cache
from math import pi

from fem.parts.bar_section import bar_section
from fem.parts.rings import OuterRing
from fem.parts.squirrel_cage import SquirrelCage


@lru_cache(maxsize=64)  # most variants of a study have the rings of the one before
def volume(part: OuterRing | SquirrelCage) -> float:
    r"""Volume of a ring with its bars, flanges and collars.

    .. math:: V = \pi (D + t) t w + k \left(\pi (D + t) t f + N A l\right) + V_c

    Parameters
    ----------
    part : OuterRing or SquirrelCage
        D, t and w of the ring; N bars of section A and length l on a flange of length f at k ends; V_c of
        collars outside of the ring

    Returns
    -------
    float
        V [m^3]; without what holds a plain ring

    Source
    ------
    Geometry.

    Valid
    -----
    Fillets are left out.
    """
    per_length = pi * (part.raceway_diameter + part.thickness) * part.thickness
    if isinstance(part, OuterRing):
        return per_length * part.width
    bars = part.bars * bar_section(part).area * part.bar_length
    ends = len(part.ends) * (per_length * part.flange_length + bars)
    return per_length * part.width + ends + _collars(part)


def _collars(cage: SquirrelCage) -> float:
    """Volume of the collars outside of the ring [m^3]."""
    if not cage.has_collar:
        return 0.0
    inside = cage.raceway_diameter + 2 * cage.thickness
    outside = cage.raceway_diameter + 2 * cage.collar_thickness
    return len(cage.ends) * cage.collar_length * pi / 4 * (outside**2 - inside**2)
