"""What the section [outputs] of every kind of bearing has."""

from flexbearing.case.quantity import Section, key


class ContactOutputs(Section):
    """What is computed beside the solution."""

    subsurface_stresses: bool = key(
        "whether the von Mises and the orthogonal shear stress below the most pressed contact of each "
        "raceway are stored, as a field in the plane of rolling with the largest value and its depth",
        False,
    )
    assumed_effects: bool = key(
        "whether lives and main outputs are stored with other values of every assumed or fitted key, at the "
        "ends of the tolerance classes, and with other rules of the life and the other tilt: some two "
        "further solutions for each key",
        False,
    )
