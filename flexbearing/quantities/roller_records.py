"""Forms of the JSON attributes of a roller bearing."""

from typing import Any

from flexbearing.quantities.forms import (
    COUNT,
    FLAG,
    NUMBER,
    NUMBER_OR_NULL,
    TEXT,
    Each,
    Form,
    ListOf,
    Record,
    Such,
)
from flexbearing.quantities.life_records import BLOCKS

OF_STEPS = ("cold_m", "shaft_fit", "housing_fit", "verdict")
OF_ENDS = Record({"loosest_m": NUMBER, "tightest_m": NUMBER})
OF_CLASS = Record({"name": TEXT, "class": TEXT, "used_m": NUMBER, "least_m": NUMBER, "greatest_m": NUMBER})
OF_RACES = Record({"inner": TEXT, "outer": TEXT})


def _explained(clearance: Any) -> bool:
    return not clearance.get("steps") or all(name in clearance for name in OF_STEPS)


ATTEMPTS: Form = Each("method", Record({"iterations": COUNT, "status": TEXT, "message": TEXT}))
TILT: Form = Record(
    {"inner_ring": TEXT},
    optional={
        "otherwise": Record(
            {
                "inner_ring": TEXT,
                "max_roller_load_N": NUMBER,
                "life_L10_Mrev": NUMBER,
                "ring_moment_Nm": NUMBER,
                "ring_tilt_mrad": NUMBER,
            },
            optional={f"{which}stiffness_{axis}_N_per_m": NUMBER for which in ("", "total_") for axis in "yz"}
            | {"peak_pressure_MPa": NUMBER, "nominal_bar_stress_MPa": NUMBER},
        )
    },
    empty=True,
)
CLEARANCE: Form = Such(
    Record(
        {
            "operating_m": NUMBER,
            "steps": ListOf(
                Record({"name": TEXT, "change_m": NUMBER, "clearance_m": NUMBER, "explanation": TEXT})
            ),
        },
        optional={
            "cold_m": NUMBER,
            "shaft_fit": TEXT,
            "housing_fit": TEXT,
            "verdict": TEXT,
            "tolerances": Record({"at": TEXT, "classes": ListOf(OF_CLASS)}, optional={"ends": OF_ENDS}),
        },
        empty=True,
    ),
    _explained,
    f"with {', '.join(OF_STEPS)} where there are steps",
)
REGIMES: Form = Each(BLOCKS, OF_RACES)
ALONG_Y_AND_Z = ListOf(NUMBER)
OF_LINES: Form = Record(
    {
        "pull": FLAG,
        "azimuth_deg": ListOf(NUMBER),
        "force_N": ListOf(NUMBER),
        "end_forces_N": ListOf(ListOf(NUMBER)),
        "carries": ListOf(FLAG),
        "resultant_N": ALONG_Y_AND_Z,
        "rollers_N": ALONG_Y_AND_Z,
    }
)
OF_A_FOUNDATION: Form = Record(
    {
        "pull": FLAG,
        "largest_pressure_MPa": NUMBER,
        "azimuth_deg": NUMBER,
        "x_mm": NUMBER,
        "least_pressure_MPa": NUMBER,
        "open_share": NUMBER,
        "touching_deg": ListOf(ListOf(NUMBER)),
        "resultant_N": ALONG_Y_AND_Z,
        "rollers_N": ALONG_Y_AND_Z,
        "azimuths_deg": ListOf(NUMBER),
        "width_mm": ListOf(NUMBER),
        "pressure_MPa": ListOf(ListOf(NUMBER)),
    }
)
_FIGURES = {
    "largest_inner_load_N": NUMBER,
    "loaded_rollers": COUNT,
    "life_L10_Mrev": NUMBER,
    "driving_torque_Nm": NUMBER,
    "power_loss_W": NUMBER,
    "slip_percent": NUMBER_OR_NULL,
    "inner_loads_N": ListOf(NUMBER),
}
EQUILIBRIA: Form = Each(
    BLOCKS,
    Record(
        {
            "raceways": TEXT,
            "computed": Record(_FIGURES),
            "computed_is_stable": FLAG,
            "others": ListOf(Record(_FIGURES)),
        },
        optional={"after_passing_pitches": Record({**_FIGURES, "pitches": COUNT, "settled": FLAG})},
    ),
)
STRUCTURE: Form = Each(
    "part",
    Record(
        {
            "unknowns": COUNT,
            "elements": COUNT,
            "support_stiffness_N_per_m": NUMBER_OR_NULL,
            "seconds": Each("stage", NUMBER),
        },
        optional={
            "support_stiffness_error_N_per_m": NUMBER_OR_NULL,
            "fit": Each("figure", NUMBER),
            "housing": Each("figure", NUMBER),
            "seat": Each("figure", NUMBER),
            "lines": OF_LINES,
            "foundation": OF_A_FOUNDATION,
        },
    ),
)
STRESSES: Form = Each(
    "inner or outer",
    Record(
        {
            "bodies": Each(
                "body",
                Record(
                    {
                        "von_mises_MPa": NUMBER,
                        "von_mises_error_MPa": NUMBER,
                        "tension_MPa": NUMBER,
                        "tension_error_MPa": NUMBER,
                        "compression_MPa": NUMBER,
                        "compression_error_MPa": NUMBER,
                        "displacement_um": NUMBER,
                        "x_mm": NUMBER,
                        "radius_mm": NUMBER,
                        "azimuth_deg": NUMBER,
                    }
                ),
            ),
            "loads": TEXT,
            "left_out": TEXT,
            "seconds": NUMBER,
        },
        optional={
            "support": Record(
                {
                    "tilting_Nm_per_rad": NUMBER,
                    "tilting_error_Nm_per_rad": NUMBER,
                    "axial_N_per_m": NUMBER,
                    "axial_error_N_per_m": NUMBER,
                }
            ),
        },
    ),
)
PASSAGE: Form = Record(
    {
        "azimuth_deg": ListOf(NUMBER),
        "status": ListOf(TEXT),
        "values": Each("name in the summary", ListOf(NUMBER_OR_NULL)),
        "mean_life_Mrev": NUMBER_OR_NULL,
    }
)
CHOICES: Form = Each(
    "choice",
    Record(
        {
            "level": TEXT,
            "fixed": FLAG,
            "compared_with": ListOf(TEXT),
            "changes": Each("output", NUMBER),
            "factor": NUMBER,
            "allowed": NUMBER,
            "unusable": Each("level", TEXT),
        }
    ),
)
ERROR_ESTIMATE: Form = Record({"target": NUMBER, "met": FLAG}, further=NUMBER_OR_NULL, empty=True)
SLICE_ERROR: Form = Record({"slices": ListOf(NUMBER)}, further=NUMBER)
