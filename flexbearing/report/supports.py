"""What the summary says of lines and springs that hold the outer ring."""

from collections.abc import Iterator
from math import hypot
from typing import Any

from rich.console import RenderableType
from rich.text import Text

from flexbearing.report.sections import listed, right_aligned

SHEARED = 1e-4  # of the rollers' force: what radial springs leave to tangential ones


def supports(structure: dict[str, Any] | None) -> Iterator[RenderableType]:
    """Forces of lines or pressure of a foundation; nothing for a ring that is held otherwise."""
    outer = (structure or {}).get("outer", {})
    if "lines" in outer:
        yield from _lines(outer["lines"])
    if "foundation" in outer:
        yield from listed("foundation of the outer ring", _foundation(outer["foundation"]))


def _lines(lines: dict[str, Any]) -> Iterator[RenderableType]:
    can = "push and pull" if lines["pull"] else "push only"
    yield Text(f"lines that hold the outer ring: they {can}", style="bold")
    table = right_aligned("line [deg]", "force [N]")
    table.add_column("")
    for place, azimuth in enumerate(lines["azimuth_deg"]):
        force, carries = lines["force_N"][place], lines["carries"][place]
        state = ("pushes" if force > 0 else "pulls") if carries else "lifted off"
        table.add_row(f"{azimuth:.1f}", f"{force:,.1f}", state)
    yield table
    yield from listed("together", [_balance(lines)])


def _foundation(springs: dict[str, Any]) -> list[str]:
    can = "push and pull" if springs["pull"] else "push only"
    arcs = ", ".join(f"{begin:.0f} to {end % 360:.0f} deg" for begin, end in springs["touching_deg"])
    least = springs["least_pressure_MPa"]
    return [
        f"springs {can}; largest pressure {springs['largest_pressure_MPa']:.3g} MPa at "
        f"{springs['azimuth_deg']:.0f} deg, x = {springs['x_mm']:.1f} mm",
        f"pushes at azimuths {arcs or 'none'}; {100 * springs['open_share']:.0f} % of the surface "
        + (f"is pulled, by up to {-least:.3g} MPa" if least < 0 else "is lifted off"),
        _balance(springs),
    ]


def _balance(held: dict[str, Any]) -> str:
    (y, z), (along_y, along_z) = held["resultant_N"], held["rollers_N"]
    rest = hypot(along_y - y, along_z - z) > SHEARED * hypot(along_y, along_z)
    return (
        f"radial forces hold ({y:,.1f}, {z:,.1f}) N along (y, z) of ({along_y:,.1f}, {along_z:,.1f}) N "
        "of the rollers" + (", tangential springs the rest" if rest else "")
    )
