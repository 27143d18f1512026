# SPDX-License-Identifier: GPL-3.0-or-later
"""The 81 checks, in the paper's order. Each returns (holds, what was measured), or raises CannotBeMade or ByConstruction.

Thresholds are named where they are used. WHEEL marks checks whose outcome depends on the paper's confidential wheel: a
public one may fail them and still reproduce the paper.
"""

class CannotBeMade(Exception):
    """A check lacks what it looks at; the reason is the message."""


class ByConstruction(Exception):
    """Nothing that was computed could break what a check asks; the message says why. Not counted among those that hold."""


CHECKS = []  # number, text, what it depends on, function

# Of the paper: what each check looks at.
PLACES = {"figs. 2, 3, 7": (9,), "fig. 2": (4,), "fig. 3": (1, 2, 3, 5, 7), "sec. 4.1": (6,), "fig. 7": (8,), "eq. 2": (10, 11, 12),
          "eqs. 3, 4": (13, 14), "eqs. 5, 6": (15, 16, 17), "fig. 4": (18, 19), "fig. 5": (20,), "fig. 6": (21,), "eq. 7": (22, 23),
          "eqs. 8, 9": (24,), "eqs. 10 to 12": (25, 26, 32), "sec. 4.4": (27, 28, 29, 31), "fig. 9": (30,), "fig. 8": (33,),
          "eq. 13": (34, 40, 41), "eqs. 14, 15": (35, 36, 37, 38, 39), "eq. 16": (42,), "fig. 12": (43,), "fig. 13": (44, 45, 46, 54),
          "eq. 17": (47,), "table 1": (48,), "fig. 10": (49,), "fig. 11": (50, 51), "figs. 14, 15": (52,), "figs. 16, 17": (53,),
          "sec. 5.2.1": (55,), "fig. 18": (56,), "fig. 19": (57, 58, 59), "figs. 25, 26": (60,), "fig. 20": (61,), "fig. 23": (62,),
          "fig. 21": (63,), "fig. 22": (64, 65, 66, 67), "fig. 25": (68,), "fig. 26": (69, 70), "fig. 24a": (71, 75), "fig. 24b": (72, 73),
          "fig. 24": (74,), "fig. 27": (76, 77), "fig. 28": (78, 79), "sec. 7": (80,), "sec. 5.1.3": (81,)}
PLACE_OF = {number: place for place, numbers in PLACES.items() for number in numbers}
WHEEL = "wheel"


def check(number, text, depends=""):
    def register(function):
        CHECKS.append((number, text, depends, function))
        return function
    return register


def percent(share):
    return f"{100 * share:.3g} %"


def by_test(number, text, *filters):
    """A check that the project's own tests make."""
    check(number, text)(lambda c: c.tests.run(*filters))
