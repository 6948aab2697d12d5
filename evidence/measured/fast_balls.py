"""Measurements on fast ball bearings in oil."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from evidence.measured.declared import Experiment, Input
from evidence.measured.draws import Draws

NASA_1975 = "Bamberger, Zaretsky and Signer, NASA TN D-7870 (1975), abstract."
GIVEN = (
    "Angular-contact ball bearing of 120 mm bore, thrust to 22 240 N, to 25 000 rpm. Recalled, not read: 15 balls "
    "of 20.6375 mm on 155 mm, 24°, conformities 0.54 and 0.52. Oil, cage and the speed without skid are not in what "
    "could be read."
)
MISSING = (
    "What was printed of the skid was known when the ranges were chosen, by their reasons alone. "
    "Oil under the races heats and cools rings, grooves and oil differently; clearance and contact angle stay those "
    "of a bearing at rest. Slip is against balls that roll without slip in the middle of both contacts."
)
AGAIN = (
    "Registered more than once: the first band, -0.34, 1.9 and 15.5 %, was of longer inlets, which changed nothing, "
    "and of pockets whose friction did not drive the cage; the second, -0.33, 1.7 and 15.5 %, had the rolling friction "
    "of line contacts. "
)
AGAIN_OVER_SPEED = (
    "Registered more than once: the first band, 0.16, 0.79 and 8.9 %, of fewer points and three speeds, lay above zero "
    "and would have met the statement; the second, -0.09, 0.89 and 8.8 %, had the rolling friction of line contacts. "
)
SPEEDS = (12000, 25000)  # [rpm]
CAGE_SLIP = "cage_slip [%]"
BETWEEN = 12.0  # [mm] from the pitch circle to the land, on the diameter
SETTINGS: dict[str, object] = {
    "bearing.balls": 15,
    "bearing.pitch_diameter": "155 mm",
    "bearing.contact_angle": "24 deg",
    "bearing.ball.diameter": "20.6375 mm",
    "bearing.inner.radius": "11.14425 mm",
    "bearing.outer.radius": "10.7315 mm",
    "bearing.cage.land_flow": "vortices",
    "operation.control": "oil",
    "lubricant.oil": "MIL-PRF-23699",
    "lubricant.traction": "eyring",
    "lubricant.film_heating": True,
}
UNKNOWN = (
    Input(
        name="lubricant.inlet_temperature",
        low=100,
        high=200,
        unit="degC",
        reason="ester oils of turbines, fed at some 120 °C; races are hotter",
    ),
    Input(
        name="lubricant.oil_fraction",
        low=0.002,
        high=0.05,
        logarithmic=True,
        reason="jets or oil under the races; mist to flooded cages",
    ),
    Input(name="lubricant.limiting_ratio", low=0.03, high=0.07, reason="traction of ester oils"),
    Input(name="lubricant.eyring_stress", low=2, high=8, unit="MPa", reason="the same"),
    Input(
        name="lubricant.inlet_length",
        low=0.2,
        high=3,
        logarithmic=True,
        reason="half-widths of the contact, from films that are starved to 0.6 times to flooded ones",
    ),
    Input(name="guided by the inner ring", low=0, high=1, reason="from 0.5 on, below by the outer ring"),
    Input(
        name="bearing.cage.land_clearance", low=0.3, high=1.0, unit="mm", reason="machined cages of this bore"
    ),
    Input(
        name="bearing.cage.land_width", low=5, high=20, unit="mm", reason="both lands of a ring 30 mm wide"
    ),
    Input(
        name="bearing.cage.pocket_clearance", low=0.15, high=0.5, unit="mm", reason="0.7 to 2.5 % of a ball"
    ),
    Input(name="bearing.cage.pocket_friction", low=0.01, high=0.1, reason="silver-plated steel in oil"),
)


def slip_at(draws: Draws, speed: int) -> NDArray:
    """Slip of the cage (rows) [%] at a speed [rpm]."""
    inner = draws.values["guided by the inner ring"] >= 0.5
    keys = {
        "bearing.cage.guidance": np.where(inner, "inner", "outer").tolist(),
        "bearing.cage.land_diameter": [f"{155 + (-BETWEEN if each else BETWEEN)} mm" for each in inner],
    }
    return draws.study([CAGE_SLIP], {"operation.inner_speed": f"{speed} rpm"}, keys)[0]


def fastest(draws: Draws) -> NDArray:
    """Slip of the cage at the highest speed [%]."""
    return slip_at(draws, SPEEDS[-1])


def growth(draws: Draws) -> NDArray:
    """Change of the slip of the cage between the speeds [%]."""
    slow, fast = (slip_at(draws, speed) for speed in SPEEDS)
    return fast - slow


def thrust(low: float, high: float, reason: str) -> Input:
    """An axial load [kN] that could not be read."""
    return Input(name="operation.load.axial", low=low, high=high, unit="kN", logarithmic=True, reason=reason)


SKID = Experiment(
    name="skid-120-mm",
    title="Largest skid of a ball bearing of 120 mm bore",
    source=NASA_1975,
    given=GIVEN,
    quantity="slip of the cage at 25 000 rpm under the lowest thrust",
    unit="%",
    run="Balls in oil in a cage on a land; films that warm by their shear.",
    case_file="configs/harris218.toml",
    settings=SETTINGS,
    inputs=(
        thrust(4.4, 8.9, "lowest thrust: 1000 to 2000 lb, as only the largest one could be read"),
        *UNKNOWN,
    ),
    count=8,
    predict=fastest,
    refuted="A largest slip outside the band, with a cage and an oil that are in these ranges.",
    missing=AGAIN + MISSING,
    needed="the largest slip that was measured",
)
EXPERIMENTS = (
    SKID,
    replace(
        SKID,
        name="skid-over-speed",
        title="Skid of a ball bearing of 120 mm bore over the speed",
        quantity="change of the slip of the cage from 12 000 to 25 000 rpm",
        run="The same bearings at 12 000 and 25 000 rpm, at thrusts up to the largest.",
        inputs=(thrust(4.4, 22.24, "1000 lb to the largest thrust"), *UNKNOWN),
        predict=growth,
        refuted="Slip that falls as the speed rises at any of these thrusts.",
        missing=AGAIN_OVER_SPEED + MISSING,
        needed="whether the slip grows with the speed",
    ),
)
