"""Keys of an optimisation file."""

from collections.abc import Mapping
from typing import Any, Literal

from flexbearing.case.quantity import Section, key
from flexbearing.studies.file.schema import SETTINGS, Duty, Keys, Over

DUTY_LIFE = "duty_life"  # life that the rows of [duty] cumulate to, beside the outputs of a row


class Objective(Section):
    """What is made as large or as small as it can be."""

    output: str = key(
        f"an output with its unit; with [duty] {DUTY_LIFE}, the life that its rows cumulate to",
        example="life_L10 [h]",
    )
    over: Literal["worst", "mean"] = key(
        "what counts of the rows of [over] and [duty]: the worst of them, or their arithmetic mean", "worst"
    )
    scale: Literal["logarithmic", "linear"] = key(
        "logarithmic: a percent is worth the same at any value, of outputs above zero; linear: of others",
        "logarithmic",
    )


class Search(Section):
    """How the best point is searched."""

    method: Literal["slsqp", "cobyqa"] = key(
        "slsqp: sequential quadratic programming with derivatives; cobyqa: quadratic models without "
        "derivatives, for outputs that are not smooth enough for them",
        "slsqp",
    )
    starts: int = key(
        "number of starts: the case itself, then points of a Sobol sequence between the bounds",
        4,
        ge=1,
        le=64,
    )
    seed: int = key("of the sequence: the same seed gives the same starts", 0, ge=0, le=2**32 - 1)
    tolerance: float = key(
        "largest relative gain that the derivatives still promise for a tenth of the range of every key at "
        "once, at convergence",
        1e-3,
        gt=0,
        le=0.1,
    )
    iterations: int = key(
        "limit for each start, which is not convergence; with [surrogate] of designs of the case",
        60,
        ge=1,
        le=1000,
    )
    verified: bool = key(
        "whether outputs have the values of the first [[verify]]: those searched are scaled by what it says "
        "at the first start, then at the best point, until that is an optimum with its values, too",
        False,
    )


class OptimisationFile(Section):
    """An optimisation file."""

    case: str = key("case file, by its path from the folder of this file", example="nu209.toml")
    name: str | None = key("of the outputs, such as NAME.csv; without it that of this file", None)
    set: Keys = key(SETTINGS.format("design"), {})
    vary: Keys = key(
        'keys that are found, each with its bounds, "0.5 um .. 20 um"; in front of them log for a '
        'logarithmic scale; an entry of a list by its number, "bearing.roller.point_drops.3"',
        {},
    )
    maximise: Objective | None = key("what is made as large as it can be; this or [minimise]", None)
    minimise: Objective | None = key("what is made as small as it can be", None)
    constrain: Mapping[str, Any] = key(
        "outputs that stay within bounds in every row of [over] and [duty], "
        '"<= 2500 MPa", ">= 20000 h", "100 kN/mm .. 120 kN/mm"',
        {},
        example={"peak_pressure.outer": "<= 2500 MPa"},
    )
    over: Over | None = key("conditions under which every design is computed, as in a study", None)
    duty: Duty | None = key("duty cycle under which every design is computed, as in a study", None)
    search: Search = key("how the best point is searched", {})
    surrogate: Keys = key(
        "settings of a cheaper model with which designs are searched, such as a beam in place of elements; "
        "its outputs are corrected until they and their derivatives are those of the case at the best point",
        {},
        example={"accuracy.structure": "beam"},
    )
    verify: tuple[Keys, ...] = key(
        "settings with which the case and the best point are computed once more, a table [[verify]] for each "
        "set of them, such as more slices",
        (),
        strict=False,
        example=[{"accuracy.slices": 200}],
    )
