"""The root attributes of a result file: texts and records that are no quantities."""

from dataclasses import dataclass
from typing import Literal

from flexbearing import findings
from flexbearing.findings import MET, NOT_CHECKED, NOT_MET
from flexbearing.findings.declared import is_declared
from flexbearing.findings.finding import AT_LEAST, AT_MOST
from flexbearing.quantities.effects import CHOICE, COMPARISON, INPUT, Effects, KeyEffects, OtherCase
from flexbearing.quantities.forms import (
    COUNT,
    NUMBER,
    TEXT,
    Anything,
    Each,
    Form,
    ListOf,
    OneOf,
    Record,
    Such,
    of_class,
)

FORMAT = 11
OLDER = {  # what the files of an older format are
    4: "its axes are older: of balls z axial and x along the load, tilts in stiffness_matrix of rollers as "
    'slopes; see "Axes and signs" in the documents',
    5: "it has no checksums and no digest",
    6: "its notes have no grades and no codes",
    7: "its axes have no names that other programs read",
    8: "its contacts in full sliding have no pressure, and axes of contacts have other names",
    9: "it has no pressure along rollers, no shear stress below contacts and no static safety",
    10: "it has no sliding power per area and no losses at ribs",
}
ENDS = ("converged", "iteration limit", "diverging", "stagnating", "not finite", "work limit", "not solved")
STATUSES = (*ENDS, "unfinished")  # of a run that is at work, or was interrupted


Kind = Literal["text", "texts", "integer", "number", "json", "records"]
OBJECT = Each("name", Anything())
GRADES = ("danger", "outside validity", "information")  # of notes, most serious first
NOTES = ListOf(
    Record({"grade": OneOf(GRADES), "code": TEXT, "text": TEXT}, optional={"keys": Each("key", TEXT)})
)


_OTHER_CASES = ListOf(of_class(OtherCase, settings=ListOf(TEXT), values=Each("output", NUMBER)))
_KEYS = ListOf(of_class(KeyEffects, others=_OTHER_CASES, role=OneOf((INPUT, CHOICE, COMPARISON))))
EFFECTS = of_class(Effects, of=Each("output", NUMBER), keys=_KEYS, together=_OTHER_CASES)

FINDINGS = ListOf(
    Such(
        of_class(
            findings.Record,
            grade=OneOf(findings.GRADES),
            side=OneOf((AT_MOST, AT_LEAST)),
            verdict=OneOf((MET, NOT_MET, NOT_CHECKED)),
        ),
        lambda record: is_declared(record["code"], record["grade"]),
        "with code and grade of a finding of this program",
    )
)


@dataclass(frozen=True)
class Attribute:
    """One root attribute of the file."""

    name: str
    kind: Kind
    meaning: str
    optional: bool = False  # absent where the case does not require it
    form: Form = OBJECT  # of a JSON attribute, or of a list of records
    longest: int = 200_000  # characters of its text, of all texts of a list together


COMMON = (
    Attribute("format", "integer", f"number of this layout, {FORMAT}"),
    Attribute("kind", "text", "family of the bearing, as in the case"),
    Attribute("title", "text", "title of the case"),
    Attribute("status", "text", f"how the run ended: {', '.join(STATUSES)}"),
    Attribute("ending", "text", "how the last solve of the bearing itself ended; empty while it still ran"),
    Attribute("message", "text", "how the run ended, in a sentence"),
    Attribute("iterations", "integer", "iterations of the coupling, 0 when no ring is flexible"),
    Attribute(
        "left_out",
        "text",
        "iterations, where a study stores end states alone (results = final); else absent",
        optional=True,
    ),
    Attribute("wall_time_s", "number", "time from case to result [s]"),
    Attribute("case_text", "text", "the case file, letter by letter", longest=100_000_000),
    Attribute("case_file", "text", "path of the case file; drawings are in its folder", optional=True),
    Attribute("case_overrides", "texts", "keys set on the command line, key=value"),
    Attribute(
        "case_si", "json", "the whole case with its defaults, in SI units", form=Each("key", Anything())
    ),
    Attribute("versions", "json", "versions of the program and of its libraries", form=Each("package", TEXT)),
    Attribute(
        "machine",
        "json",
        "where the run was computed: name of the host, kind of its processor, cores the run could use, "
        "operating system, and the revision of the program's source where it is run from a repository",
        optional=True,
        form=Record(
            {"host": TEXT, "processor": TEXT, "cores": COUNT}, optional={"system": TEXT, "revision": TEXT}
        ),
    ),
    Attribute("assumed", "texts", "keys whose values are assumed, not known"),
    Attribute(
        "assumed_effects",
        "json",
        "lives and weighed outputs of the last end state, in the units of the summary, and with other values "
        "of assumed or fitted keys, each with the settings that give it and the source of its range; "
        "role: input, choice of a rule, or comparison that no range counts; together: all changes at once "
        "that shorten the life, and all that lengthen it; absent without outputs.assumed_effects, unless "
        "CASE.effects.json next to the case has those of the same inputs",
        optional=True,
        form=EFFECTS,
    ),
    Attribute(
        "effects_left_out",
        "text",
        "that the effects next to the case were computed for other inputs; absent where they were not",
        optional=True,
    ),
    Attribute("calibrated", "json", "keys whose values were fitted, each to what", form=Each("key", TEXT)),
    Attribute(
        "notes",
        "records",
        "what a reader must know in addition to the numbers, the most serious first; keys of the case that a "
        "note is about, with values to consider",
        form=NOTES,
    ),
    Attribute(
        "findings",
        "records",
        "numbers of the last end state against their limits, in SI units: share is value over a limit from "
        "above, or limit over value; limit is null where the case gives none; absent without a solution",
        optional=True,
        form=FINDINGS,
    ),
    Attribute("created", "text", "time the run began, ISO 8601"),
)
HEAD = (  # root attributes that the summary of every family repeats
    "status",
    "iterations",
    "wall_time_s",
    "title",
    "ending",
    "message",
    "assumed",
    "calibrated",
    "assumed_effects",
    "notes",
    "findings",
)
