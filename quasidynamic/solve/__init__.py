"""Residuals to zero."""
