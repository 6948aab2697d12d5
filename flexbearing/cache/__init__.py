"""Condensed rings kept on disk: meshing and factoring the same ring twice is a waste."""

from flexbearing.cache.store import Cache, Entry, complaints, configured, listing

__all__ = ["Cache", "Entry", "complaints", "configured", "listing"]
