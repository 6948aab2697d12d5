"""How parts are drawn: their colours, and dashed lines for what a case does not dimension."""

from typing import Any

OUTER, INNER, ELEMENT, SHAFT, HOUSING, CAGE = "#c9d9ea", "#d5e6cf", "#f4f1e6", "#eadfcb", "#e3e3e3", "#f3d9b1"
AXES, LOAD, TURNING = "#0b5394", "#a61c00", "#38761d"  # lines: axes, loads, sense of rotation
SCHEMATIC: dict[str, Any] = {"ls": (0, (4, 2)), "lw": 0.6, "ec": "0.35"}
RIGID_WIDTH, RIGID_WALL = 1.6, 0.5  # of a ring that the case does not describe, over roller length, diameter
