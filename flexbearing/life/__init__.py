"""Ratings and lives of bearings, and why they are not those of a catalogue."""
