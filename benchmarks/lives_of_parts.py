"""a_ISO of each slice of rollers, and of each row of balls, against once for the bearing.

`python -m benchmarks.lives_of_parts`. Ten cylindrical roller bearings under a sixth of C_r over misalignment,
and ten pairs of angular-contact bearings over the axial load, all at 1500 rpm in ISO VG 68. Sizes of NU205 to
NU214 and 7205 to 7214: ISO 15 and catalogues, from memory; rollers and balls are those that `flexbearing new`
chooses. Pairs are back to back at 40 degrees, preloaded by a fiftieth of C_r of one.
"""

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import flexbearing
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.catalogue.new import case_text
from flexbearing.life import ball_lives, roller_lives

SIZES = {  # [mm] d, D, B, F, E
    "05": (25, 52, 15, 31.5, 46.5),
    "06": (30, 62, 16, 37.5, 55.5),
    "07": (35, 72, 17, 44, 64),
    "08": (40, 80, 18, 49.5, 71.5),
    "09": (45, 85, 19, 54.5, 76.5),
    "10": (50, 90, 20, 59.5, 81.5),
    "11": (55, 100, 21, 66, 90),
    "12": (60, 110, 22, 72, 100),
    "13": (65, 120, 23, 78.5, 108.5),
    "14": (70, 125, 24, 83.5, 113.5),
}
ENTRIES: tuple[str, ...] = ("bore", "outside", "width", "inner_raceway", "outer_raceway")
TILTS = (0, 1, 2, 3, 4)  # [arcmin]
AXIAL = (0, 32, 16, 8, 4)  # C_r over the axial load; 0: none


def roller_cases(file: Path, sizes: dict[str, str]) -> Iterator[dict[str, Any]]:
    """Settings of a case with rollers, which is written to the file."""
    options = {**sizes, "load": "5 kN", "speed": "1500 rpm", "oil": "ISO VG 68"}
    file.write_text(case_text("cylindrical_roller", options, file)[0])
    case = read_case(file)
    load = roller_lives.rated(case, roller_bearing.parts(case)).dynamic / 6
    for tilt in TILTS:
        yield {"operation.radial_load": f"{load!r} N", "operation.misalignment": f"{tilt} arcmin"}


def pair_cases(file: Path, sizes: dict[str, str]) -> Iterator[dict[str, Any]]:
    """Settings of a pair of ball bearings."""
    sizes = {name: sizes[name] for name in ENTRIES[:3]}
    options = {**sizes, "angle": "40 deg", "axial": "1 kN", "speed": "1500 rpm", "oil": "ISO VG 68"}
    file.write_text(case_text("angular_contact_ball", options, file)[0])
    rating = ball_lives.rated(read_case(file)).dynamic
    pair = {
        "bearing.pair.arrangement": "back_to_back", "bearing.pair.distance": sizes["width"],
        "bearing.pair.preload": f"{rating / 50!r} N", "life.lubrication": "a_ISO",
        "life.cleanliness": "oil, no or off-line filter, -/17/14",
    }  # fmt: skip
    for share in AXIAL:
        yield {**pair, "operation.load.axial": f"{rating / share if share else 0.0!r} N"}


def compared(file: Path, settings: dict[str, Any], parts: str) -> str:
    """a_ISO once for the bearing, and the life with that of parts over the life with it."""
    once, each = (
        flexbearing.run(file, {**settings, "life.modification": way}).attributes["life"]["rigid"]
        for way in ("bearing", parts)
    )
    (factor,) = (factor["value"] for factor in once["factors"] if factor["name"] == "a_ISO")
    return f"{factor:8.3f} {each['modified_Mrev'] / once['modified_Mrev']:6.4f}"


def main() -> None:
    with TemporaryDirectory() as folder:
        for series, cases, parts, over in (
            ("NU2", roller_cases, "slices", [f"{tilt} arcmin" for tilt in TILTS]),
            ("72", pair_cases, "rows", [f"C_r/{share}" if share else "preload" for share in AXIAL]),
        ):
            print(f"a_ISO once for the bearing, and life with that of {parts} over the life with it")
            print(f"{'':8}", *(f"{words:>15}" for words in over))
            for name, sizes in SIZES.items():
                file = Path(folder) / f"{series}{name}.toml"
                page = dict(zip(ENTRIES, (f"{size} mm" for size in sizes), strict=True))
                cells = (compared(file, settings, parts) for settings in cases(file, page))
                print(f"{series}{name:5}", *cells, flush=True)


if __name__ == "__main__":
    main()
