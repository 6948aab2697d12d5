"""The section [outputs] of every kind of bearing, and of those with a rating life."""

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


class LifeOutputs(ContactOutputs):
    """What is computed beside the solution."""

    catalogue_life: bool = key(
        "whether the way from the life of a catalogue to that of the case is stored, as `flexbearing life` "
        "prints it: a further solution for each of its lines",
        False,
    )
