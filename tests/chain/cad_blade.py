#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of cases/cad_blade, as its text has them; then `make` in a copy of it, which must give the same.

usage: cad_blade.py PROGRAMS_FOLDER SOURCE_FOLDER WORK_FOLDER
"""
import filecmp
import os
import re
import shutil
import subprocess
import sys

import tutorial


def main(programs, source, work):
    if shutil.which("gmsh") is None:
        print("SKIPPED: the mesh is made by the program gmsh, which is not installed")
        sys.exit(77)
    shutil.rmtree(work, ignore_errors=True)
    case = os.path.join(source, "cases", "cad_blade")
    for folder in ("by_hand", "by_make"):
        os.makedirs(os.path.join(work, folder))
        for name in ("blade.geo", "case.toml", "Makefile"):
            shutil.copy(os.path.join(case, name), os.path.join(work, folder))
    by_hand, by_make = (os.path.join(work, folder) for folder in ("by_hand", "by_make"))
    told = tutorial.run(tutorial.commands(case), programs, source, by_hand)
    assert re.search(r"blade.msh: \d+ nodes, \d+ tet10\n.*\nno cuts: one body", told), told
    assert "of contact, by segments)" in told, told
    for goal in ("report/report.html", "-q report/report.html"):
        tutorial.run(f"make TIPRUB='{source}' {goal}\n", programs, source, by_make)
    assert filecmp.cmp(f"{by_hand}/report/critical_speeds.csv", f"{by_make}/report/critical_speeds.csv", shallow=False)
    with open(f"{by_make}/report/critical_speeds.txt", encoding="utf-8") as file:
        assert re.search(r"^ +163\d\d .*EO 4 ND 0", file.read(), re.M), "not the peak that the text tells of"
    assert os.path.exists(f"{by_make}/report/fields/contact_wheel.vtu"), "no stress"
    tutorial.run(f"make TIPRUB='{source}' clean\n", programs, source, by_make)
    assert sorted(os.listdir(by_make)) == ["Makefile", "blade.geo", "case.toml"], os.listdir(by_make)


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
