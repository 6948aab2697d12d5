"""All cases of evidence, by name."""

from evidence.case import Case
from evidence.cases import contacts, load_sharing, standards, worked

CASES: dict[str, Case] = {
    case.name: case
    for case in (
        *load_sharing.CASES,
        *contacts.CASES,
        *standards.CASES,
        *worked.STANDARDS,
        *worked.CATALOGUES,
    )
}
