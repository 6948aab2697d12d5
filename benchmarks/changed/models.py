"""Models of REXS with other numbers, encodings, components and relations, through `new --from-rexs`."""

import re
from random import Random

from benchmarks.changed.bases import Bases
from benchmarks.changed.changes import damaged, in_file, word
from benchmarks.changed.files import Bundle, Change, ChangedFiles, Content, rendered
from benchmarks.changed.texts import ABSURD, DIGITS, FORMULA

ENTITIES = '<!DOCTYPE m [<!ENTITY a "1111111111">' + "".join(
    f'<!ENTITY {name} "{10 * f"&{before};"}">' for before, name in zip("abcdefgh", "bcdefghi", strict=True)
)
DETAILED = """<?xml version="1.0" encoding="UTF-8"?>
<model version="1.7" applicationId="x" applicationVersion="1" date="2026-01-01T00:00:00+01:00">
<relations>
<relation id="1" type="ordered_assembly" order="1">
<ref id="4" role="assembly"/><ref id="5" role="part"/></relation>
<relation id="2" type="ordered_assembly" order="1">
<ref id="5" role="assembly"/><ref id="6" role="part"/></relation>
<relation id="3" type="reference"><ref id="6" role="origin"/><ref id="7" role="referenced"/></relation>
<relation id="4" type="reference"><ref id="4" role="origin"/><ref id="8" role="referenced"/></relation>
</relations>
<components>
<component id="4" name="bearing" type="rolling_bearing_with_detailed_geometry">
<attribute id="bearing_type" unit="none">radial_roller_bearing</attribute>
<attribute id="inner_diameter" unit="mm">50</attribute>
<attribute id="outer_diameter" unit="mm">90</attribute>
<attribute id="width" unit="mm">20</attribute>
<attribute id="radial_dynamic_load_rating" unit="kN">73.5</attribute>
<attribute id="radial_static_load_rating" unit="kN">69.5</attribute>
<attribute id="fatigue_limit_load" unit="kN">8.8</attribute>
<attribute id="radial_clearance_class" unit="none">C0</attribute>
</component>
<component id="5" type="rolling_bearing_row">
<attribute id="number_of_rolling_elements" unit="none">17</attribute>
<attribute id="reference_diameter" unit="mm">70.5</attribute>
<attribute id="pressure_angle" unit="deg">0</attribute>
</component>
<component id="6" type="rolling_element">
<attribute id="diameter_of_rolling_element" unit="mm">11</attribute>
<attribute id="length_of_rolling_element" unit="mm">11</attribute>
</component>
<component id="7" name="100Cr6" type="material"/>
<component id="8" name="ISO VG 100" type="lubricant">
<attribute id="viscosity_at_40_degree_celsius" unit="mm^2 / s">100</attribute>
</component>
</components>
<load_spectrum id="1"><load_case id="1">
<component id="4" type="rolling_bearing_with_detailed_geometry">
<attribute id="force_acting_on_inner_component_v" unit="N">3000</attribute>
<attribute id="force_acting_on_inner_component_w" unit="N">4000</attribute>
<attribute id="speed_inner_ring" unit="1 / min">3000</attribute>
<attribute id="temperature_lubricant" unit="C">70</attribute>
</component></load_case></load_spectrum>
</model>
"""
CATALOGUE = """<?xml version="1.0" encoding="UTF-8"?>
<model version="1.4">
<relations><relation id="2" type="side"><ref id="3" role="assembly"/><ref id="2" role="inner_part"/>
<ref id="5" role="outer_part"/></relation></relations>
<components><component id="2" name="shaft" type="shaft"/>
<component id="3" name="bearing" type="rolling_bearing_with_catalog_geometry">
<attribute id="bearing_type" unit="">radial_grooved_ball_bearing</attribute>
<attribute id="inner_diameter" unit="mm">50</attribute><attribute id="outer_diameter" unit="mm">90</attribute>
<attribute id="width" unit="mm">20</attribute><attribute id="dynamic_load_rating" unit="kN">37</attribute>
<attribute id="static_load_rating" unit="kN">23</attribute></component>
<component id="5" name="casing" type="gear_casing"/></components>
<load_spectrum id="1"><load_case id="1"><component id="2" type="shaft">
<attribute id="rotational_speed" unit="1 / min">1450</attribute></component>
<component id="3" type="rolling_bearing_with_catalog_geometry"><attribute id="reaction_force" unit="N">
<array><c>0</c><c>4200</c><c>0</c></array></attribute></component></load_case></load_spectrum>
</model>
"""
NUMBERS = (
    "nan", "inf", "-inf", "NaN", "Infinity", "1e400", "-1e400", "1e308", "1e-320", "-0", "0", "-1", "0.5",
    "1e20", "１２", "٣", DIGITS, "0." + DIGITS, "1e" + DIGITS, "1_000", "0x10", "1,5", "", " ", "1 2",
    "1e5 mm", "true", FORMULA, "\x1b[31m", "\u202e5", "&#0;", "&#27;[31m", "&lt;script&gt;",
    "<array><c>1</c></array>", "<c>1</c>", "<!-- 1 -->5", "<![CDATA[5]]>", 20_000 * "a", "17.5", "9" * 30,
    "1e9", "&x;", "500",
)  # fmt: skip
TEXTS = ("", "x", "4", "5", "nan", "none", "mm", "m", DIGITS, "-1", "1.7", "2.0", "1." + DIGITS, "é",
"\u202e", "&#10;",
         "rolling_bearing_with_detailed_geometry", "angular_contact_ball_bearing",
         "radial_grooved_ball_bearing", "four_point_contact_ball_bearing", "20000" * 4000, "&lt;", "٣",
         "assembly", "part", "side")  # fmt: skip


def model(rng: Random, bases: Bases) -> ChangedFiles:
    """A case of a model of a gearbox program."""
    name, text = rng.choices((("detailed", DETAILED), ("catalogue", CATALOGUE)), weights=(4, 1))[0]
    options = rng.choice(((), ("--load", "5 kN", "--speed", "1000 rpm"), ("--rexs-bearing", "4")))
    files = {"m.rexs": text.encode()}
    bundle = Bundle(("new", "new.toml", "--from-rexs", "m.rexs", *options), files)
    changes = tuple(_change(rng) for _ in range(rng.choice((1, 1, 2, 3))))
    if options and rng.random() < 0.1:
        changes = (*changes, word(rng, 5, (*TEXTS, *ABSURD)))
    return ChangedFiles("REXS", f"{name} {' '.join(options)}", bundle, changes)


def _change(rng: Random) -> Change:
    ways = (_number, _attribute, _part, _encoded, _entities, _many, _deep)
    how = rng.choices((*ways, None), weights=(10, 5, 4, 2, 1, 2, 1, 2))[0]
    return how(rng) if how else damaged(rng, "m.rexs")


def _text_change(what: str, change) -> Change:
    def changed(content: Content) -> bytes:
        text = rendered(content).decode(errors="surrogateescape")
        return change(text).encode(errors="surrogateescape")

    return in_file(what, "m.rexs", changed)


def _replaced(rng: Random, pattern: str, texts: tuple[str, ...]) -> Change:
    """The text between two others, in a place that is chosen among all."""
    share, text = rng.random(), rng.choice(texts)

    def change(model: str) -> str:
        found = [*re.finditer(pattern, model)]
        if not found:
            return model
        one = found[int(share * len(found))]
        return model[: one.start(1)] + text + model[one.end(1) :]

    what = f"number {share:.4f} of {pattern} is {text[:40]!r}" + (f" ({len(text)})" if len(text) > 40 else "")
    return _text_change(what, change)


def _number(rng: Random) -> Change:
    return _replaced(rng, r">([^<>\n]+)</(?:attribute|c)>", NUMBERS)


def _attribute(rng: Random) -> Change:
    return _replaced(rng, r' (?:id|unit|type|role|order|version|name)="([^"]*)"', TEXTS)


def _part(rng: Random) -> Change:
    """An attribute, a relation or a component dropped or doubled."""
    pattern = rng.choice((
        r"(<attribute .*?</attribute>)", r"(?s)(<relation .*?</relation>)",
        r"(?s)(<component [^/]*?>.*?</component>)", r"(<ref [^>]*>)", r"(<component [^>]*/>)",
        r"(</component>)", r"(?s)(<relations>.*</relations>)", r"(?s)(<components>.*</components>)",
        r"(?s)(<load_spectrum.*</load_spectrum>)",
    ))  # fmt: skip
    share, times = rng.random(), rng.choice((0, 0, 2, 3, 3000))

    def change(model: str) -> str:
        found = [*re.finditer(pattern, model)]
        if not found:
            return model
        one = found[int(share * len(found))]
        return model[: one.start()] + times * one[0] + model[one.end() :]

    return _text_change(f"{times} times number {share:.4f} of {pattern}", change)


def _encoded(rng: Random) -> Change:
    codec = rng.choice(
        ("utf-16", "utf-32", "latin-1", "utf-7", "cp500", "utf-8-sig", "shift-jis", "x-none", "idna")
    )
    declared = rng.random() < 0.6

    def change(content: Content) -> bytes:
        text = rendered(content).decode(errors="replace")
        if declared:
            text = text.replace('encoding="UTF-8"', f'encoding="{codec}"')
        try:
            return text.encode(codec, errors="replace")
        except (LookupError, UnicodeError):
            return text.encode()

    made = in_file(f"in {codec}, {'declared' if declared else 'not declared'}", "m.rexs", change)
    return Change(made.what, made.apply, late=True)


def _entities(rng: Random) -> Change:
    """Entities in entities, or of another file."""
    head, use = rng.choice((
        (ENTITIES + "]>", "&i;"), (ENTITIES + "]>", "&c;"),
        ('<!DOCTYPE m [<!ENTITY x SYSTEM "file:///etc/hosts">]>', "&x;"), ('<!DOCTYPE m [<!ENTITY x "5">]>',
        "&x;"), ('<!DOCTYPE m [<!ENTITY x "&x;">]>', "&x;"),
        ('<!DOCTYPE m SYSTEM "http://localhost:9/x.dtd">', "5"),
    ))  # fmt: skip
    return _text_change(
        f"entities {head[:60]}",
        lambda model: model.replace("?>", f"?>{head}", 1).replace(">50<", f">{use}<", 1),
    )


def _many(rng: Random) -> Change:
    """Thousands of bearings, attributes or cases of load."""
    bearing = '<component id="{}" name="b" type="rolling_bearing_with_detailed_geometry"/>'
    what, end, each = rng.choice((
        ("bearings", "</components>", bearing), ("parts", "</components>",
        '<component id="x{}" type="shaft"/>'), ("attributes", "</component>",
        '<attribute id="a{}" unit="mm">1</attribute>'), ("cases", "</load_spectrum>", '<load_case id="{}"/>'),
        ("relations", "</relations>",
        '<relation id="{}" type="reference"><ref id="4" role="origin"/></relation>'),
    ))  # fmt: skip
    count = rng.choice((1, 2, 3000, 30_000))
    more = "".join(each.format(1000 + number) for number in range(count))
    return _text_change(f"{count} {what}", lambda model: model.replace(end, more + end, 1))


def _deep(rng: Random) -> Change:
    depth, place = rng.choice((500, 50_000)), rng.choice(("</components>", "</attribute>", "</model>"))
    return _text_change(
        f"{depth} elements in each other",
        lambda model: model.replace(place, depth * "<a>" + depth * "</a>" + place, 1),
    )
