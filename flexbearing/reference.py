"""The generated pages of the reference: `python -m flexbearing.reference case`, or `results`."""

import sys

from flexbearing.families import FAMILIES


def page(name: str) -> str:
    """Return the page of case files, "case", or of result files, "results", in Markdown."""
    if name == "case":
        from flexbearing.case.explain import reference_page
    else:
        from flexbearing.results.reference import reference_page
    return reference_page(FAMILIES)


if __name__ == "__main__":
    sys.stdout.write(page(sys.argv[1]))
