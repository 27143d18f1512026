#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small scenes as the programs make them, to be damaged by tiprub_fuzz.   bases.py PROGRAMS_FOLDER CASE WORK_FOLDER

plain/: the case as it is. rich/: with what else the files may hold. splitters/: the quick impeller in few elements, with contact on both
blades. open/: plain/ without the digests of the model's and the fields' numbers and the seal of the response, which would refuse most damage at once; its
mesh in other formats of gmsh.
"""
import os
import shutil
import subprocess
import sys

import h5py

SCENES = ("plain", "rich", "open", "splitters")
MESH_FORMATS = {"msh22.msh": ("2.2", "text"), "msh40.msh": ("4.0", "text"), "binary.msh": ("4.1", "binary")}
STAGES = (["mesh"], ["reduce", "sector.msh", "--fields", "fields.h5"], ["simulate", "model.h5"])
RICH_TABLE = "\n[material]\nultimate_strength = 950e6\nendurance_limit = 400e6\n"
RICH_SETTINGS = ["mesh.element=\"hex27\"", "reduce.prestress=\"nonlinear\"", "reduce.polynomial_speeds=5",
                 "simulate.sweep=\"up\"", "simulate.speeds=\"adaptive\""]
IMPELLER = os.path.join(os.path.dirname(__file__), "..", "..", "cases", "impeller_quick", "case.toml")
FEW_ELEMENTS = {"along_chord": 3, "along_bore": 1, "along_span": 1, "through_blade": 2, "through_splitter": 2, "through_disc": 1, "between_blades": 2}
BOTH_BLADES = ["mesh.contact_blades=\"both\"", "mesh.fillet_radius=0", "reduce.contact=\"points\"", *(f"mesh.elements_{where}={count}" for where, count in FEW_ELEMENTS.items()),
               "reduce.fixed_interface_modes=6", "reduce.modes_at_speed=6", "reduce.verification_speeds=[0.0, 1.0]",
               "reduce.verification_modes=2", "simulate.speeds=\"given\"", "simulate.speed_count=2", "simulate.max_revolutions=20"]


def make_scene(programs, text, folder, settings):
    os.makedirs(folder)
    with open(os.path.join(folder, "case.toml"), "w", encoding="utf-8") as file:
        file.write(text)
    wanted = [word for setting in settings for word in ("--set", setting)]
    for stage, *arguments in STAGES:
        subprocess.run([os.path.join(programs, f"tiprub-{stage}"), "case.toml", *arguments, "-q", *wanted], cwd=folder, check=True)


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def make_bases(programs, case, work):
    shutil.rmtree(work, ignore_errors=True)
    text = text_of(case)
    plain, rich, opened, splitters = (os.path.join(work, scene) for scene in SCENES)
    make_scene(programs, text, plain, [])
    make_scene(programs, text + RICH_TABLE, rich, RICH_SETTINGS)
    make_scene(programs, text_of(IMPELLER).replace("contact_nodes = 14", "contact_nodes = 2"), splitters, BOTH_BLADES)
    shutil.copytree(plain, opened)
    sector = os.path.join(opened, "sector.msh")
    for name, form in MESH_FORMATS.items():
        subprocess.run([os.path.join(programs, "convert_sector"), sector, *form, os.path.join(opened, name)], check=True)
    for name in ("model.h5", "fields.h5"):
        with h5py.File(os.path.join(opened, name), "r+") as file:
            del file.attrs["digest"]
    with h5py.File(os.path.join(opened, "response.h5"), "r+"):
        pass  # closing it cuts off what follows HDF5's end


if __name__ == "__main__":
    make_bases(*map(os.path.abspath, sys.argv[1:]))
