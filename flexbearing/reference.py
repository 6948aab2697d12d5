"""Generated reference pages: `python -m flexbearing.reference case`, `results`, `study` or `optimise`."""

import sys

from flexbearing.families import FAMILIES


def page(name: str) -> str:
    """Return the page of case files, "case", result files, "results", "study" or "optimise", in Markdown."""
    if name == "optimise":
        from flexbearing.optimise.reference import reference_page as of_optimisations

        return of_optimisations()
    if name == "study":
        from flexbearing.studies.reference import reference_page as of_studies

        return of_studies()
    if name == "case":
        from flexbearing.case.explain import reference_page as of_cases
        from flexbearing.example_drawings import pictures

        return of_cases(FAMILIES, {kind: list(pictures(kind)) for kind in FAMILIES})
    from flexbearing.results.reference import reference_page

    return reference_page(FAMILIES)


if __name__ == "__main__":
    sys.stdout.write(page(sys.argv[1]))
