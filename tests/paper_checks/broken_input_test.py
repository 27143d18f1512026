#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The checks can fail: on broken inputs, and by the exit code: 0 if all hold, 1 if one doesn't, 2 if one can't be made.

usage: broken_input_test.py
"""
import contextlib
import io
import os
import sys
import tempfile
from types import SimpleNamespace

import numpy

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import paper_checks
from registry import WHEEL, ByConstruction, CannotBeMade
from contact_checks import on_the_zig_zag
from scene import Case

FUNCTIONS = {number: function for number, _, _, function in paper_checks.CHECKS}


class NoContext:
    def __init__(self, *_):
        pass


def holds(_):
    return True, "measured"


def does_not(_):
    return False, "measured"


def lacks_a_file(_):
    raise CannotBeMade("no response.h5")


def constructed(_):
    raise ByConstruction("nothing could break it")


def run(*checks):
    """Exit code and text of these checks; a pair is (what it depends on, function)."""
    paper_checks.CHECKS[:] = [(i, "made", *check) if isinstance(check, tuple) else (i, "made", "", check)
                              for i, check in enumerate(checks)]
    paper_checks.Context = NoContext
    with contextlib.redirect_stdout(io.StringIO()) as out:
        code = paper_checks.main("build", "cases", "case")
    return code, out.getvalue()


def expect(outcome, code, phrase):
    assert outcome[0] == code and phrase in outcome[1], outcome


expect((paper_checks.main("build", "cases", "/no/such/case"), ""), 2, "")  # a missing file
expect(run(holds), 0, "1 holds; 0 does not hold on this wheel; 0 by construction; 0 can't be made")
expect(run(holds, does_not), 1, "these don't hold: [1]")
expect(run(holds, (WHEEL, does_not)), 0, "1  does not hold on this wheel [D]")
expect(run(holds, constructed), 0, "1 holds; 0 does not hold on this wheel; 1 by construction")
expect(run(holds, lacks_a_file), 2, "1  can't be made: made: no response.h5")
expect(run(lacks_a_file, does_not), 1, "these don't hold: [1]")


def pushing(least_force):
    speed = SimpleNamespace(smallest_force=least_force)
    return SimpleNamespace(cases=[SimpleNamespace(speeds=[speed], attribute=lambda _: numpy.array([0.0]))])


def touching(leading, trailing):
    """One speed whose two nodes count these steps in contact."""
    speed = SimpleNamespace(count=numpy.array([[[leading], [trailing]]]))
    case = SimpleNamespace(name="made", speeds=[speed])
    return SimpleNamespace(cases=[case], lobed=lambda _: case)


def moving(diameter_of_order):
    """A case of ten sectors whose one periodic speed moves each engine order on one nodal diameter."""
    case = Case.__new__(Case)
    case.name, case.sectors, case.steady = "made", 10, numpy.array([True])
    case.waves = numpy.zeros((1, 13, 10))
    for order, n in diameter_of_order.items():
        case.waves[0, order, n] = 1.0
    return case


def verdict(number, context):
    return bool(FUNCTIONS[number](context)[0])


assert verdict(36, pushing(0.0)) and not verdict(36, pushing(-1.0))  # a casing that pulls
assert verdict(74, touching(0, 5)) and not verdict(74, touching(3, 0))
assert on_the_zig_zag(moving({6: 6, 8: 2}), (6, 8))[0]
assert not on_the_zig_zag(moving({6: 3, 8: 2}), (6, 8))[0]  # EO 6 where EO 3 belongs

with tempfile.TemporaryDirectory() as folder:  # symptom: a case whose file lies in another folder could not be checked
    os.mkdir(os.path.join(folder, "report"))
    with open(os.path.join(folder, "report", "case.toml"), "w", encoding="utf-8") as file:
        file.write('[mesh]\nblades = 10\n# --set casing.lobes=3\n# --set simulate.gap="linear"\n')
    elsewhere = Case.__new__(Case)
    elsewhere.folder = folder
    assert elsewhere.arguments[1:] == ["--set", "casing.lobes=3", "--set", 'simulate.gap="linear"'], elsewhere.arguments
print("broken inputs do not hold, and the exit codes say so")
