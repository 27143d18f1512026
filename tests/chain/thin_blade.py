#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A thin, twisted blade that spin stiffens many times: the shapes of rest and full speed miss most of those between.

usage: thin_blade.py TIPRUB_MESH TIPRUB_REDUCE CASE WORK_FOLDER
"""
import os
import re
import subprocess
import sys

THICKNESS = 1e-4
SETTINGS = {"mesh.thickness_root": f"[[0,{THICKNESS}]]", "mesh.thickness_tip": f"[[0,{THICKNESS}]]", "mesh.stagger_tip_deg": 30,
            "mesh.elements_along_chord": 4, "mesh.elements_along_span": 4, "reduce.speed_max_rpm": 22000,
            "reduce.verification_speeds": "[0,0.3,0.6,0.95]", "reduce.verification_modes": 8,
            "reduce.fixed_interface_modes": 10, "reduce.modes_at_speed": 100}


def reduced(programs, case, folder, **more):
    words = [word for key, value in {**SETTINGS, **more}.items() for word in ("--set", f"{key}={value}")]
    sector, model = (os.path.join(folder, name) for name in ("sector.msh", "model.h5"))
    subprocess.run([programs[0], "-q", case, "-o", sector, *words], check=True)
    said = subprocess.run([programs[1], case, sector, "-o", model, *words], check=True, capture_output=True, text=True).stderr
    return float(re.search(r"frequencies within ([\d.e-]+) %", said)[1]), "warning: frequencies of the model are off" in said


def main(mesh, reduce, case, folder):
    os.makedirs(folder, exist_ok=True)
    error, is_told = reduced((mesh, reduce), case, folder)
    print(f"{error} %")
    assert error < 0.1 and not is_told, error
    error, is_told = reduced((mesh, reduce), case, folder, **{"reduce.modes_at_speed": 2})
    print(f"{error} % with 2 modes at speed")
    assert error > 1 and is_told, error


if __name__ == "__main__":
    main(*sys.argv[1:])
