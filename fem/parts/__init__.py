"""Rings, what holds them and how finely they are resolved, as frozen data; nothing is computed here."""
