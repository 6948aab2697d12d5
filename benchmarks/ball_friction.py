"""Friction torque of balls in oil by cause, beside two formulas: `python -m benchmarks.ball_friction`.

Constants of SKF and Palmgren are recalled, but for SKF's of series 62. SKF's drag in a bath is left out.
"""

from dataclasses import dataclass
from math import exp, pi, sqrt

from flexbearing.api import read_case
from flexbearing.runs.angular_contact import build
from quasidynamic import oil_at

OILED: dict[str, object] = {
    "operation.control": "oil",
    "lubricant.inlet_temperature": "70 degC",
    "lubricant.oil_fraction": 0.02,
    "lubricant.traction": "eyring",
    "lubricant.limiting_ratio": 0.05,
    "lubricant.film_heating": True,
}
OILS = ("ISO VG 32", "ISO VG 68")
FRICTION = 0.05  # [-] of films of mineral oil, SKF
BOUNDARY = 0.12  # [-] SKF
STARVING = 3e-8  # SKF, low oil bath and jet


@dataclass(frozen=True)
class Shown:
    """A bearing and what the formulas take of it: mm, N, rpm."""

    name: str
    file: str
    bore: float
    outside: float
    speed: float
    viscous: tuple[float, ...]  # f_0 of oil mist, bath and jet
    static_rating: float
    thrust: float = 0.0
    radial: float = 0.0
    thrust_factor: float = 0.0  # Y_0 of ISO 76
    effective_thrust: float = 0.0  # 0.9 cot(alpha), of Palmgren's load

    @property
    def mean(self) -> float:
        return (self.bore + self.outside) / 2


SHOWN = (
    Shown("7008, 500 N, 15 000 rpm", "configs/rivera2021_7008.toml", 40, 68, 15e3, (1.7, 3.3, 6.6), 12e3,
          thrust=500, thrust_factor=0.46, effective_thrust=3.36),
    Shown("6208, 3 kN radial, 3000 rpm", "configs/catalogue/6208.toml", 40, 80, 3e3, (1, 2, 4), 19e3,
          radial=3000),
    Shown("218, 17.8 kN, 10 000 rpm", "configs/harris218.toml", 90, 160, 10e3, (1.7, 3.3, 6.6), 93e3,
          thrust=17800, thrust_factor=0.26, effective_thrust=1.07),
)  # fmt: skip


def ours(shown: Shown, oil: str, rolling: str) -> tuple[float, ...]:
    """Torque [N m] by cause."""
    case = read_case(shown.file, OILED | {"lubricant.oil": oil, "lubricant.rolling": rolling})
    model, operation = build(case)
    found = model.solve(operation).oil
    assert found  # of balls in oil
    heat = (found.sliding_heat, found.rolling_heat, found.drag_heat)
    return tuple(each.sum() / (shown.speed * pi / 30) for each in heat)


def skf(shown: Shown, viscosity: float) -> tuple[float, float]:
    """Sliding and rolling [N m] at a viscosity [mm2/s]."""
    mean, n = shown.mean, shown.speed
    if shown.radial:
        rolling, sliding = (
            3.9e-7 * mean**1.96 * shown.radial**0.54,
            3.23e-3 * mean**-0.26 * shown.radial ** (5 / 3),
        )
    else:
        rolling = 5.03e-7 * mean**1.97 * (1.9e-12 * mean**4 * n**2 + 1.97 * shown.thrust) ** 0.54
        sliding = 1.3e-2 * mean**0.26
        sliding *= (1.91e-12 * mean**4 * n**2) ** (4 / 3) + 0.68 * shown.thrust ** (4 / 3)
    heating = 1 / (1 + 1.84e-9 * (n * mean) ** 1.28 * viscosity**0.64)
    gap = (3.1 if shown.radial else 4.4) / (2 * (shown.outside - shown.bore))
    starved = exp(-STARVING * viscosity * n * 2 * mean * sqrt(gap))
    boundary = exp(-2.6e-8 * (n * viscosity) ** 1.4 * mean)
    friction = boundary * BOUNDARY + (1 - boundary) * FRICTION
    return 1e-3 * friction * sliding, 1e-3 * heating * starved * rolling * (viscosity * n) ** 0.6


def palmgren(shown: Shown, viscosity: float) -> tuple[float, tuple[float, ...]]:
    """Part of the load, and viscous part of mist, bath and jet [N m], at a viscosity [mm2/s]."""
    load = max(shown.radial, shown.thrust_factor * shown.thrust) / shown.static_rating
    factor = 4e-4 * load**0.55 if shown.radial else 1e-3 * load**0.33
    by_load = factor * (shown.radial or shown.effective_thrust * shown.thrust) * shown.mean
    unit = 1e-7 * (viscosity * shown.speed) ** (2 / 3) * shown.mean**3
    return 1e-3 * by_load, tuple(1e-3 * each * unit for each in shown.viscous)


def main() -> None:
    print("torque [N m]|ours: sliding + rolling + drag|rolling that heats itself", end="|")
    print("SKF: sliding + rolling|Palmgren: load + mist, bath, jet")
    for shown in SHOWN:
        for name in OILS:
            oil = oil_at(name, 343.15)
            viscosity = 1e6 * oil.viscosity / oil.density
            parts = ours(shown, name, "biboulet-houpert")
            heated = ours(shown, name, "goksem-hargreaves")
            theirs = skf(shown, viscosity)
            load, viscous = palmgren(shown, viscosity)
            print(
                f"{shown.name}, {name}|{sum(parts):.3g} = " + " + ".join(f"{each:.3f}" for each in parts)
                + f"|{heated[1]:.3f}|{sum(theirs):.3g} = " + " + ".join(f"{each:.3f}" for each in theirs)
                + f"|{load:.3f} + " + ", ".join(f"{each:.3f}" for each in viscous)
            )  # fmt: skip


if __name__ == "__main__":
    main()
