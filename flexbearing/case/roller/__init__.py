"""The case file of a cylindrical roller bearing, one module for each group of sections."""

from flexbearing.case.roller.roller_case import Case

__all__ = ["Case"]
