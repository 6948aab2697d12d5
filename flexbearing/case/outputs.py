"""The section [outputs] of every bearing that has a rating life."""

from flexbearing.case.contact_outputs import ContactOutputs
from flexbearing.case.quantity import key


class LifeOutputs(ContactOutputs):
    """What is computed beside the solution."""

    catalogue_life: bool = key(
        "whether the way from the life of a catalogue to that of the case is stored, as `flexbearing life` "
        "prints it: a further solution for each of its lines",
        False,
    )
