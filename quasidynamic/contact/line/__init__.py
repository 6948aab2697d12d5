"""The dry line contact of a roller: pressure, load law and slices; no film, no friction."""
