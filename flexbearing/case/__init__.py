"""What is to be computed: a case file, read once into SI units.

The models of a case are here, one folder for each kind of rolling element; nothing is computed.
"""

from flexbearing.case.head import Head
from flexbearing.case.problems import BadCase
from flexbearing.case.read import read, understood

__all__ = ["BadCase", "Head", "read", "understood"]
