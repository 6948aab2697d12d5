"""Rows of balls of a case on common rings."""

from dataclasses import replace
from math import sin

import quasidynamic as qd
from flexbearing.case.balls.angular_contact import FastCase
from quasidynamic.parts.angular_contact_bearing import RowPlace

ONE_ROW = (RowPlace(),)


def rows(case: FastCase, unmounted: qd.AngularContactBearing) -> tuple[RowPlace, ...]:
    """Rows of a case, of which one is given before mounting: the grooves of a pair are ground for that."""
    pair = case.bearing.second_row
    if pair is None:
        return ONE_ROW
    closer = pair.offset or 0.0
    if pair.preload is not None:
        closer = qd.preloaded_place(unmounted, pair.preload)
    beside = unmounted.inner_reach * sin(unmounted.contact_angle)  # inner groove centres from their balls
    first = RowPlace(axial=beside - pair.distance / 2, closer=closer)
    if pair.arrangement == "back_to_back":
        return first, replace(first, axial=-first.axial, mirrored=True)
    second = replace(first, axial=beside + pair.distance / 2)
    if pair.arrangement == "tandem":
        return first, second
    return replace(second, axial=-second.axial, mirrored=True), second


def rating_factor(case: FastCase) -> float:
    """Dynamic rating of all rows over that of one, i^0.7 of ISO 281 [-]."""
    return 1.0 if case.bearing.second_row is None else 2**0.7
