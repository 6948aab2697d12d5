"""Pages of reports, parsed, and the numbers that a result file has at the places they name."""

import json
from html.parser import HTMLParser
from pathlib import Path

import h5py
import numpy as np
from pytest import approx

from flexbearing import api
from flexbearing.case import understood
from flexbearing.outputs import AbsentOutput
from flexbearing.units import unit

ALONE = ("meta", "br", "img", "input", "link")  # elements without an end


class Page(HTMLParser):
    """Cells with numbers, figures, and everything that is shown as text; what is folded apart."""

    def __init__(self, html):
        super().__init__()
        self.cells, self.shown_cells, self.text, self.shown, self.scripts, self.tags = [], [], [], [], {}, []
        self._cell, self._script, self._open = None, None, []
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.tags.append((tag, given))
        if given.get("class") == "number":
            self._cell = given
        if tag in ("script", "style"):
            self._script = given.get("id", "")
        if tag not in ALONE:
            self._open.append((tag, given))

    def handle_data(self, data):
        if self._script is not None:
            self.scripts[self._script] = self.scripts.get(self._script, "") + data
            return
        inside = [tag for tag, _ in self._open]
        folded = "details" in inside and "summary" not in inside
        if self._cell is not None:
            self.cells.append((self._cell, data))
            self.shown_cells += [] if folded else [(self._cell, data)]
        self.text.append(data)
        self.shown += [] if folded or "svg" in inside else [data]

    def handle_endtag(self, tag):
        if tag in ("td", "span"):
            self._cell = None
        if tag in ("script", "style"):
            self._script = None
        while self._open and tag not in ALONE and self._open.pop()[0] != tag:
            pass

    @property
    def figures(self):
        return json.loads(self.scripts["figures"])

    @property
    def words(self):
        """Words that are shown before anything is opened."""
        return [word for word in " ".join(self.shown).split() if any(map(str.isalnum, word))]


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
            "with_supports_error": self.with_supports_error,
            "torque_error": self.torque_error,
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

    def torque_error(self, rest):
        """Of the grid, and the power that no cause of heat explains."""
        block, path = rest.split("/", 1)
        power, left = (
            float(self.file[f"{block}/{name}"][()]) for name in ("driving_power", "loss_transport")
        )
        return 100 * (self.stored(f"attributes/{path}") + abs(left) / power)

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
        return (
            family.catalogue().rated(case).page(1e6 * 2 * np.pi / speed / 3600 if speed else np.inf).stored()
        )

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
