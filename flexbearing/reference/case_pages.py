"""Pages of the keys of a case file, from their declarations: usual keys first, the others folded."""

from collections.abc import Iterator
from dataclasses import dataclass
from fnmatch import fnmatchcase

from flexbearing.case.declarations import declarations, declared, of_every_case
from flexbearing.case.explain import table_of_keys
from flexbearing.case.family import Families
from flexbearing.case.materials import MATERIALS, origin
from flexbearing.example_drawings import pictures
from flexbearing.optimise.file import BOUND
from flexbearing.optimise.schema import DUTY_LIFE, OptimisationFile
from flexbearing.optimise.variables import BOUNDS
from flexbearing.reference.tables import Table, alike, folded, lines_of, rows, table
from flexbearing.studies.file.sampled import FORMS, MOST_DIMENSIONS, MOST_DRAWN
from flexbearing.studies.file.schema import StudyFile
from flexbearing.studies.file.slurm_profile import SlurmProfile
from flexbearing.studies.file.values import MOST, RANGE

ROLLERS = ("cylindrical_roller",)
TAPERED = ("tapered_roller", "thrust_roller", "spherical_roller")
BALLS = ("four_point_ball", "angular_contact_ball", "deep_groove_ball")


@dataclass(frozen=True)
class Page:
    """A page of keys."""

    name: str  # of its file, without ending
    title: str
    keys: tuple[str, ...]  # patterns of the tables on it
    kinds: tuple[str, ...] = (*ROLLERS, *TAPERED, *BALLS)


PAGES = (  # a table is on the first page that takes it
    Page("fits", "Fits and temperatures", ("bearing.fits*", "operation.temperatures*")),
    Page("roller-bearing", "Cylindrical roller bearing", ("bearing*",), ROLLERS),
    Page("tapered-bearing", "Tapered, thrust and spherical roller bearings", ("bearing*",), TAPERED),
    Page("ball-bearing", "Ball bearings", ("bearing*",), BALLS),
    Page("materials", "Materials", ("materials*",)),
    Page("lubricant", "Oil", ("lubricant*",)),
    Page("operation", "Loads, speeds and preload", ("operation*",)),
    Page("rings", "Elastic rings, shaft and housing", ("outer", "inner", "rings*")),
    Page("friction", "Friction of balls", ("friction", "rolling_lines", "fields")),
    Page("life", "Life", ("life",)),
    Page("numerics", "Accuracy, coupling, outputs, reports", ("accuracy", "coupling", "outputs*", "report")),
)


def case_pages(families: Families) -> dict[str, str]:
    """Return the pages by path, that with the list of them first."""
    tables = list(_tables(families))
    found = {page: [each for each in tables if _page(each) == page] for page in PAGES}
    texts = {f"case/{page.name}.md": _text(page, parts) for page, parts in found.items()}
    return {"case.md": _index(families, found), **texts}


def _tables(families: Families) -> Iterator[Table]:
    """Every table of every kind of case with its keys."""
    for kind, family in families.items():
        items = list(declared(family.case()))
        for item in items:
            if item.section:
                inside = [
                    key for key in items if key.path.rpartition(".")[0] == item.path and not key.section
                ]
                yield Table(item, kind, tuple(inside))


def _page(each: Table) -> Page:
    return next(
        page
        for page in PAGES
        if each.kind in page.kinds and any(fnmatchcase(each.path, keys) for keys in page.keys)
    )


def _text(page: Page, parts: list[Table]) -> str:
    lines = [f"# {page.title}", "", "[Keys of a case file](../case.md)", "", *pictures(page.name)]
    for group in alike(parts):
        lines += lines_of(group, page.kinds)
    return "\n".join(lines + (_materials() if page.name == "materials" else [])).rstrip() + "\n"


def _index(families: Families, found: dict[Page, list[Table]]) -> str:
    names = {
        page: dict.fromkeys(f"[{each.path}]" for each in parts if each.items) for page, parts in found.items()
    }
    return "\n".join(
        [
            "# Keys of a case file",
            "",
            'A case is a TOML file. Each value carries its unit: `diameter = "5 mm"`; any unit of the same '
            "kind is converted. `flexbearing explain KEY` says the same of one key, `flexbearing draw CASE` "
            "draws a case, with `--keys` without values. Azimuths, signs: [axes](axes.md).",
            "",
            *table(
                ("page", "sections"),
                [
                    (f"[{page.title}](case/{page.name}.md)", ", ".join(f"`{name}`" for name in tables))
                    for page, tables in names.items()
                ],
            ),
            "## Above all sections",
            "",
            *table(("key", "value", "default", "meaning"), rows(list(of_every_case(families)))),
            *folded("How values and units are written, sizes of files", _limits()),
            *folded("Sizes that a quantity may have, when it is not zero", _sizes(families)),
            "```{toctree}",
            ":hidden:",
            "",
            *(f"case/{page.name}" for page in PAGES),
            "```",
            "",
        ]
    )


def _materials() -> list[str]:
    """Materials that may be given by name, with their sources."""
    lines = ["## Materials by name", "", '`materials.roller = "100Cr6"` in place of its table.', ""]
    return [*lines, *(f'- `"{name}"`: {origin(name)}' for name in MATERIALS)]


def _limits() -> list[str]:
    """What holds for every value and every file."""
    from flexbearing import units
    from flexbearing.case import quantity, text
    from flexbearing.case.read import MOST_SETTINGS
    from flexbearing.inputs.file import sizes

    return [
        f"- A quantity has at most {quantity.LONGEST} characters. A unit is a product or quotient of units "
        f"with whole powers up to {units.HIGHEST}, at most {units.LONGEST} characters: `mm`, `N/mm^2` or "
        "`N/mm2`, `W/(m K)`, `1/K`, `Nm`, `ft-lb`. `1,5 mm` is 1.5 mm; `1,000 mm` is refused, as it may "
        "mean a thousand.",
        "- `3000 rpm`, `3000 1/min`, `3000 r/min` and `3000 min⁻¹` are the same speed. `1/s` and `Hz` are "
        "refused: they may mean turns or radians per second.",
        f"- Lists and tables are at most {text.DEEPEST} deep, integers have up to 64 bits; at most "
        f"{MOST_SETTINGS} settings come on top of a file.",
        "- Only plain files are read, up to a size: " + sizes() + ".",
        "",
    ]


def _sizes(families: Families) -> list[str]:
    """Between which sizes quantities must be, at any key."""
    kinds = {item.kind.name: item.kind for item in declarations(families) if item.kind}
    return table(("quantity", "size, of either sign"), [(name, kind.sizes) for name, kind in kinds.items()])


OF_STUDIES = ("|`over.", "|`duty.")  # rows that the page of study files has


def optimisation_page() -> str:
    """The page in Markdown."""
    return "\n".join(
        [
            "# Keys of an optimisation file",
            "",
            "[How to use them](../howto/optimise.md).",
            "",
            "In `[set]`, `[vary]`, `[over]`, `[duty]` and `[[verify]]` every other name is a dotted key of "
            "the case; `[over]` and `[duty]` are those [of a study](study.md).",
            "",
            f"- `[vary]`: {BOUNDS}.",
            f"- `[constrain]`: the name of an output, or {DUTY_LIFE}, and a bound such as {BOUND}.",
            "",
            *(line for line in table_of_keys(OptimisationFile) if not line.startswith(OF_STUDIES)),
            "",
        ]
    )


def study_page() -> str:
    """The page in Markdown."""
    drawn = dict.fromkeys(each.words for each in FORMS.values())
    return "\n".join(
        [
            "# Keys of a study file",
            "",
            "[How to use them](../howto/studies.md).",
            "",
            "In `[over]`, `[sample]` and `[duty]` every other name is a dotted key of the case.",
            "",
            f"- `[over]`: a list, a single value or a range; {RANGE}.",
            f'- `[sample]`: {"; ".join(drawn)}; "30 x normal ..." for a list; a single value is that of all.',
            f"- A study has at most {MOST} variants, and draws at most {MOST_DIMENSIONS} numbers for each, "
            f"{MOST_DRAWN} for all.",
            "",
            *table_of_keys(StudyFile),
            "",
            "# Keys of the profile of a SLURM cluster",
            "",
            *table_of_keys(SlurmProfile),
            "",
        ]
    )
