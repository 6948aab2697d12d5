"""The summary of a roller bearing, laid out as a page."""

from collections.abc import Iterator
from typing import Any

from rich import box
from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from flexbearing.report.sections import (
    clearance_steps,
    closing,
    life_factors,
    matrices,
    ordered_levels,
    regimes,
    skew,
    stresses,
)

# label, key in the block, place in a pair or object, format; SI units that no one reads are scaled
_ROWS: tuple[tuple[str, str, int | str | None, float, str], ...] = (
    ("largest inner load [N]", "max_roller_load_N", None, 1, ",.1f"),
    ("largest outer load [N]", "max_outer_load_N", None, 1, ",.1f"),
    ("loaded rollers", "loaded_rollers", None, 1, "d"),
    ("loaded arc [deg]", "loaded_arc_deg", None, 1, ".0f"),
    ("life L10 [Mrev]", "life_L10_Mrev", None, 1, ",.2f"),
    ("modified life [Mrev]", "modified_life_Mrev", None, 1, ",.2f"),
    ("stiffness of the bearing [kN/mm]", "stiffness_N_per_m", None, 1e-6, ",.1f"),
    ("stiffness with supports [kN/mm]", "total_stiffness_N_per_m", None, 1e-6, ",.1f"),
    ("ring displacement along load [um]", "displacement_along_load_um", None, 1, ".2f"),
    ("ring displacement across load [um]", "displacement_across_load_um", None, 1, ".2f"),
    ("largest raceway deviation [um]", "max_raceway_deviation_um", None, 1, ".2f"),
    ("cage slip [%]", "cage_slip_percent", None, 1, ".2f"),
    ("cage speed [rpm]", "cage_speed_rpm", None, 1, ",.0f"),
    ("largest pocket force [N]", "max_pocket_force_N", None, 1, ",.2f"),
    ("offset of the cage centre [um]", "cage_offset_um", None, 1, ",.1f"),
    ("largest pocket displacement [um]", "max_pocket_displacement_um", None, 1, ",.1f"),
    ("driving torque [N m]", "driving_torque_Nm", None, 1, ".4f"),
    ("peak pressure, inner [MPa]", "peak_pressure_MPa", "inner", 1, ",.0f"),
    ("peak pressure, outer [MPa]", "peak_pressure_MPa", "outer", 1, ",.0f"),
    ("smallest film, inner [um]", "minimum_film_um", "inner", 1, ".3f"),
    ("smallest film, outer [um]", "minimum_film_um", "outer", 1, ".3f"),
    ("smallest film ratio, inner", "minimum_lambda", "inner", 1, ".2f"),
    ("smallest film ratio, outer", "minimum_lambda", "outer", 1, ".2f"),
    ("power lost by sliding [W]", "power_loss_W", "sliding", 1, ",.2f"),
    ("  rolling shear [W]", "power_loss_W", "rolling", 1, ",.2f"),
    ("  drag of the mixture [W]", "power_loss_W", "drag", 1, ",.2f"),
    ("  pocket friction [W]", "power_loss_W", "pocket", 1, ",.2f"),
    ("  cage land [W]", "power_loss_W", "land", 1, ",.2f"),
    ("  churning [W]", "power_loss_W", "churning", 1, ",.2f"),
    ("  discretisation, no heat [W]", "power_loss_W", "transport", 1, ",.2f"),
    ("  together [W]", "power_loss_W", "total", 1, ",.2f"),
    ("driving power [W]", "driving_power_W", None, 1, ",.2f"),
)

_OPTIONAL = (
    "modified_life_Mrev",
    "minimum_lambda",
    "cage_offset_um",
    "max_pocket_displacement_um",
)  # rows that only some cases have

_ESTIMATED = {  # keys of the block with the names of their estimated errors
    "max_roller_load_N": "roller_load",
    "max_outer_load_N": "roller_load",
    "life_L10_Mrev": "life",
    "stiffness_N_per_m": "stiffness",
    "total_stiffness_N_per_m": "total_stiffness",
    "cage_slip_percent": "cage_slip",
}


def ending(numbers: dict[str, Any]) -> str:
    """Say in a line how a run ended.

    Parameters
    ----------
    numbers : dict
        the summary

    Returns
    -------
    str
        such as ``converged in 5 iterations, 12.3 s``
    """
    count, seconds = numbers["iterations"], f"{numbers['wall_time_s']:.1f} s"
    iterations = "1 iteration" if count == 1 else f"{count} iterations"
    if numbers["status"] != "converged":
        message = f": {numbers['message']}" if numbers["message"] else ""
        how = f" ({numbers['ending']})" if numbers["status"] == "not solved" and numbers["ending"] else ""
        return f"NOT CONVERGED: {numbers['status']}{how} after {iterations}, {seconds}{message}"
    if count == 0:
        return f"converged; no part is flexible, so nothing was iterated, {seconds}"
    return f"converged in {iterations}, {seconds}"


def page(numbers: dict[str, Any]) -> Iterator[RenderableType]:
    """Table, stiffness, clearance, life, assumed and calibrated keys, notes, and how the run ended."""
    yield Text(numbers["title"], style="bold")
    if numbers["rigid"] or numbers["flexible"]:
        yield _table(numbers["rigid"], numbers["flexible"], numbers["error_estimate"] or {})
    yield from ordered_levels(numbers["choices"] or {}, numbers["error_estimate"] or {})
    yield from matrices(numbers["flexible"])
    yield from regimes(numbers["regimes"])
    yield from skew({name: numbers[name] for name in ("rigid", "flexible")})
    yield from clearance_steps(numbers["clearance"])
    yield from life_factors(numbers["life"])
    yield from stresses(numbers["stresses"])
    yield from closing(numbers, ending(numbers))


def _table(
    rigid: dict[str, Any] | None, flexible: dict[str, Any] | None, errors: dict[str, float | None]
) -> Table:
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False)
    table.add_column("")
    for name in ("rigid", "flexible", *(["+-"] if errors else []), "change [%]"):
        table.add_column(name, justify="right")
    for label, key, part, scale, form in _ROWS:
        before, after = (_number(block, key, part) for block in (rigid, flexible))
        if key in _OPTIONAL and before is None and after is None:
            continue
        # as Text: rich would take the unit in brackets for a markup tag
        error = [_error(errors, key, after, scale)] if errors else []
        table.add_row(
            Text(label),
            _shown(before, scale, form),
            _shown(after, scale, form),
            *error,
            _change(before, after),
        )
    return table


def _error(errors: dict[str, float | None], key: str, value: float | None, scale: float) -> str:
    """Estimated error in the unit of its row; empty where none is estimated."""
    share = errors.get(_ESTIMATED.get(key, ""))
    if share is None or value is None:
        return ""
    error = 100 * share if key == "cage_slip_percent" else share * abs(value) * scale
    return f"{float(f'{error:.2g}'):,.10g}"


def _number(block: dict[str, Any] | None, key: str, part: int | str | None) -> float | None:
    if block is None or block[key] is None:
        return None
    return block[key] if part is None else block[key][part]


def _shown(value: float | None, scale: float, form: str) -> str:
    return "-" if value is None else format(value * scale, form)


def _change(before: float | None, after: float | None) -> str:
    if before is None or after is None or before == 0:
        return "-"
    return f"{100 * (after - before) / abs(before):+.1f}"
