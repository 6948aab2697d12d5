"""Which rules a result names for its lives."""

import pytest

from flexbearing.api import read_case
from flexbearing.life import life_rules
from tests.places import CONFIGS

LUNDBERG, REFERENCE = "Lundberg and Palmgren (1952)", "ISO/TS 16281:2008, C_r of ISO 281:2007"
OF_SLICES = life_rules.A_ISO_OF_PARTS.format("slices")
OILED = "life.lubrication=a_ISO", "life.cleanliness=grease, normal cleanliness"


@pytest.mark.parametrize(
    ("name", "settings", "rules"),
    [
        ("nu209", (), [LUNDBERG]),
        ("nu209", ("life.capacity=iso281", *OILED), [LUNDBERG, REFERENCE, OF_SLICES]),
        ("nu209", ("life.capacity=iso281", "life.modification=bearing", *OILED),
         [LUNDBERG, REFERENCE, life_rules.A_ISO]),
        ("nu209", ("life.loads=rating", *OILED),
         [LUNDBERG, "(C_r/P)^(10/3) of ISO 281:2007, C_r of ISO 281:2007", life_rules.A_ISO]),
        ("nu209", ("life.loads=rating", "life.load_exponent=4", "life.reliability=0.99"),
         [LUNDBERG, "(C_r/P)^(4) of ISO 281:2007, C_r of ISO 281:2007", life_rules.A_1]),
        ("6209", (), [REFERENCE]),
        ("6209", ("life.dynamic_rating=35 kN", "life.loads=rating"),
         ["ISO/TS 16281:2008, a given rating", "(C_r/P)^3 of ISO 281:2007, a given rating"]),
        ("32207", ("life.loads=rating",), [REFERENCE, "(C_r/P)^(10/3) of ISO 281:2007, C_r of ISO 281:2007"]),
    ],
    ids=str,
)  # fmt: skip
def test_rules_are_those_of_the_keys(name, settings, rules):
    case = read_case(CONFIGS / f"{name}.toml", settings)
    law = life_rules.of_rollers if case.kind == "cylindrical_roller" else life_rules.of_elements
    assert law(case).split("; ") == rules
