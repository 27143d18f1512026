#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""K and M of a sector as CalculiX writes them, reduced: the model has the frequencies of the sector's mesh; and what is refused.

usage: matrices.py TIPRUB_MESH TIPRUB_REDUCE CASE WORK_FOLDER     (exit 77, skipped, if there is no CalculiX)

Once as CalculiX's .sti, .mas and .dof, once in Matrix Market, with the same K at two speeds besides.
"""
import csv
import os
import re
import shutil
import subprocess
import sys

import h5py
import numpy as np

SKIPPED = 77
NO_MATERIAL = [word for key in ("young_modulus", "poisson_ratio", "density") for word in ("--set", f"reduce.{key}=")]
AT_REST = ["--set", "reduce.verification_speeds=[0.0]", "--set", "reduce.verification_tolerance=1e-9"]


def sets_of(deck):
    """name -> nodes, of *NSET in a deck of ours."""
    return {name: [int(node) for node in re.findall(r"\d+", body)]
            for name, body in re.findall(r"\*NSET, NSET=(\w+)\n((?:\d+,\n)*)", deck)}


def write_nodes(path, nodes, places):
    with open(path, "w", encoding="ascii", newline="") as file:
        table = csv.writer(file)
        table.writerow(["node", "x", "y", "z", "set"])
        for number in sorted(nodes):
            table.writerow([number, *nodes[number], places.get(number, "")])


def write_market(path, source):
    entries = np.loadtxt(source)
    size = int(entries[:, :2].max())
    with open(path, "w", encoding="ascii") as file:
        file.write(f"%%MatrixMarket matrix coordinate real symmetric\n% by a test\n{size} {size} {len(entries)}\n")
        for row, column, value in entries:
            file.write(f"{int(max(row, column))} {int(min(row, column))} {value:.17g}\n")


def make_inputs(mesh, reduce, case):
    """sector.msh, mesh.h5 of it, ccx/free.sti, .mas, .dof, nodes.csv, and sti.mtx, mas.mtx."""
    subprocess.run([mesh, "-q", case, "-o", "sector.msh"], check=True)
    subprocess.run([reduce, "-q", case, "sector.msh", "-o", "mesh.h5", *AT_REST], check=True)
    subprocess.run([reduce, "-q", case, "sector.msh", "--export-ccx", "ccx", *AT_REST], check=True)
    with open("ccx/mesh.inp", encoding="ascii") as file:
        deck = file.read()
    # Without ties and supports.
    free = re.sub(r"(?s)\*NSET, NSET=(clamped|low).*?(?=\*MATERIAL)", "", deck).replace("*BOUNDARY\nclamped, 1, 3\n", "")
    with open("ccx/free.inp", "w", encoding="ascii") as file:
        file.write(free + "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n1\n*END STEP\n")
    subprocess.run(["ccx", "free"], cwd="ccx", check=True, stdout=subprocess.DEVNULL)
    nodes = {int(number): [value.strip() for value in place.split(",")]
             for number, place in re.findall(r"(?m)^(\d+), (\S+, \S+, \S+)$", deck.split("*ELEMENT")[0])}
    sets = sets_of(deck)
    places = {node: name for name, key in (("cyclic_low", "low"), ("cyclic_high", "high"), ("clamped", "clamped")) for node in sets[key]}
    with h5py.File("mesh.h5") as file:
        position = file["contact/position"][:]
    for r, theta, z in position:
        place = [r * np.cos(theta), r * np.sin(theta), z]
        places[min(nodes, key=lambda node, place=place: np.linalg.norm(np.array(nodes[node], float) - place))] = "contact"
    write_nodes("nodes.csv", nodes, places)
    for end in ("sti", "mas"):
        write_market(end + ".mtx", f"ccx/free.{end}")


def differs(reduce, case, form, files):
    """Whether the model of matrices has other frequencies than that of the mesh."""
    said = [subprocess.run([reduce, case, *inputs, *AT_REST], stderr=subprocess.PIPE, text=True, check=True).stderr
            for inputs in (("sector.msh", "-o", "mesh.h5"), (*files, "-o", "matrices.h5", *NO_MATERIAL))]
    units = [re.search(r"the lowest frequency is [\d.]+ Hz at rest \(nodal diameter \d\), and the mass of the sector is [\d.]+ kg", text)[0] for text in said]
    assert units[0] == units[1], units
    with h5py.File("mesh.h5") as one, h5py.File("matrices.h5") as other:
        assert one.attrs["sector_count"] == other.attrs["sector_count"]
        assert "second_order" in one["contact"] and "second_order" not in other["contact"]
        names = [f"verification/nodal_diameter/{n}/unreduced" for n in range(one.attrs["sector_count"] // 2 + 1)]
        worst = max(np.max(np.abs(other[name][:] / one[name][:] - 1)) for name in names)
        normals = np.max(np.abs(one["contact/normal"][:] - other["contact/normal"][:]))
    print(f"{form}: frequencies differ by up to {worst:.1e}, normals by {normals:.1e}")
    return not (worst < 1e-6 and normals < 1e-9)


def written(name, lines):
    with open(name, "w", encoding="ascii") as file:
        file.write("\n".join(lines) + "\n")
    return name


def refusals():
    """Arguments, and what must be said of them."""
    k, m, nodes = "sti.mtx", "mas.mtx", "nodes.csv"
    with open(nodes, encoding="ascii") as file:
        table = file.read().splitlines()
    with open(k, encoding="ascii") as file:
        lines = file.read().splitlines()
    exchanged = written("exchanged.csv", [line.replace("_low", "_x").replace("_high", "_low").replace("_x", "_high") for line in table])
    yield "cyclic_low and cyclic_high are exchanged", ["--matrices", k, m, exchanged]
    yield "which must be the same mass; does K stand before M", ["--matrices", m, k, nodes]
    yield "with forces at most nodes", ["--matrices", k, m, written("turned.csv", [table[0], *table[:0:-1]])]
    yield "where dofs are left out, say which by --matrix-dofs", ["--matrices", k, m, written("few.csv", table[:-2])]
    yield "must name the columns: x, y, z", ["--matrices", k, m, written("headless.csv", table[1:])]
    general = written("general.mtx", [lines[0].replace("symmetric", "general"), *lines[1:]])
    yield "is not symmetric", ["--matrices", general, m, nodes]
    other = written("complex.mtx", [lines[0].replace("real", "complex"), *lines[1:]])
    yield "must be a real matrix", ["--matrices", other, m, nodes]
    yield "must be a speed in rpm", ["--matrices", k, m, nodes, "--matrix-at", "fast", k]
    yield "by its mesh or by --matrices, not by both", ["sector.msh", "--matrices", k, m, nodes]
    yield "sector.msh is required; see tiprub-reduce --help", []


def refused(reduce, case, phrase, arguments):
    case_of_matrices = NO_MATERIAL if "--matrices" in arguments else []
    run = subprocess.run([reduce, case, *arguments, *case_of_matrices, "--check"], stderr=subprocess.PIPE, text=True, check=False)
    right = run.returncode == 2 and phrase in run.stderr
    if not right:
        print(f"expected: {phrase}\ncame: {run.returncode} {run.stderr}")
    return right


def main(mesh, reduce, case, work):
    if shutil.which("ccx") is None:
        print("SKIPPED: CalculiX (ccx) is not installed; it is Debian's package calculix-ccx")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    os.chdir(work)
    make_inputs(mesh, reduce, case)
    calculix = ["--matrices", "ccx/free.sti", "ccx/free.mas", "nodes.csv", "--matrix-dofs", "ccx/free.dof"]
    market = ["--matrices", "sti.mtx", "mas.mtx", "nodes.csv", "--matrix-at", "10000", "sti.mtx", "--matrix-at", "30000", "sti.mtx"]
    failed = differs(reduce, case, "CalculiX", calculix) + differs(reduce, case, "Matrix Market", market)
    return failed + sum(not refused(reduce, case, *each) for each in refusals())


if __name__ == "__main__":
    sys.exit(main(*map(os.path.abspath, sys.argv[1:])))
