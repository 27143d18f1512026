#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sector as other codes write it, imported: it must have the frequencies of the sector itself.

usage: imports.py TIPRUB_MESH TIPRUB_REDUCE SPLIT_SECTOR CASE WORK_FOLDER

For each format and kind of cells: in millimetres, about another axis, the contact line's nodes in disorder, the cuts named, exchanged
or not named at all.
"""
import os
import re
import shutil
import subprocess
import sys

import h5py
import numpy as np

import foreign_formats

SETS = 'clamped = "clamped"\ncontact = "contact"\n'
# format, kind of cells, axis, keys of [mesh].
IMPORTS = [
    ("inp", "hex20", "z", SETS + 'cyclic_low = "cyclic_low"\ncyclic_high = "cyclic_high"'),
    ("inp", "tet10", "y", SETS),
    ("inp", "wedge15", "x", SETS + 'cyclic_low = "cyclic_high"\ncyclic_high = "cyclic_low"'),
    ("bdf", "mixed", "x", 'clamped = "SPC 1"\ncontact = "SET 7"\nsector_count = 6'),
    ("bdf", "wedge15", "z", 'clamped = "cylinder 0.03"\nblade_tip = "cylinder 0.1"\nmain_blade = "PID 3"'),
    ("cdb", "mixed", "y", SETS.replace('"clamped"', '"CLAMPED"').replace('"contact"', '"CONTACT"')),
    ("cdb", "wedge15", "z", 'clamped = "CLAMPED"\nblade_tip = "cylinder 0.1"'),
    ("cdb", "tet10", "x", 'clamped = "CLAMPED"\nblade_tip = "cylinder 0.1"'),
    ("unv", "hex20", "x", SETS),
    ("unv", "wedge15", "z", SETS),
    ("unv", "tet10", "z", SETS),
    ("msh", "mixed", "y", ""),
]


def results(reduce, case, sector):
    modes = os.path.splitext(sector)[0] + "_modes.h5"
    subprocess.run([reduce, "-q", case, sector, "--modes", modes, "--set", "reduce.contact_nodes=2"], check=True, stdout=subprocess.DEVNULL)
    with h5py.File(modes) as file:
        frequencies = [file[f"nodal_diameter/{n}/frequency"][:] for n in range(4)]
        return np.array(frequencies), file["tip/arc_length"][:]


# Keys of [mesh] and what is said where no cuts pair by them; of a sector of 6 about x.
WRONG = [('axis = "z"\nsector_count = 6', 'with axis = "x" and sector_count = 6, '), ('axis = "x"\nsector_count = 5', 'with axis = "x" and sector_count = 6, ')]


def refused(mesh, rest, keys, phrase, source, work):
    case = os.path.join(work, "wrong.toml")
    with open(case, "w", encoding="utf-8") as file:
        file.write(f'{rest}\n[mesh]\nlength_unit = "mm"\n{SETS}{keys}\n')
    run = subprocess.run([mesh, case, "--import", source, "--check"], stderr=subprocess.PIPE, text=True, check=False)
    right = run.returncode == 2 and phrase in run.stderr and run.stderr.count("\n") == 1
    if not right:
        print(f"expected: {phrase}\ncame: {run.returncode} {run.stderr}")
    return right


def main(mesh, reduce, split, case, work):
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    whole = os.path.join(work, "hex27.msh")
    subprocess.run([mesh, "-q", case, "-o", whole, "--set", 'mesh.element="hex27"'], check=True)
    with open(case, encoding="utf-8") as file:
        rest = re.sub(r"(?s)\[mesh\].*?(?=\n\[)", "", file.read())
    expected, failed = {}, 0
    for number, (form, kind, axis, keys) in enumerate(IMPORTS):
        source = os.path.join(work, kind + ".msh")
        if kind not in expected:
            subprocess.run([split, whole, kind, source], check=True)
            expected[kind] = results(reduce, case, source)
        stem = os.path.join(work, f"{number}_{form}_{kind}")
        foreign_formats.write(source, form, axis, f"{stem}.{form}")
        with open(stem + ".toml", "w", encoding="utf-8") as file:
            file.write(f'{rest}\n[mesh]\nlength_unit = "mm"\naxis = "{axis}"\n{keys}\n')
        subprocess.run([mesh, stem + ".toml", "--import", f"{stem}.{form}", "-o", stem + "_sector.msh"], check=True)
        frequencies, arc = results(reduce, stem + ".toml", stem + "_sector.msh")
        worst = np.max(np.abs(frequencies / expected[kind][0] - 1))
        same_line = 'contact = ' not in keys or np.allclose(arc, expected[kind][1], atol=1e-9)
        print(f"{form} of {kind}: frequencies differ by up to {worst:.1e}{'' if same_line else ', another contact line'}")
        failed += worst > 1e-7 or not same_line
    about_x = os.path.join(work, "8_unv_hex20.unv")
    return failed + sum(not refused(mesh, rest, *wrong, about_x, work) for wrong in WRONG)


if __name__ == "__main__":
    sys.exit(main(*map(os.path.abspath, sys.argv[1:])))
