"""Generated reference pages: `python -m flexbearing.reference docs/reference` writes them."""

from flexbearing.families import FAMILIES


def pages() -> dict[str, str]:
    """Return every generated page in Markdown, by its path below the folder of the reference."""
    from flexbearing.optimise.reference import reference_page as of_optimisations
    from flexbearing.reference.case_pages import case_pages
    from flexbearing.reference.result_pages import result_pages
    from flexbearing.studies.reference import reference_page as of_studies

    others = {"study.md": of_studies(), "optimise.md": of_optimisations()}
    return {**case_pages(FAMILIES), **result_pages(FAMILIES), **others}
