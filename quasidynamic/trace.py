"""Equilibria of one bearing over its load or speed: the branch around its folds, and all at one load."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import exp, log

import numpy as np
from numpy.typing import NDArray

from quasidynamic.balance.bearing import BORDER, CAGE, TILT_Z, BearingBalance, Y, Z
from quasidynamic.balance.points import OperatingPoints
from quasidynamic.equilibrium import Equilibrium
from quasidynamic.errors import NotSolved, OutOfRange
from quasidynamic.model import RollerBearing
from quasidynamic.parts.operation import Operation
from quasidynamic.solve import bordered
from quasidynamic.solve.arclength import End, Local, Step, at_parameter, follow
from quasidynamic.solve.endings import Ending
from quasidynamic.solve.newton import newton
from quasidynamic.solve.stability import growth_rates
from quasidynamic.start import LumpedRollers, slipping_at, static_unknowns

__all__ = ["Branch", "End", "Point", "equilibria_at", "trace"]

PARAMETERS = ("radial_load", "inner_speed")
DIFFERENCE = 1e-5  # of the logarithm of the parameter
SMALL = 1e-11  # residual that counts as zero, of the reference force or of the largest roller load
RING_SIZE = 10.0  # scaled ring displacement that counts like a slip of one: 10 micrometres
