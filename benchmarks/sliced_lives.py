"""a_ISO slice by slice against once for the bearing, of ten bearings over misalignment.

`python -m benchmarks.sliced_lives`. Sizes of NU205 to NU214: ISO 15 and catalogues, from memory;
rollers are those that `flexbearing new` chooses. Each carries a sixth of its C_r at 1500 rpm.
"""

from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory

import flexbearing
from flexbearing.api import read_case
from flexbearing.build import roller_bearing
from flexbearing.catalogue.new import case_text
from flexbearing.life import roller_lives

SIZES = {  # [mm] d, D, B, F, E
    "NU205": (25, 52, 15, 31.5, 46.5),
    "NU206": (30, 62, 16, 37.5, 55.5),
    "NU207": (35, 72, 17, 44, 64),
    "NU208": (40, 80, 18, 49.5, 71.5),
    "NU209": (45, 85, 19, 54.5, 76.5),
    "NU210": (50, 90, 20, 59.5, 81.5),
    "NU211": (55, 100, 21, 66, 90),
    "NU212": (60, 110, 22, 72, 100),
    "NU213": (65, 120, 23, 78.5, 108.5),
    "NU214": (70, 125, 24, 83.5, 113.5),
}
ENTRIES = ("bore", "outside", "width", "inner_raceway", "outer_raceway")
TILTS = (0, 1, 2, 3, 4)  # [arcmin]


def ratios(file: Path, load: float) -> list[tuple[float, float]]:
    """a_ISO once for the bearing, and the life slice by slice over that with it, at each tilt."""
    found = []
    for tilt in TILTS:
        keys = {"operation.misalignment": f"{tilt} arcmin", "operation.radial_load": f"{load!r} N"}
        once, each = (
            flexbearing.run(file, {**keys, "life.modification": way}).rigid for way in ("bearing", "slices")
        )
        lived = once["modified_life"]
        found.append((lived / once["reference_life"], each["modified_life"] / lived))
    return found


def main() -> None:
    print("a_ISO once for the bearing, and slice by slice over it, at a misalignment of")
    print(f"{'':8}{'C_r/6 [kN]':>11}", *(f"{tilt:>9} arcmin" for tilt in TILTS))
    with TemporaryDirectory() as folder:
        for name, sizes in SIZES.items():
            page = dict(zip(ENTRIES, (f"{size} mm" for size in sizes), strict=True))
            file = Path(folder) / f"{name}.toml"
            options = {**page, "load": "5 kN", "speed": "1500 rpm", "oil": "ISO VG 68"}
            file.write_text(case_text("cylindrical_roller", options, file)[0])
            case = read_case(file)
            load = roller_lives.rated(case, roller_bearing.parts(case)).dynamic / 6
            found = ratios(file, load)
            falls = all(after < before for (_, before), (_, after) in pairwise(found))
            cells = (f"{once:8.3f} {ratio:6.4f}" for once, ratio in found)
            print(f"{name:8}{load / 1e3:11.2f}", *cells, "falls" if falls else "NOT MONOTONE", flush=True)


if __name__ == "__main__":
    main()
