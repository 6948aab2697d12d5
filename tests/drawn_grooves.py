"""Drawings of outer rings with a groove for balls: the 6209 of `configs`, plain or on a foot."""

from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from netgen import occ

from fem.parts.groove import Groove

GROOVE, LAND = Groove(radius=6.6e-3, centre_radius=32.25e-3), 36.65e-3  # [m]
OUTSIDE, HALF = 42.5, 9.5  # [mm] radius and half of the width
AXIS = occ.Axis(occ.Pnt(0, 0, 0), occ.X)


def counterbored(groove, land, low_land):
    """Ring of an angular contact bearing, its low shoulder at -x; lengths in metres."""
    outside, half = 1e3 * groove.bottom(1) + 5.0, 15.0
    low = occ.Cylinder(occ.Pnt(-half, 0, 0), occ.X, 1e3 * low_land, half)
    drawn = tube(1e3 * land, outside, half) - torus(groove) - low
    return named(drawn, of_centre=lambda centre: centre.x > half - 0.1)


def tube(inner, outer, half=HALF):
    start = occ.Pnt(-half, 0, 0)
    return occ.Cylinder(start, occ.X, outer, 2 * half) - occ.Cylinder(start, occ.X, inner, 2 * half)


def torus(groove=GROOVE, aside=0.0):
    """Body that cuts a groove, its centre at x = `aside` [mm]."""
    plane = occ.WorkPlane(occ.Axes(occ.Pnt(aside, 1e3 * groove.centre_radius, 0), n=occ.Z, h=occ.X))
    return plane.Circle(1e3 * groove.radius).Face().Revolve(AXIS, 360)


def ring(groove=GROOVE, aside=0.0):
    """A plain ring about x; its end at +x is the face "back"."""
    return named(tube(1e3 * LAND, OUTSIDE) - torus(groove, aside))


def on_a_foot():
    """The ring on a foot at azimuth 180 degrees, held below."""
    foot = occ.Box(occ.Pnt(-HALF, -12, -50), occ.Pnt(HALF, 12, -40)) - tube(0.1, OUTSIDE - 0.5)
    return named(ring() + foot, "foot", lambda centre: centre.z < -49)


def named(shape, name="back", of_centre=lambda centre: centre.x > HALF - 0.1):
    for face in shape.faces:
        face.name = name if of_centre(face.center) else "other"
    return shape


def written(shape) -> bytes:
    """Content of its STEP file."""
    with TemporaryDirectory() as folder:
        file = Path(folder) / "drawn.step"
        shape.WriteStep(str(file))
        return file.read_bytes()


def stations(width, count):
    """Contact angles [rad] of stations as a case places them for patches of a width [m]."""
    end = GROOVE.end(LAND, 1) - 2 * width / GROOVE.radius
    return tuple(end * np.sin(np.pi / 2 * np.linspace(-1, 1, count)))
