#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What other codes make, from file to report.

usage: foreign.py PROGRAMS_FOLDER TESTS_FOLDER SMALL_CASE WORK_FOLDER

A wheel of gmsh's in msh 2.2, CalculiX's deck, a model of another code's by h5py, and K and M in Matrix Market; cad_blade.py
has a STEP file.
"""
import os
import re
import shutil
import subprocess
import sys

WHEEL = '''[mesh]
mesh_file = "wheel.inp"
length_unit = "mm"
clamped = "clamped"
contact = "contact"
'''


class Chain:
    def __init__(self, programs, case, work):
        self.programs, self.work = programs, work
        with open(case, encoding="utf-8") as file:
            self.case = file.read()

    def run(self, program, *arguments):
        subprocess.run([os.path.join(self.programs, program), *arguments], cwd=self.work, check=True)

    def write_case(self, mesh):
        """The small case with another table [mesh]."""
        with open(os.path.join(self.work, "case.toml"), "w", encoding="utf-8") as file:
            file.write(re.sub(r"(?s)\[mesh\].*?(?=\n\[)", lambda _: mesh, self.case))

    def report(self, name, fields=("fields.h5",)):
        """From model.h5 on."""
        self.run("tiprub-simulate", "-q", "case.toml", "model.h5", "-o", "response.h5")
        with_fields = ["--fields", *fields] if fields else []
        self.run("tiprub-postprocess", "-q", "case.toml", "model.h5", "response.h5", *with_fields, "-o", name)
        page = os.path.join(self.work, name, "report.html")
        assert os.path.getsize(page) > 10000, page
        files = {file for _, _, names in os.walk(os.path.join(self.work, name)) for file in names}
        assert not fields or any("stress" in file for file in files), "no picture of stress"
        print(f"{name}: {os.path.getsize(page)} bytes of report.html beside {len(files)} files")

    def reduce(self, sector):
        self.run("tiprub-reduce", "-q", "case.toml", sector, "-o", "model.h5", "--fields", "fields.h5")


def main(programs, tests, case, work):
    sys.path[:0] = [os.path.join(tests, room) for room in ("mesh", "peers", "simulate")]
    import foreign_formats
    import matrices
    import small_wheel
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    chain = Chain(programs, case, work)
    chain.write_case(re.search(r"(?s)\[mesh\].*?(?=\n\[)", chain.case)[0])
    chain.run("tiprub-mesh", "-q", "case.toml", "-o", "whole.msh", "--set", 'mesh.element="hex27"')
    chain.run("split_sector", "whole.msh", "hex20", "hex20.msh")
    chain.run("convert_sector", "hex20.msh", "2.2", "text", "gmsh22.msh")
    chain.reduce("gmsh22.msh")
    chain.report("gmsh")
    foreign_formats.write(os.path.join(work, "hex20.msh"), "inp", "z", os.path.join(work, "wheel.inp"))
    chain.write_case(WHEEL)
    chain.run("tiprub-mesh", "-q", "case.toml", "-o", "sector.msh")
    chain.reduce("sector.msh")
    chain.report("calculix")
    small_wheel.write_model(os.path.join(work, "model.h5"))
    with open(os.path.join(work, "case.toml"), "w", encoding="utf-8") as file:
        file.write(small_wheel.CASE + "[postprocess]\n")
    chain.report("h5py", fields=())
    if shutil.which("ccx") is None:
        print("SKIPPED: K and M are made by CalculiX (ccx), which is not installed")
        return
    os.chdir(work)
    matrices.make_inputs(os.path.join(programs, "tiprub-mesh"), os.path.join(programs, "tiprub-reduce"), case)
    shutil.copy(case, "case.toml")
    chain.run("tiprub-reduce", "-q", "case.toml", "--matrices", "sti.mtx", "mas.mtx", "nodes.csv", "-o", "model.h5", *matrices.NO_MATERIAL)
    chain.report("matrices", fields=())


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
