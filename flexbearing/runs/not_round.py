"""What a user must know of raceways that are not round."""

from itertools import chain
from typing import TYPE_CHECKING

from quasidynamic.note import Note, information, outside

if TYPE_CHECKING:
    from flexbearing.case.balls.angular_contact import FastCase

# Error of the largest load by small displacements over displacement over radius, calibrated: at most 3.8 on
# three curves of a strain-wave bearing up to 1.4 % of its radius (tests/literature/test_strain_wave.py).
LARGE = 4.0
NOTABLE = 0.02  # of the largest load


def notes(case: "FastCase") -> tuple[Note, ...]:
    """Notes on cams and on waves of raceways."""
    operation = case.operation
    crests: dict[str, str] = {race: f"bearing.form_error.{race}.crest" for race in case.bearing.waves}
    if case.inner.kind == "cam":
        crests["inner"] = "inner.cam_crest"
    speeds = {"inner": operation.inner_speed, "outer": operation.outer_speed}
    cams = {"inner"} if case.inner.kind == "cam" else set()
    turned = (turning(race, crest, cam=race in cams) for race, crest in crests.items() if speeds[race])
    return (*turned, *_large(case))


def turning(race: str, crest: str, *, cam: bool = False) -> Note:
    """The note on a raceway that is not round and turns, its crest at a key."""
    of_cam = "turned with it, as that of a cam does, without any load at rest"
    does = of_cam if cam else "did not turn with it"
    return information(
        "turning-waves",
        f"the {race} raceway is not round and turns; loads and life are those of one moment, with its crests "
        f"as in the case: other crests give those of other moments; lives are rated as if the load {does}",
        {crest: ""},
    )


def _large(case: "FastCase") -> tuple[Note, ...]:
    """How far displacements are from small ones."""
    waves = (each.amplitudes for each in case.bearing.waves.values())
    largest = sum(map(abs, chain(*waves))) + (case.inner.cam_amplitude or 0.0)
    error = LARGE * largest / (case.bearing.pitch_diameter / 2)
    if error < NOTABLE:
        return ()
    return (
        outside(
            "large-deflection",
            f"raceways are {1e3 * largest:.3g} mm out of round: small displacements leave an error of about "
            f"{error:.1%} of the largest load, calibrated on the cam of a strain-wave bearing",
        ),
    )
