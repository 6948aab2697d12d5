"""Pages of reports, parsed, and the numbers that a result file has at the places they name."""

import json
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import h5py
import numpy as np
from pytest import approx

from flexbearing import api
from flexbearing.case import understood
from flexbearing.outputs import AbsentOutput
from flexbearing.report.html.reader import Reader
from flexbearing.runs import effects_file
from flexbearing.units import unit


class Page(HTMLParser):
    """Cells with numbers, figures, and everything that is shown as text."""

    def __init__(self, html):
        super().__init__()
        self.cells, self.text, self.scripts, self.tags = [], [], {}, []
        self._cell, self._script = None, None
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.tags.append((tag, given))
        if tag == "td" and given.get("class") == "number":
            self._cell = given
        if tag in ("script", "style"):
            self._script = given.get("id", "")

    def handle_data(self, data):
        if self._script is not None:
            self.scripts[self._script] = self.scripts.get(self._script, "") + data
        elif self._cell is not None:
            self.cells.append((self._cell, data))
        self.text.append("" if self._script is not None else data)

    def handle_endtag(self, tag):
        if tag == "td":
            self._cell = None
        if tag in ("script", "style"):
            self._script = None

    @property
    def figures(self):
        return json.loads(self.scripts["figures"])


def with_effects(reader):
    """A reader of the same result with the effects beside its case, computed with other rings."""
    case = Path(reader.result.attributes["case_file"])
    known = json.loads(effects_file.name(case).read_text())["effects"]
    attributes = {**reader.result.attributes, "assumed_effects": known}
    return Reader(replace(reader.result, attributes=attributes), reader.units)


class Numbers:
    """Numbers of a result file by their places, from HDF5 and from the summary."""

    def __init__(self, path, other=None):
        self.other = Numbers(other) if other else None
        self.result = api.read(path)
        self.summary = self.result.summary()
        self.file = h5py.File(path)

    def __call__(self, place):
        kind, _, rest = place.partition("/")
        if kind == "other":
            return self.other(rest)
        if kind == "outputs":
            try:
                return float(self.result[rest].number)
            except AbsentOutput:
                return None
        if kind == "change":
            before, after = (self(each) for each in rest.split(":"))
            return 100 * (after - before) / abs(before)
        if kind == "ratings":
            return followed(self.ratings, rest.split("/"))
        derived = {
            "ratio": self.ratio,
            "percent": self.percent,
            "support_error": self.support_error,
            "with_supports_error": self.with_supports_error,
            "combined": self.combined,
            "warmth": self.warmth,
            "ratings_at": self.ratings_at,
            "own_life_at": self.own_life_at,
            "part": self.part,
            "series": self.series,
            "torque_error": self.torque_error,
            "viscosity_ratio": self.viscosity_ratio,
            "oil": self.oil,
            "speed_factor": self.speed_factor,
            "times": self.times,
        }
        if kind in derived:
            return derived[kind](rest)
        if kind.startswith("life_error:"):
            return self.life_error(*place.removeprefix("life_error:").split(":"))
        return self.stored(place)

    def ratio(self, rest):
        """A number over another one."""
        value, base = (self(each) for each in rest.split(":"))
        return value / base

    def percent(self, rest):
        """An error of the summary over its value."""
        block, *names = rest.split("/")
        half = len(names) // 2
        error, value = (followed(self.summary[block], each) for each in (names[:half], names[half:]))
        return 100 * error / value

    def support_error(self, part):
        figures = self.stored("attributes/structure")[part]
        return 100 * figures["support_stiffness_error_N_per_m"] / figures["support_stiffness_N_per_m"]

    def with_supports_error(self, block):
        """By slices, and by the meshes of the supports by their share of the compliance."""
        whole = self.stored(f"summary/{block}/total_stiffness_N_per_m")
        error = 100 * self.stored("attributes/slice_error")["total_stiffness"]
        for part, figures in self.stored("attributes/structure").items():
            if figures.get("support_stiffness_error_N_per_m") is not None:
                error += self.support_error(part) * whole / figures["support_stiffness_N_per_m"]
        return error

    def warmth(self, path):
        """Temperature difference whose expansion over the pitch diameter is a clearance."""
        case = json.loads(self.file.attrs["case_si"])
        pitch = case["bearing"]["outer_raceway_diameter"] - case["bearing"]["roller"]["diameter"]
        expansion = case["materials"]["inner_ring"]["expansion"] * pitch
        return np.floor(self.stored(f"attributes/{path}") / expansion)

    def oil(self, rest):
        """What ISO 281 says of the oil at the load that has a life."""
        name, path = rest.split("/", 1)
        return self.result.family.catalogue().oil(self.case(), float(self(path)))[name]

    def speed_factor(self, block):
        """Revolutions a minute times the pitch diameter in millimetres."""
        bearing = json.loads(self.file.attrs["case_si"])["bearing"]
        pitch = bearing.get("pitch_diameter") or (
            bearing["outer_raceway_diameter"] - bearing["roller"]["diameter"]
        )
        return abs(in_unit(float(self.file[f"{block}/relative_speed"][()]), "rad/s", "rpm")) * 1e3 * pitch

    def times(self, rest):
        """One number times another."""
        one, other = rest.split("|")
        return self(one) * self(other)

    def combined(self, rest):
        """Least or most of a result by all inputs together over that of the case."""
        how, side, word = rest.split("/")
        sign = 1 if int(side) else -1
        solved = self.together(word, sign)
        if how == "worst" and solved is not None:
            return np.exp(sign * solved)
        ends = [max(values, key=lambda each: sign * each[0]) for values in self.changes(word).values()]
        sizes = np.array([(sign * whole, sign * factors) for whole, factors in ends if sign * whole > 0])
        sizes = sizes.reshape(-1, 2)
        total = np.sum if how == "worst" else np.linalg.norm
        by_factors = np.maximum(sizes[:, 1], 0.0)
        room = self.room(sign) if word == "life" else np.inf
        kept = min(1.0, room / total(by_factors)) if by_factors.any() else 1.0
        reached = total(np.maximum(sizes[:, 0] - (1 - kept) * by_factors, 0.0))
        return np.exp(sign * min(reached, np.inf if solved is None else solved))

    def room(self, sign):
        """How far the a_ISO of the result may shrink to 0.1, or grow to 50, as a logarithm."""
        states = json.loads(self.file.attrs.get("life", "{}")) or {}
        block = "flexible" if "flexible" in states else "rigid"
        for factor in states.get(block, {}).get("factors", ()):
            if factor["name"] in ("a_ISO", "film"):
                least, most = (0.1, 50.0) if factor["name"] == "a_ISO" else (0.19, 3.03)
                return np.log(most / factor["value"] if sign > 0 else factor["value"] / least)
        return np.inf

    def together(self, word, sign):
        """The life with all changes at once, as a logarithm in one direction; None where not solved."""
        found = self.result.attributes.get("assumed_effects") or {}
        cases = found.get("together", ())
        name = next((name for name in ("modified_life", "life_L10") if name in found.get("of", {})), "")
        if word != "life" or not cases or any(name not in each["values"] for each in cases):
            return None
        return max(0.0, *(sign * np.log(each["values"][name] / found["of"][name]) for each in cases))

    def changes(self, word):
        """Changes of a result by each key, and the part that the factors of a life have, as logarithms."""
        about, collected = self.result.attributes, {}
        if "assumed_effects" not in about:
            return collected
        found = about["assumed_effects"]
        names = {label: name for name, label in self.result.family.layout().weighed}
        lives = (name for name in ("modified_life", "life_L10") if name in found["of"])
        name = next(lives) if word == "life" else names[word]
        for key in (key for key in found["keys"] if key.get("role") != "comparison"):
            for values in (other["values"] for other in key["others"] if name in other["values"]):
                whole = np.log(values[name] / found["of"][name])
                basic = np.log(values["life_L10"] / found["of"]["life_L10"]) if "life_L10" in values else 0.0
                part = whole - basic if name == "modified_life" else 0.0
                collected.setdefault(key["key"].replace("drop", "profile"), []).append((whole, part))
        return collected

    def stored(self, place):
        """What the file or its summary has at a place."""
        kind, _, rest = place.partition("/")
        if kind == "summary":
            return followed(self.summary, rest.split("/"))
        if kind == "attributes":
            name, *steps = rest.split("/")
            return followed(json.loads(self.file.attrs[name]), steps)
        if kind == "case":
            return followed(json.loads(self.file.attrs["case_si"]), rest.split("."))
        return self.array(place)

    def ratings_at(self, rest):
        """A rating of the case with oil of another temperature."""
        kelvin, name = rest.split("/")
        life = json.loads(self.file.attrs["case_si"])["life"]
        oil = ("life.lubrication=a_ISO", "life.cleanliness=oil, in-line filter, -/13/10")
        settings = () if life.get("lubrication") == "a_ISO" else oil
        return self.rated(f"lubricant.inlet_temperature={float(kelvin) - 273.15:.8g} degC", *settings)[name]

    def own_life_at(self, kelvin):
        """Life of the case with the a_ISO of another temperature, at the load that has its reference life."""
        block = "flexible" if "flexible" in json.loads(self.file.attrs["life"]) else "rigid"
        life = json.loads(self.file.attrs["life"])[block]
        reference = float(self.file[f"{block}/reference_life"][()]) / 1e6
        load = self.ratings["ratings_N"]["C_r"] / reference ** (3 / 10)
        oil = f"lubricant.inlet_temperature={float(kelvin) - 273.15:.8g} degC"
        a_iso = self.rated(oil, f"operation.radial_load={load:.12g} N")["a_ISO"]
        (used,) = (factor["value"] for factor in life["factors"] if factor["name"] == "a_ISO")
        hours = self.ratings["life_h"] / self.ratings["life_Mrev"]
        return life["modified_Mrev"] * hours * a_iso / used

    def part(self, rest):
        """A number over another one that is no output."""
        of, path = rest.split("/", 1)
        return self(path) / float(of)

    def torque_error(self, rest):
        """Of the grid, and the power that no cause of heat explains."""
        block, path = rest.split("/", 1)
        power, left = (
            float(self.file[f"{block}/{name}"][()]) for name in ("driving_power", "loss_transport")
        )
        return 100 * (self.stored(f"attributes/{path}") + abs(left) / power)

    def series(self, rest):
        """The bearing along an axis (y, z), one after the other with the support of a ring."""
        block, row, part = rest.split("/")
        support = self.stored("attributes/structure")[part]["support_stiffness_N_per_m"]
        alone = self.file[f"{block}/radial_stiffness"][int(row), int(row)]
        return alone * support / (alone + support)

    def viscosity_ratio(self, _):
        """Viscosity ratio of a case whose life does not use it."""
        cleanliness = "life.cleanliness=oil, no or off-line filter, -/13/10"
        return self.rated("life.lubrication=a_ISO", cleanliness)["viscosity_ratio"]

    @property
    def ratings(self):
        """Ratings that follow from the case."""
        return self.rated()

    def case(self, *settings):
        family, about = self.result.family, self.result.attributes
        file, settings = Path(about["case_file"]), (*about["case_overrides"], *settings)
        return understood(about["case_text"], file, settings, {family.kind: family})

    def rated(self, *settings):
        family, case = self.result.family, self.case(*settings)
        speed = abs(float(self.file["rigid/relative_speed"][()]))
        return family.catalogue().ratings(case, 1e6 * 2 * np.pi / speed / 3600 if speed else np.inf)

    def life_error(self, place, block=""):
        """Error of the basic life; of a modified one grown by the factors that follow the life."""
        error = float(self(place) if place.startswith("attributes") else self.file[place][()])
        factors = json.loads(self.file.attrs["life"])[block]["factors"] if block else ()
        return error * (1 + sum(factor.get("life_exponent", 0) for factor in factors))

    def array(self, place):
        if place.startswith("other/"):
            return self.other.array(place.removeprefix("other/"))
        group, name, *index = place.split("/")
        return self.file[f"{group}/{name}"][
            tuple(slice(None) if step == "*" else int(step) for step in index)
        ]


def followed(value, steps):
    for step in steps:
        value = value[int(step) if isinstance(value, list) else step]
    return value


def require_equal(cells, numbers):
    """Every cell with a number is what stands at its place, to the printed digit."""
    for given, text in cells:
        value = numbers(given["data-of"])
        if text == "–":
            assert value is None or np.isnan(value) or ("film" in given["data-of"] and value == 0), given
        elif text != "∞":
            printed = float(text.replace(",", ""))
            exact = in_unit(value, given["data-stored"], given["data-unit"])
            assert printed == approx(exact, rel=1e-12, abs=1.0001 * half_a_digit(text)), given


def in_unit(value, stored, shown):
    here, there = unit(stored or "1"), unit(shown or "1")
    return (here.to_si(value) - float(there.offset)) / there.scale


def half_a_digit(text):
    """Half a unit of the last digit of a printed number."""
    mantissa, _, exponent = text.lstrip("+-").partition("e")
    decimals = len(mantissa.partition(".")[2])
    return 0.5 * 10.0 ** (int(exponent or 0) - decimals)
