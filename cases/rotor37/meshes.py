#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Frequencies over the mesh, and CalculiX's on the same mesh where it is installed.

usage: meshes.py PROGRAMS_FOLDER CASE WORK_FOLDER NODAL_DIAMETERS MESH...

A MESH is the counts of elements, "along_chord=8,along_span=6,through_blade=2". Meshes the case, takes its frequencies at rest, and
prints a table: dofs, the first six frequencies [Hz] of each of the nodal diameters ("0,2,18") and by how much each differs
from the mesh's before [%], and the largest relative difference of any frequency of any nodal diameter from CalculiX's, the latter
on the first mesh only if there are several sectors: it takes the longer the more there are.
"""
import os
import shutil
import subprocess
import sys

import h5py

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "peers"))
from calculix import calculix_frequencies  # noqa: E402

MODES = 6


def settings(table, keys):
    return [word for key, value in keys.items() for word in ("--set", f"{table}.{key}={value}")]


def frequencies(programs, case, folder, mesh):
    """{nodal diameter: [Hz]} and dofs of a sector."""
    os.makedirs(folder)
    sector, modes = os.path.join(folder, "sector.msh"), os.path.join(folder, "modes.h5")
    counts = {"elements_" + key: value for key, value in (pair.split("=") for pair in mesh.split(","))}
    at_rest = settings("reduce", {"verification_speeds": "[0.0]", "verification_modes": MODES, "verification_tolerance": 1e-9})
    reduce = [os.path.join(programs, "tiprub-reduce"), "-q", case, sector, *at_rest]
    subprocess.run([os.path.join(programs, "tiprub-mesh"), "-q", case, "-o", sector, *settings("mesh", counts)], check=True)
    subprocess.run([*reduce, "--modes", modes], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([*reduce, "--export-ccx", folder], check=True)
    with open(os.path.join(folder, "mesh.inp"), encoding="ascii") as deck:
        nodes = next(number for number, line in enumerate(deck) if line.startswith("*ELEMENT")) - 1
    with h5py.File(modes) as file:
        return {int(n): list(group["frequency"][0]) for n, group in file["nodal_diameter"].items()}, 3 * nodes


def difference_from_calculix(folder, ours):
    if shutil.which("ccx") is None:
        return "no ccx"
    subprocess.run(["ccx", "speed_0"], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    peer = calculix_frequencies(os.path.join(folder, "speed_0.dat"))
    return f"{max(abs(mine / theirs - 1) for n, row in ours.items() for mine, theirs in zip(row, peer[n])):.1e}"


def main(programs, case, work, diameters, *meshes):
    shutil.rmtree(work, ignore_errors=True)
    before = {}
    print("dofs\tnodal_diameter\t" + "\t".join(f"f{k + 1}_Hz" for k in range(MODES)) + "\tchange_percent\tCalculiX")
    for number, mesh in enumerate(meshes):
        folder = os.path.join(work, str(number))
        found, dofs = frequencies(os.path.abspath(programs), case, folder, mesh)
        peer = difference_from_calculix(folder, found) if len(found) == 1 or number == 0 else "-"
        for n in map(int, diameters.split(",")):
            changes = (f"{100 * (new / old - 1):+.2f}" for new, old in zip(found[n], before.get(n, [])))
            print(dofs, n, *(f"{value:.2f}" for value in found[n]), " ".join(changes) or "-", peer, sep="\t", flush=True)
        before = found


if __name__ == "__main__":
    main(*sys.argv[1:])
