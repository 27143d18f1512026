# SPDX-License-Identifier: GPL-3.0-or-later
"""Between the units of the files and those in which people speak."""
import numpy as np


def _with_unit(value, unit):
    if hasattr(value, "attrs"):
        value.attrs["units"] = unit
    return value


def rpm(speed):
    """[rpm] of a speed of rotation [rad/s]: a number, an array, or an xarray.DataArray, whose unit changes too.

    >>> round(rpm(100 * np.pi), 9)
    3000.0
    """
    return _with_unit(speed * (30 / np.pi), "rpm")


def rad_per_s(speed):
    """[rad/s] of a speed of rotation [rpm].

    >>> round(rad_per_s(3000.0) / np.pi, 9)
    100.0
    """
    return _with_unit(speed * (np.pi / 30), "rad/s")


def mm(length):
    """[mm] of a length [m].

    >>> mm(0.00025)
    0.25
    """
    return _with_unit(length * 1e3, "mm")
