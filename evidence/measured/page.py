"""Pages of measurements and their list, as Markdown."""

import math
from collections.abc import Iterable, Mapping

from evidence.markdown import cells, shown
from evidence.measured.declared import Experiment, Input, Prediction, Printed
from evidence.measured.verdict import verdict

Registered = tuple[Prediction, Printed | None]


def _range(given: Input) -> str:
    scale = ", by its logarithm" if given.logarithmic else ""
    unit = f" {given.unit}".rstrip().replace("um", "µm")
    return f"{shown(given.low)} to {shown(given.high)}{unit}{scale}"


def _share(share: float) -> str:
    return f"{share:.2f}" if math.isfinite(share) else "none varies it"


def _band(prediction: Prediction, unit: str) -> str:
    numbers = ", ".join(shown(n, 4) for n in (prediction.low, prediction.median, prediction.high))
    return f"{numbers} {unit}".removesuffix(" -")


def _from(experiment: Experiment, prediction: Prediction) -> str:
    """The input that the width comes from."""
    known = {name: share for name, share in prediction.shares.items() if math.isfinite(share)}
    return max(known, key=lambda name: known[name]) if known else ""


def _printed(printed: Printed | None) -> str:
    return f"{printed.text} ({printed.where})" if printed else "none"


def page(experiment: Experiment, prediction: Prediction, printed: Printed | None) -> str:
    """The page of a measurement."""
    unsolved = f", {prediction.unsolved} not solved" if prediction.unsolved else ""
    case = f" Case file: `{experiment.case_file}`." if experiment.case_file else ""
    origin = _from(experiment, prediction)
    lines = [
        f"# {experiment.title}",
        "",
        f"**Verdict: {verdict(prediction, printed)}** (`python -m evidence {experiment.name}`).",
        "",
        f"**Source:** {experiment.source} **Given:** {experiment.given}",
        "",
        f"**Run:** {experiment.run}{case}",
        "",
        f"|{experiment.quantity}|value|",
        "|---|---|",
        cells("predicted, 5, 50 and 95 %", _band(prediction, experiment.unit)),
        cells("printed", _printed(printed)),
        "",
        f"Registered {prediction.date}, version {prediction.version}, digest {prediction.digest}, "
        f"{prediction.rows} bearings{unsolved}. "
        + (
            f"The width comes most from `{origin}`. Shares are total Sobol indices of {experiment.count} base points: "
            "trust their order, not their size."
            if origin
            else "The band has no width."
        ),
        "",
        "|input that the source does not give|range|reason|share of the variance|",
        "|---|---|---|---|",
        *(
            cells(f"`{each.name}`", _range(each), each.reason, _share(prediction.shares[each.name]))
            for each in experiment.inputs
        ),
        "",
        f"**What would refute it:** {experiment.refuted}",
        "",
    ]
    if experiment.missing:
        lines += [f"**Left out:** {experiment.missing}", ""]
    if printed is None and experiment.needed:
        lines += [f"**Needed:** {experiment.needed}.", ""]
    return "\n".join(lines).rstrip() + "\n"


HEAD = """## Measurements

The prediction is registered first, the printed value stored by a later commit (tested). A value in the band from 5 to
95 % is *inside*; else it is *outside* by its distance from the band over the width of the band. What a source only says of a
side is *not decided* where the band lies on both. Bands say what inputs leave open that the source does not give.

|measurement|predicted, 5, 50, 95 %|printed|verdict|
|---|---|---|---|
"""


def listed(experiments: Iterable[Experiment], registered: Mapping[str, Registered]) -> str:
    """The part of the index that lists measurements, those without a value last."""
    ordered = sorted(experiments, key=lambda each: registered[each.name][1] is None)
    rows = [
        cells(
            f"[{each.title}]({each.name}.md)",
            _band(prediction, each.unit),
            printed.text if printed else "",
            verdict(prediction, printed),
        )
        for each in ordered
        for prediction, printed in [registered[each.name]]
    ]
    without = sum(printed is None for _, printed in registered.values())
    count = f"{len(rows) - without} measurements and statements, {without} predictions without a value."
    return f"{HEAD}{chr(10).join(rows)}\n\n{count}\n"
