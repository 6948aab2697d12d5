"""Derivatives of the outputs of a case by its keys."""
