"""The kinds of bearing that a case file can be about."""

from flexbearing.case.balls.angular_contact import AngularCase
from flexbearing.case.balls.four_point import FourPointCase
from flexbearing.case.head import Head
from flexbearing.case.roller.roller_case import Case

AnyCase = Case | FourPointCase | AngularCase

KINDS: dict[str, type[AnyCase]] = {
    "cylindrical_roller": Case,
    "four_point_ball": FourPointCase,
    "angular_contact_ball": AngularCase,
}
DEFAULT = str(Head.model_fields["kind"].default)  # for a file that does not say
