"""All cases of evidence, by name."""

from evidence.case import Case
from evidence.cases import balls, contacts, elasticity, load_sharing, mao, motion, rolling, standards, worked

CASES: dict[str, Case] = {
    case.name: case
    for case in (
        *load_sharing.CASES,
        *contacts.CASES,
        *rolling.CASES,
        *balls.CASES,
        *motion.CASES,
        *mao.CASES,
        *elasticity.CASES,
        *standards.CASES,
        *worked.STANDARDS,
        *worked.CATALOGUES,
    )
}
