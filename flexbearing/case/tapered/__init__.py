"""A tapered roller bearing, as a case."""

from flexbearing.case.tapered.tapered_case import TaperedCase as TaperedCase
