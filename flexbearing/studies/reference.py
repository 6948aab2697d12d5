"""Reference page of study files and of profiles of clusters, from their declarations."""

from flexbearing.case.explain import table_of_keys
from flexbearing.studies.file.sampled import FORMS, MOST_DIMENSIONS, MOST_DRAWN
from flexbearing.studies.file.schema import StudyFile
from flexbearing.studies.file.slurm_profile import SlurmProfile
from flexbearing.studies.file.values import MOST, RANGE


def reference_page() -> str:
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
