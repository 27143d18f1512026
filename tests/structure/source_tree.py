# SPDX-License-Identifier: GPL-3.0-or-later
"""The files of the project, and the one way in which a test of its structure ends."""
import os
import sys

ROOMS = ("cases", "mesh", "reduce", "simulate", "postprocess")
SOURCE_ENDS = (".h", ".cc", ".py", ".sh", ".cmake", ".gp", ".gnuplot", ".css", ".js", ".html")
# What runs of the cases make, beside the sources.
MADE = {"report", "runs", "expected"}


def is_source(name):
    return name.endswith(SOURCE_ENDS) or name == "CMakeLists.txt"


def files(root, rooms=ROOMS + ("tests",)):
    """Paths of the sources below the rooms, as an #include has them."""
    found = []
    for room in rooms:
        for folder, inner, names in os.walk(os.path.join(root, room)):
            made = MADE if room == "cases" else set()
            inner[:] = sorted(name for name in inner if name not in made and not name.startswith((".", "build", "__")))
            found += [os.path.relpath(os.path.join(folder, name), root) for name in sorted(names) if is_source(name)]
    return found


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as file:
        return file.read()


def report(faults, sound):
    """Prints the faults, one a line, and leaves with 1; without any, says what is sound."""
    for fault in faults:
        print(fault)
    if faults:
        sys.exit(1)
    print(sound)
