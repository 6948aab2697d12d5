"""Curves of the static loads that a slewing bearing just bears."""
