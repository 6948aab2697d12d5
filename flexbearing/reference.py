"""The generated pages of the reference: `python -m flexbearing.reference case`, `results` or `study`."""

import sys

from flexbearing.families import FAMILIES


def page(name: str) -> str:
    """Return the page of case files, "case", of result files, "results", or of study files, in Markdown."""
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
