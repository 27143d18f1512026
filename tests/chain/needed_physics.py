#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""physics = "as_needed" on a small disc. usage: needed_physics.py PROGRAMS_FOLDER CASES_FOLDER SMALL_CASE WORK_FOLDER (made by small_chain.py)"""
import json
import os
import re
import subprocess
import sys

import small_chain

import h5py
import numpy

SETTINGS = ("simulate.gap=", 'simulate.speeds="adaptive"', "simulate.step_tolerance=0.01", "simulate.max_revolutions=100",
            "simulate.budget_damping=[0.02]", 'simulate.budget="largest"', "simulate.settle_tolerance=1e-3",
            "simulate.speeds_rpm=[20500, 21000, 21500, 22000]")


def contents(path):
    """All datasets and attributes but those that tell where the file comes from."""
    found = {}

    def add(name, item):
        if isinstance(item, h5py.Dataset) and item.dtype != h5py.ref_dtype and name not in ("provenance", "casing/table"):
            found[name] = item[()].tobytes() if isinstance(item[()], numpy.ndarray) else item[()]
        found.update({f"{name}@{key}": str(value) for key, value in item.attrs.items() if "LIST" not in key and key != "REFERENCE_LIST"})

    with h5py.File(path) as file:
        file.visititems(add)
        return found


def shifts(path):
    """The changes of the critical speed by friction and by a gap of second order, in the budget of the largest peak."""
    with h5py.File(path) as file:
        for speed in file["speed"].values():
            if "budget" in speed:
                return {row.attrs["variation"].decode(): row.attrs["speed"] / speed.attrs["speed"] - 1 for row in speed["budget"].values()
                        if row.attrs["variation"] in (b"friction", b"gap")}
    raise AssertionError(f"{path} has no budget")


def needed_physics(bench):
    """What is switched on is what the budget of the sweep without it says, and the response is that of a case that gives these terms."""
    folder = bench.folder("needed")

    def run(output, *settings, program="simulate"):
        words = [word for setting in (*SETTINGS, *settings) for word in ("--set", setting)]
        told = subprocess.run([os.path.join(bench.programs, "tiprub-simulate"), "case.toml", "model.h5", "-o", output, *words],
                              cwd=folder.path, stderr=subprocess.PIPE, text=True, check=True)
        return told.stderr

    def physics(name):
        with h5py.File(folder.file(name)) as file:
            return file.attrs["scope"].decode()

    wanted = 'simulate.physics="as_needed"'
    said = run("needed.h5", wanted, "simulate.accuracy=0.001")
    change = shifts(folder.file("needed_plain.h5"))
    assert set(change) == {"friction", "gap"} and min(map(abs, change.values())) > 1e-3, change
    assert "physics as needed: the second order of the gap is on: at " in said and "friction of 0.1 is on: at " in said, said
    assert "more than accuracy = 0.001" in physics("needed.h5"), physics("needed.h5")
    run("given.h5", 'simulate.gap="second_order"', "casing.friction_coefficient=0.1", "simulate.accuracy=0.001")
    assert contents(folder.file("needed.h5")) == contents(folder.file("given.h5"))
    again = run("needed.h5", wanted, "simulate.accuracy=0.001")
    assert re.findall(r"(\d+) computed now", again) == ["0", "0"], again

    said = run("coarse.h5", wanted, "simulate.accuracy=0.5", "simulate.budget_friction=1e-6")
    assert "coarse.h5: " in said and physics("coarse.h5").count(" is off: at ") == 2, said
    assert contents(folder.file("coarse.h5")) == contents(folder.file("coarse_plain.h5"))
    assert not os.path.exists(folder.file("coarse_one_term.h5"))

    said = run("some.h5", wanted, "simulate.accuracy=0.5")
    assert os.path.exists(folder.file("some_one_term.h5")) and "friction of 0.1 is on: at " in physics("some.h5"), said
    assert physics("some.h5").count("the second order of the gap is o") == 1, said

    subprocess.run([os.path.join(bench.programs, "tiprub-postprocess"), "case.toml", "model.h5", "needed.h5", "-o", "needed", "-q"],
                   cwd=folder.path, check=True)
    decided = "physics as needed: friction of 0.1 is on: at "
    assert decided in folder.read("needed/report.html").decode()
    assert any(line.startswith(decided) for line in json.loads(folder.read("needed/summary.json"))["scope"])


if __name__ == "__main__":
    small_chain.STEPS += (needed_physics,)
    small_chain.main("needed_physics", *sys.argv[1:])
