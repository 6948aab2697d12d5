"""Drawings of shipped cases in the documents.

`python -m flexbearing.example_drawings configs docs/images/drawings` writes them.
"""

import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_ON_SHAFT = (
    "inner.kind=ring_on_shaft", "inner.bore=45 mm", "inner.thickness=6.5 mm", "inner.width=19 mm",
    "inner.track_width=10 mm", "inner.shaft_thickness=8 mm", "inner.shaft_length=42 mm",
    "materials.shaft=structural steel", "inner.fit=frictionless", "inner.shoulder_diameter=52 mm",
    "inner.clamping=5 kN", "operation.tilt=free",
)  # fmt: skip
_RING = ("outer.kind=ring", "outer.thickness=4.984 mm", "outer.width=19 mm", "operation.tilt=free")
_PLANET = (
    'outer.tooth_azimuths=["90 deg", "270 deg"]', 'outer.tooth_radial=["-2 kN", "-2 kN"]',
    'outer.tooth_tangential=["2.225 kN", "-2.225 kN"]', "outer.tooth_radius=46 mm",
)  # fmt: skip
_CIRCLES = ("bearing.roller.drop=", "bearing.roller.straight_length=5 mm")
_DESIGN = ("bearing.roller.drop=", "bearing.roller.design_load=4 kN")


@dataclass(frozen=True)
class Example:
    """A drawing of the documents."""

    name: str  # of its file, without ending
    text: str  # what it shows
    case: str  # file among the shipped ones
    sheet: str  # name of the drawing
    settings: tuple[str, ...] = ()
    page: str = ""  # of the keys of a case that shows it; empty: another page does


EXAMPLES = (
    Example("roller-bearing", "Roller bearing with fits, shaft and housing", "nu209_fits.toml", "section",
            page="roller-bearing"),
    Example("roller-bearing-axis", "Axes, azimuth, sense of rotation and load direction", "mao2016.toml",
            "along-axis", page="roller-bearing"),
    Example("roller-profile", "Roller profile, the drop magnified", "nu209.toml", "profile",
            page="roller-bearing"),
    Example("cage", "Cage, its pockets and its land, not to scale", "mao2016.toml", "cage",
            ("bearing.cage.pocket_clearance=0.1 mm",), page="roller-bearing"),
    Example("tapered-bearing", "Tapered roller bearing, rib of its inner ring", "32207.toml", "section",
            page="tapered-bearing"),
    Example("thrust-bearing", "Roller thrust bearing", "81110.toml", "section", page="tapered-bearing"),
    Example("spherical-bearing", "Spherical roller bearing", "22210.toml", "section", page="tapered-bearing"),
    Example("squirrel-cage", "Squirrel cage, and ring on a hollow shaft", "mao2016.toml", "section",
            page="rings"),
    Example("squirrel-cage-bars", "Bars of the squirrel cage", "mao2016.toml", "bars", page="rings"),
    Example("ring-on-shaft", "Ring on shaft with its track between ribs, and a shoulder",
            "nu209.toml", "section", _ON_SHAFT, page="rings"),
    Example("elastic-ring", "Elastic outer ring on a foundation of springs", "nu209.toml", "section",
            (*_RING, "outer.support=foundation", "outer.foundation_radial=300 N/mm^3"), page="rings"),
    Example("housing", "Elastic outer ring in its housing", "nu209.toml", "section",
            (*_RING, "outer.support=housing", "outer.housing_thickness=8 mm", "outer.housing_width=24 mm",
             "outer.housing_clearance=10 um"), page="rings"),
    Example("planet-rim", "Rim of a planet gear with its tooth forces", "nu209.toml", "along-axis",
            (*_RING, "outer.support=planet", *_PLANET), page="rings"),
    Example("profile-crowned", "crowned", "nu209.toml", "profile",
            ("bearing.roller.profile=crowned", *_CIRCLES, "bearing.roller.crown_radius=1 m")),
    Example("profile-tangent-crowned", "tangent_crowned", "nu209.toml", "profile",
            ("bearing.roller.profile=tangent_crowned", *_CIRCLES, "bearing.roller.crown_radius=600 mm")),
    Example("profile-iso16281", "iso16281", "nu209.toml", "profile",
            ("bearing.roller.profile=iso16281", "bearing.roller.drop=")),
    Example("profile-lundberg", "lundberg", "nu209.toml", "profile",
            ("bearing.roller.profile=lundberg", *_DESIGN)),
    Example("profile-johns-gohar", "johns_gohar", "nu209.toml", "profile",
            ("bearing.roller.profile=johns_gohar", *_DESIGN)),
    Example("profile-fujiwara-kawase", "fujiwara_kawase", "nu209.toml", "profile",
            ("bearing.roller.profile=fujiwara_kawase", *_DESIGN, "bearing.roller.load_factor=1.5",
             "bearing.roller.crowned_share=0.6", "bearing.roller.end_drop=20 um")),
    Example("profile-points", "points", "nu209.toml", "profile",
            ("bearing.roller.profile=points", "bearing.roller.drop=",
             'bearing.roller.point_positions=["0 mm", "3 mm", "4.8005 mm"]',
             'bearing.roller.point_drops=["0 um", "1.5 um", "12 um"]')),
    Example("four-point", "Ball of a four-point bearing", "joshi2015_qj309.toml", "section",
            page="ball-bearing"),
    Example("four-point-axis", "Axes, azimuth, sense of rotation, load and moments", "slewing_bolted.toml",
            "along-axis", page="ball-bearing"),
    Example("ball-cage", "Squirrel cage around the balls of an angular-contact bearing",
            "harris218_cage.toml", "section", page="rings"),
    Example("bolted-ring", "Ball of a four-point bearing between bolted rings",
            "slewing_bolted.toml", "section", page="rings"),
    Example("angular-contact", "Ball of an angular-contact bearing with fits",
            "catalogue/7208.toml", "section", page="ball-bearing"),
    Example("angular-contact-axis", "Axes, azimuth and sense of rotation", "harris218.toml", "along-axis",
            page="ball-bearing"),
    Example("deep-groove", "Ball of a deep groove bearing under light thrust", "6209.toml", "section",
            page="ball-bearing"),
)  # fmt: skip


def drawn(example: Example, configs: Path) -> str:
    """SVG of an example, by the cases in a folder."""
    from flexbearing import api

    sheets = api.drawings(api.read_case(configs / example.case, example.settings))
    return next(sheet.svg for sheet in sheets if sheet.name == example.sheet)


def pictures(page: str) -> Iterator[str]:
    """Lines of Markdown with the examples of a page of keys."""
    for example in EXAMPLES:
        if example.page == page:
            yield from (
                f"{example.text}:",
                "",
                f"![{example.text}](../../images/drawings/{example.name}.svg)",
                "",
            )


def main(configs: Path, folder: Path) -> None:
    """Write all examples into a folder; other SVG files in it go."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in {file.stem for file in folder.glob("*.svg")} - {example.name for example in EXAMPLES}:
        (folder / f"{old}.svg").unlink()
    for example in EXAMPLES:
        (folder / f"{example.name}.svg").write_text(drawn(example, configs), "utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
