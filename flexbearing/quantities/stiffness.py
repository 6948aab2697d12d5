"""Entries of the stiffness matrix that rotor dynamics asks for."""

from flexbearing.quantities.quantity import SummaryValue, Unit
from flexbearing.quantities.reductions import entry_along_y, entry_along_z, entry_y_by_z, entry_z_by_y

_ENTRIES = {"zz": entry_along_z, "yy": entry_along_y, "yz": entry_y_by_z, "zy": entry_z_by_y}
RADIAL_STIFFNESSES = tuple(  # force by displacement
    SummaryValue(f"stiffness_{name}_N_per_m", entry, unit=Unit("N/m")) for name, entry in _ENTRIES.items()
)
