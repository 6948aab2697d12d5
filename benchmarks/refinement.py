"""Largest flexible load under refinement of mesh and order: `python -m benchmarks.refinement`."""

import tempfile
from pathlib import Path

import flexbearing
from benchmarks.machine import describe

CASE = "configs/mao2016.toml"
LEVELS = {
    "as given": [],
    "order 4": ["accuracy.element_order=4"],
    "mesh 2 mm": ["accuracy.mesh_size=2 mm"],
    "4 axial shapes": ["accuracy.axial_shapes=4"],
    "40 slices": ["accuracy.slices=40"],
    "whole solids, order 4, mesh 2.4 / 1.7 mm": [
        "accuracy.structure=solid",
        "accuracy.element_order=4",
        "accuracy.mesh_size=2.4 mm",
        "accuracy.raceway_mesh_size=1.7 mm",
    ],
}


def main() -> None:
    print(describe())
    given = None
    with tempfile.TemporaryDirectory() as folder:
        for name, settings in LEVELS.items():
            result = flexbearing.run(CASE, settings, output=Path(folder) / "out.h5")
            load, life = result.flexible["inner_load"].max(), float(result.flexible["life_L10"]) / 1e6
            given = given or load
            figures = result.attributes["structure"]
            print(
                f"{name:41s} largest load {load:8.2f} N ({100 * (load / given - 1):+.3f} %), "
                f"life {life:.4f} Mrev, unknowns outer {figures['outer']['unknowns']}, "
                f"inner {figures['inner']['unknowns']}, {result.attributes['wall_time_s']:.1f} s",
                flush=True,
            )


if __name__ == "__main__":
    main()
