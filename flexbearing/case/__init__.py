"""What is to be computed: a case file, read once into SI units."""

from flexbearing.case.explain import explain
from flexbearing.case.problems import BadCase
from flexbearing.case.read import read
from flexbearing.case.schema import Case

__all__ = ["BadCase", "Case", "explain", "read"]
