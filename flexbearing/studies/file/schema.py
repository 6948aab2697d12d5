"""Keys of a study file."""

from collections.abc import Mapping
from typing import Literal

from pydantic import ConfigDict

from flexbearing.case.quantity import Section, key
from flexbearing.sampling.points import Method

SETTINGS = "settings of every {} that differ from the case file, key by key; an empty text takes a key out"


class Keys(Section):
    """Keys of the case; every name in the table is one."""

    model_config = ConfigDict(extra="allow")


class Over(Section):
    """Keys of the case and the values that they take; every other name in the table is such a key."""

    model_config = ConfigDict(extra="allow")

    zip: bool = key(
        "whether the first values belong together, the second ones and so on; else crossed", False
    )
    file: str | None = key(
        "table of variants (CSV) next to the study file; its header has keys with units in brackets",
        None,
        example="variants.csv",
    )


class Sample(Section):
    """Keys of the case and their distributions, or single values; every other name is such a key."""

    model_config = ConfigDict(extra="allow")

    count: int = key(
        "number of variants; a power of 2 for sobol; for sobol_indices also a power of 2, of base points, "
        "with as many variants for each as keys are drawn, and two more",
        example=1000,
        ge=1,
        le=1_000_000,
    )
    method: Method = key(
        "how points are spread; sobol_indices changes one key after the other, for its share of the variance",
        "latin_hypercube",
    )
    seed: int = key("of the random numbers: the same seed gives the same variants", 0, ge=0, le=2**32 - 1)


class Duty(Section):
    """Rows of a duty cycle; every other name in the table is a key of the case, with a value for each row."""

    model_config = ConfigDict(extra="allow")

    time: tuple[float | str, ...] | None = key(
        'shares of the time, row by row: numbers, percentages or times, such as "30 %" or "12 h"',
        None,
        example=["30 %", "70 %"],
        strict=False,
    )
    revolutions: tuple[float | str, ...] | None = key(
        "shares of the revolutions instead", None, example=["30 %", "70 %"], strict=False
    )
    file: str | None = key(
        'table of rows (CSV) next to the study file; its header has keys and "time [%]" or "revolutions"',
        None,
        example="spectrum.csv",
    )
    series: str | None = key(
        'time series of keys (CSV) next to the study file, instead of rows with shares; a column "time [s]" '
        "says when each row begins, without it rows last equally long",
        None,
        example="measured.csv",
    )
    bins: int | None = key(
        "into how many bins of equal width the numbers of one sign of each load of the series are sorted, by "
        "default 30, and those of a file, where given; a third as many of speeds and other keys",
        None,
        example=30,
        ge=1,
        le=1000,
    )
    life: Literal["life_L10", "modified_life"] = key("which life is cumulated for the bearing", "life_L10")
    required_life: str | None = key(
        "life that is required: the dynamic rating for it follows from the mean equivalent load, with the "
        "reliability of the case (life.reliability)",
        None,
        example="20000 h",
    )
    application_factor: float = key(
        "on equivalent loads, for the required rating; no life changes", 1.0, gt=0
    )


class MarkTable(Section):
    """A number from elsewhere, printed or measured, that is drawn beside those of the study."""

    y: str = key("one of plot.y, whose panel it belongs to")
    value: str = key('with the unit, or a range "FROM .. TO"', example="33.8 % .. 76.4 %")
    x: str | None = key(
        "place along x with the unit, or the text; without it a line or a band across the panel", None
    )
    label: str = key("what it is")
    source: str = key("where it is from")


class PlotTable(Section):
    """What is drawn of the table."""

    x: str = key("varied key, column of [collect], or output with its unit", example="outer.thickness")
    lines: str | None = key(
        "varied key with a line for each of its values, first among the keys that are crossed with x",
        None,
        example="operation.radial_load",
    )
    y: tuple[str, ...] = key(
        "columns of [collect], or outputs with their units, one panel each",
        example=["life", "cage_slip [%]"],
        strict=False,
        min_length=1,
    )
    rigid: bool = key("whether the same between rigid raceways is drawn dashed", False)
    marks: tuple[MarkTable, ...] = key(
        "numbers from elsewhere that are drawn too, a table [[plot.marks]] for each", (), strict=False
    )


class StudyFile(Section):
    """A study file."""

    case: str = key("case file, by its path from the folder of the study file", example="mao2016.toml")
    name: str | None = key("of the outputs, such as NAME.csv; without it that of the study file", None)
    search_equilibria: bool = key(
        "whether other equilibria are searched where the films suggest them, as a single run does, which "
        "takes as long as a thousand variants between rigid rings; without it a message reports such cases",
        False,
    )
    results: Literal["table", "final", "full"] = key(
        "table: what is collected; full: also a result file for each variant, in the folder NAME; final: "
        "the same without iterations; they are computed one by one then",
        "table",
    )
    set: Keys = key(SETTINGS.format("variant"), {})
    over: Over | None = key("keys that are varied, each over a list, a range or a single value", None)
    sample: Sample | None = key("keys that are drawn from distributions", None)
    duty: Duty | None = key(
        "duty cycle: rows with their shares, whose damage adds up to the life of each other variant", None
    )
    collect: Mapping[str, str] | None = key(
        "columns of the table, each with the name of an output and a unit, or with the quotient of two "
        'outputs of the same kind, "flexible.life_L10 / rigid.life_L10"; quantities of every roller, '
        '"inner_load [N]", are arrays in NAME.nc; without it every number of the summary',
        None,
        example={"life": "flexible.life_L10 [h]"},
    )
    plot: PlotTable | None = key("picture NAME.png of outputs over a key; what it needs is collected", None)
