#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Frequencies of an unreduced sector against CalculiX's C3D20, C3D15 or C3D10 on the same mesh.

usage: calculix.py TIPRUB_MESH TIPRUB_REDUCE CASE PRESTRESS WORK_FOLDER [--split SPLIT_SECTOR KIND | --gmsh GEO] [KEY=VALUE...]

Meshes the case, with other values of these keys of [mesh] if there are any, cut into cells of another kind if there is one, or imported from what gmsh makes of a drawing, reduces it with this prestress (linear or nonlinear) at rest, half and full speed, exports the CalculiX
decks, runs them, and compares every verification frequency of every nodal diameter. Exit 77 (skipped) if there is no
CalculiX.
"""
import math
import os
import re
import shutil
import subprocess
import sys

import h5py

TOLERANCE = 1e-6  # relative; CalculiX prints seven digits
SKIPPED = 77


def calculix_frequencies(table):
    """{nodal diameter: [Hz, ascending, each once]} of a .dat file; CalculiX prints a travelling wave twice, as cosine and
    sine, and a mode of what has no cyclic symmetry once and without a nodal diameter."""
    rows = {}
    line = re.compile(r"^\s+(?:(\d+)\s+)?\d+\s+\S+E\S+\s+\S+E\S+\s+(\S+E\S+)\s+\S+E\S+\s*$")
    with open(table, encoding="ascii") as dat:
        for match in filter(None, map(line.match, dat)):
            rows.setdefault(match[1] and int(match[1]), []).append(float(match[2]))
    if None in rows:
        return {0: rows[None]}
    return {n: values[::2] for n, values in rows.items()}


def main(mesh, reduce, case, prestress, work, *mesh_keys):
    missing = [name for name in ("ccx", "gmsh") if (name == "ccx" or "--gmsh" in mesh_keys) and shutil.which(name) is None]
    if missing:
        print(f"SKIPPED: {' and '.join(missing)} not installed; ccx is in Debian's package calculix-ccx, gmsh in gmsh")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    sector, model, decks = (os.path.join(work, name) for name in ("sector.msh", "model.h5", "ccx"))
    keys = {"prestress": f'"{prestress}"', "verification_speeds": "[0.0, 0.5, 1.0]", "verification_modes": "10",
            "verification_tolerance": "1e-9"}
    settings = [word for key, value in keys.items() for word in ("--set", f"reduce.{key}={value}")]
    split = None
    if mesh_keys and mesh_keys[0] == "--gmsh":
        drawing, mesh_keys = mesh_keys[1], (*mesh_keys[2:], f"mesh_file='{os.path.join(work, 'gmsh.msh')}'")
        subprocess.run(["gmsh", drawing, "-3", "-v", "1", "-o", os.path.join(work, "gmsh.msh")], check=True)
    if mesh_keys and mesh_keys[0] == "--split":
        split, mesh_keys = mesh_keys[1:3], (*mesh_keys[3:], 'element="hex27"')
    subprocess.run([mesh, "-q", case, "-o", sector, *(word for key in mesh_keys for word in ("--set", f"mesh.{key}"))], check=True)
    if split:
        subprocess.run([split[0], sector, split[1], sector], check=True)
    subprocess.run([reduce, "-q", case, sector, "-o", model, *settings], check=True)
    subprocess.run([reduce, "-q", case, sector, "--export-ccx", decks, *settings], check=True)
    worst, compared = 0.0, 0
    with h5py.File(model) as file:
        diameters = file.attrs["sector_count"] // 2 + 1
        speeds = file["verification/speed"][:]
        for row, speed in enumerate(speeds):
            deck = f"speed_{round(speed * 30 / math.pi)}"
            subprocess.run(["ccx", deck], cwd=decks, env=dict(os.environ, OMP_NUM_THREADS="1"), check=True,
                           stdout=subprocess.DEVNULL)
            peer = calculix_frequencies(os.path.join(decks, deck + ".dat"))
            for n in range(diameters):
                ours = file[f"verification/nodal_diameter/{n}/unreduced"][row]
                assert len(peer[n]) >= len(ours), f"CalculiX gave {len(peer[n])} frequencies for nodal diameter {n}"
                for mine, theirs in zip(ours, peer[n]):
                    worst = max(worst, abs(mine / theirs - 1))
                    compared += 1
    print(f"{prestress}: {compared} frequencies, {diameters} nodal diameters: largest relative difference {worst:.2e}")
    assert compared > 0
    return 0 if worst <= TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
