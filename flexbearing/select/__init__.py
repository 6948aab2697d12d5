"""Bearings of a table that an application may have, by the formulas of a catalogue."""
