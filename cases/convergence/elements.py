#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kinds of elements: how exact the located peaks are, over the cost.

usage: elements.py PROGRAMS_FOLDER CASES_FOLDER

The wheel of impeller_quick with contact by segments (peaks of contact at points have no limit to be compared with), on meshes of
contact.py: 20-node bricks that are all alike (their peaks are those of contact_impeller_quick.tsv), the same that are finer towards the
edges, and 27-node bricks. Writes elements.tsv, a line a mesh: its size, the processor time of meshing and reducing it, the static
compliances and peaks that contact.py tells of, and how far each is from that of the largest mesh of contact_impeller_quick.tsv.
"""
import csv
import os
import resource
import sys

import h5py

from contact import KEYS, MESHES, compliances, peaks
from convergence import Bench, sector_dofs, written

CASE, CONTACT = "impeller_quick", "segments"
KINDS = {
    "hex20": ({}, ["8", "12", "16", "24", "32"]),
    "hex20, graded": ({"grading_along_chord": 4.0}, ["8", "12", "16", "24", "32"]),
    "hex27": ({"element": '"hex27"'}, ["8", "12", "16"]),
}


def children_time():
    """[s] of processor time, of all that were started and waited for."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def known_values():
    """Their columns' names, and by elements along the chord what the even meshes have; the last is the largest."""
    with open(f"contact_{CASE}.tsv", encoding="utf-8") as file:
        header, *rows = csv.reader(file, delimiter="\t")
    return header[3:], {row[1]: [float(value) for value in row[3:]] for row in rows if row[0] == CONTACT}


def measure(bench, kind, mesh, known):
    """Dofs, processor time [s] and the values."""
    keys, name = KINDS[kind][0], f"{kind.replace(', ', '_')}_{mesh}"
    start = children_time()
    sector = bench.mesh(name, {**dict(zip(KEYS, MESHES[mesh])), **keys})
    model = bench.model(name, sector, {"contact": f'"{CONTACT}"', "verification_speeds": [0.0]})
    cost = children_time() - start
    if kind == "hex20":
        return sector_dofs(sector), cost, known[mesh]
    with h5py.File(model) as file:
        values = [1e9 * value for value in compliances(file)]
    return sector_dofs(sector), cost, [*values, *peaks(bench, name, model)]


def main(programs, cases):
    bench = Bench(os.path.abspath(programs), os.path.abspath(cases), "elements_runs", CASE)
    columns, known = known_values()
    reference = list(known.values())[-1]
    with written("elements.tsv") as file:
        file.write("\t".join(["elements", "along the chord", "dofs a sector", "mesh and reduce [s]", *columns,
                              *(f"difference of {name}" for name in columns)]) + "\n")
        for kind, (_, meshes) in KINDS.items():
            for mesh in meshes:
                dofs, cost, values = measure(bench, kind, mesh, known)
                differences = [value / exact - 1.0 for value, exact in zip(values, reference)]
                file.write("\t".join([kind, mesh, str(dofs), f"{cost:.1f}", *(f"{value:.6g}" for value in values),
                                      *(f"{value:.2e}" for value in differences)]) + "\n")
                file.flush()


if __name__ == "__main__":
    main(*sys.argv[1:3])
