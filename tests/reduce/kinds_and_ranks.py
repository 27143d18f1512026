#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same sector as bricks of 20 or 27 nodes and as tetrahedra: with either factorization 1, 2 and 3 processes write the same
bytes, and both factorizations the same frequencies and contact compliances within 1e-10.

usage: kinds_and_ranks.py MPIRUN PROGRAMS_FOLDER CASE WORK_FOLDER
"""
import filecmp
import os
import shutil
import subprocess
import sys

import h5py
import numpy

TOLERANCE = 1e-10


def results(name):
    """Frequencies of the unreduced sector, and compliances of the contact dofs at rest, of all nodal diameters."""
    with h5py.File(name) as model:
        contact = 3 * len(model["contact/position"])
        diameters = [model[f"nodal_diameter/{n}"] for n in range(len(model["nodal_diameter"]))]
        compliances = [numpy.linalg.inv(diameter["K0"][:])[:contact, :contact] for diameter in diameters]
        frequencies = [model[f"verification/nodal_diameter/{n}/unreduced"][:] for n in range(len(diameters))]
    return frequencies, compliances


def difference(one, other):
    """The largest, relative to the largest number of each nodal diameter."""
    return max(numpy.abs(a - b).max() / numpy.abs(b).max() for a, b in zip(one, other))


def main(mpirun, programs, case, folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.chdir(folder)
    launcher = [mpirun, "--oversubscribe", *(["--allow-run-as-root"] if os.getuid() == 0 else [])]
    program = {name: os.path.join(programs, name) for name in ("tiprub-mesh", "tiprub-reduce", "split_sector")}
    subprocess.run([program["tiprub-mesh"], "-q", case, "-o", "hex27.msh", "--set", 'mesh.element="hex27"'], check=True)
    for kind in ("hex20", "tet10"):
        subprocess.run([program["split_sector"], "hex27.msh", kind, f"{kind}.msh"], check=True)
    for kind in ("hex20", "hex27", "tet10"):
        found = {}
        for factorization in ("cholmod", "mumps"):
            command = [program["tiprub-reduce"], "-q", case, f"{kind}.msh", "--set", f'reduce.factorization="{factorization}"',
                       "--set", "reduce.verification_tolerance=1e-12", "-o"]
            subprocess.run([*command, f"{factorization}.h5"], check=True)
            for processes in (2, 3):
                subprocess.run([*launcher, "-n", str(processes), *command, "some.h5"], check=True)
                assert filecmp.cmp(f"{factorization}.h5", "some.h5", shallow=False), (kind, factorization, processes)
            found[factorization] = results(f"{factorization}.h5")
        for what, one, other in zip(("frequencies", "compliances"), found["cholmod"], found["mumps"]):
            print(f"{kind}: {what} by CHOLMOD and MUMPS differ by {difference(one, other):.1g}", flush=True)
            assert difference(one, other) < TOLERANCE, (kind, what)


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
