"""Where the linear prediction of scatter is enough: `python -m benchmarks.linear_scatter`.

The paper's bearing with the tolerances of `configs/studies/mao2016_tolerances.toml`, from a quarter of them
to twice: how much of the variance of 1024 bearings the linear prediction explains, and by how much it
misses the distance from P10 to P90.
"""

import tempfile
from pathlib import Path

import flexbearing
from benchmarks.machine import describe

CASE = Path(__file__).parents[1] / "configs" / "mao2016.toml"
COUNT = 1024
STUDY = """case = "{case}"
[sample]
count = {count}
seed = 1
"bearing.clearance" = "truncated normal 75.5 um, {clearance} um, {low} um, {high} um"
"bearing.roller.drop" = "uniform {least_drop} um, {most_drop} um"
"bearing.form_error.roller_diameters" = "30 x uniform -{diameter} um, {diameter} um"
"bearing.form_error.outer.waves" = 2
"bearing.form_error.outer.amplitude" = "uniform 0 um, {amplitude} um"
"bearing.form_error.outer.crest" = "uniform 0 deg, 180 deg"
"lubricant.oil_fraction" = "uniform {least_oil}, {most_oil}"
"lubricant.inlet_temperature" = "normal 220 degC, {heat} K"
[collect]
life = "life_L10 [h]"
load = "max_roller_load [N]"
slip = "cage_slip [%]"
stiffness = "stiffness_zz [N/um]"
"""


def main() -> None:
    print(describe())
    for factor in (0.25, 0.5, 1.0, 2.0):
        print(f"tolerances x {factor:g}: " + "; ".join(map(told, scatter(factor))))


def scatter(factor: float) -> list[dict]:
    """Rows of the table of percentiles, with tolerances times a factor."""
    numbers = {
        "clearance": 4 * factor, "low": 75.5 - 10 * factor, "high": 75.5 + 10 * factor,
        "least_drop": 1.75 - 0.5 * factor, "most_drop": 1.75 + 0.5 * factor,
        "diameter": 0.5 * factor, "amplitude": 3 * factor, "heat": 3 * factor,
        "least_oil": 0.33 - 0.03 * factor, "most_oil": 0.33 + 0.03 * factor,
    }  # fmt: skip
    with tempfile.TemporaryDirectory() as name:
        file = Path(name) / "study.toml"
        file.write_text(STUDY.format(case=CASE, count=COUNT, **numbers))
        return flexbearing.study(file, Path(name) / "out").scatter[0].rows


def told(row: dict) -> str:
    """One output in words."""
    sampled, linear = (row[f"{kind}P90"] - row[f"{kind}P10"] for kind in ("", "linear_"))
    return (
        f"{row['output']} scatters by {100 * row['deviation'] / row['mean']:.2g} %, of the variance "
        f"{row['linear_explains [%]']:.0f} % linear, P90 - P10 {100 * (linear / sampled - 1):+.0f} %"
    )


if __name__ == "__main__":
    main()
