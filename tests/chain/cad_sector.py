#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of cases/cad_sector, as its text has them; then `make` in a copy of it, which must make the same mesh.

usage: cad_sector.py PROGRAMS_FOLDER SOURCE_FOLDER WORK_FOLDER
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
    case = os.path.join(source, "cases", "cad_sector")
    by_hand, by_make = (os.path.join(work, folder) for folder in ("by_hand", "by_make"))
    for folder in (by_hand, by_make):
        os.makedirs(folder)
        for name in ("wheel.geo", "case.toml", "Makefile"):
            shutil.copy(os.path.join(case, name), folder)
    told = tutorial.run(tutorial.commands(case), programs, source, by_hand)
    assert re.search(r"wheel.msh: \d+ nodes, \d+ tet10\n.*\n\d+ faces on cyclic_low.*, one of 12 sectors\n", told), told
    with open(f"{by_hand}/report/critical_speeds.txt", encoding="utf-8") as file:
        assert re.search(r"^ +156\d\d .*EO 4 ND \+4", file.read(), re.M), "not the peak that the text tells of"
    with open(f"{by_hand}/mesh.svg", encoding="utf-8") as file:
        assert re.search(r"blade_tip: \d+ faces.*\n.*clamped: \d+ faces", file.read()), "no legend"
    tutorial.run(f"make TIPRUB='{source}' sector.msh\n", programs, source, by_make)
    assert filecmp.cmp(f"{by_hand}/sector.msh", f"{by_make}/sector.msh", shallow=False)
    tutorial.run(f"make TIPRUB='{source}' clean\n", programs, source, by_make)
    assert sorted(os.listdir(by_make)) == ["Makefile", "case.toml", "wheel.geo"], os.listdir(by_make)
    keeps_a_mesh_of_the_user(source, programs, by_make)


def keeps_a_mesh_of_the_user(source, programs, folder):
    """make neither overwrites nor removes wheel.msh that it has not made, and reads it where there is no wheel.geo."""
    mesh = os.path.join(folder, "wheel.msh")
    with open(mesh, "w", encoding="utf-8") as file:
        file.write("mine")
    os.utime(mesh, (1, 1))  # older than wheel.geo

    def said(*goals):
        return subprocess.run(["make", f"TIPRUB={source}", f"BIN={programs}", *goals], cwd=folder, capture_output=True, text=True, check=False).stderr

    for goals in (("sector.msh",), ("-n",)):
        assert "wheel.msh: make did not make it, and does not overwrite it; to use it, remove wheel.geo" in said(*goals)
    os.remove(os.path.join(folder, "wheel.geo"))
    assert "wheel.msh: is no mesh in gmsh's format" in said("sector.msh")
    said("clean")
    with open(mesh, encoding="utf-8") as file:
        assert file.read() == "mine"


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
