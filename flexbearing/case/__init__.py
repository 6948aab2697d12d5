"""What is to be computed: a case file, read once into SI units."""

from flexbearing.case.balls.angular_contact import AngularCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.explain import explain
from flexbearing.case.kinds import AnyCase
from flexbearing.case.problems import BadCase
from flexbearing.case.read import read, understood
from flexbearing.case.roller.roller_case import Case

__all__ = ["AngularCase", "AnyCase", "BadCase", "Case", "FourPointCase", "explain", "read", "understood"]
