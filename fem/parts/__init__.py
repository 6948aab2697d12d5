"""Rings, what holds them and how finely they are resolved, as frozen data.

An impossible part cannot exist; nothing is meshed or computed here. `fem` exports the usual parts.
"""
