#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Spin stress of the blades and the first family's frequency over the mesh, with a fillet at the root and without.

usage: fillet.py PROGRAMS_FOLDER CASES_FOLDER [MESH ...]

The wheel of impeller_quick on meshes of contact.py, unreduced. The largest von Mises stress at a Gauss point of the main blade lies at its
root, at the trailing edge. Writes fillet.tsv, a line a radius and mesh.
"""
import os
import sys

import h5py

from contact import KEYS, MESHES
from convergence import Bench, sector_dofs, written

RADII = [0.0, 3e-3]  # [m]
NAMES = ["8", "12", "16", "24", "32"]
LAYERS_SHARE = 3  # one of so many layers of the blade is in the fillet
NODAL_DIAMETER = 4


def mesh_keys(name, radius):
    keys = dict(zip(KEYS, MESHES[name]))
    if radius:
        keys.update(fillet_radius=radius, elements_along_fillet=keys["elements_along_span"] // LAYERS_SHARE)
    return keys


def measure(bench, name, sector):
    """Stress [MPa] of main blade and splitter at full speed, frequency [Hz] at rest and at full speed."""
    modes = os.path.join(bench.folder, name + "_modes.h5")
    bench.run("tiprub-reduce", [sector, "--modes", modes], modes, "reduce",
              {"verification_modes": 1, "verification_speeds": [0.0, 1.0]})
    with h5py.File(modes) as file:
        stress = [1e-6 * file[f"static/von_mises/{part}"][-1] for part in ("main_blade", "splitter")]
        return [*stress, *file[f"nodal_diameter/{NODAL_DIAMETER}/frequency"][:, 0]]


def main(programs, cases, names):
    bench = Bench(os.path.abspath(programs), os.path.abspath(cases), "fillet_runs", "impeller_quick")
    with written("fillet.tsv") as file:
        file.write("\t".join(["fillet radius [mm]", "elements along the chord", "dofs a sector", "spin stress, main blade [MPa]",
                              "spin stress, splitter [MPa]", "first family at rest [Hz]", "at full speed [Hz]"]) + "\n")
        for radius in RADII:
            for name in names or NAMES:
                sector = bench.mesh(f"{name}_{1e3 * radius:g}mm", mesh_keys(name, radius))
                values = measure(bench, f"{name}_{1e3 * radius:g}mm", sector)
                file.write("\t".join([f"{1e3 * radius:g}", name, str(sector_dofs(sector)), *(f"{value:.6g}" for value in values)]) + "\n")
                file.flush()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
