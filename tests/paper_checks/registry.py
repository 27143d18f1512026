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
