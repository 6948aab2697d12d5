"""Resistance of the oil-air mixture to rollers that orbit and spin."""
