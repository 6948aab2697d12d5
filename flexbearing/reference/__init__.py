"""Generated reference pages: `python -m flexbearing.reference docs/reference` writes them."""

from flexbearing.families import FAMILIES


def pages() -> dict[str, str]:
    """Return every generated page in Markdown, by its path below the folder of the reference."""
    from flexbearing.reference.case_pages import (
        case_pages,
        optimisation_page as of_optimisations,
        study_page as of_studies,
    )
    from flexbearing.reference.result_pages import result_pages

    others = {"study.md": of_studies(), "optimise.md": of_optimisations()}
    return {**case_pages(FAMILIES), **result_pages(FAMILIES), **others}
