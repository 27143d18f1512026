#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The error of a mesh as tiprub-reduce estimates it, against the models of finer discretisations of the same sector.

usage: mesh_error.py TIPRUB_MESH TIPRUB_REDUCE CASE WORK_FOLDER [--sector FILE] [--finer KEY=VALUE]... [KEY=VALUE]...

A finer discretisation is `reduce.refine=1`, the default, or `reduce.element_order=3`. The case's own mesh is made unless a
file has it.

Prints the effectivity index, estimated over measured error, of the first modes of each nodal diameter and of the
compliances of the contact unknowns along their normals. It must be between 0.5 and 2. Modes are paired in the order that
they have without their estimated errors.
"""
import argparse
import os
import subprocess
import sys

import h5py
import numpy

MODES = 3                 # compared; more are estimated, because some of them change places
MORE = 3
RANGE = 0.5, 2.0


def reduced(arguments, sector, name, keys):
    model = os.path.join(arguments.folder, name + ".h5")
    settings = [word for key in keys for word in ("--set", key)]
    subprocess.run([arguments.reduce, arguments.case, sector, "-o", model, *settings], check=True)
    return h5py.File(model)


def compliances(model):
    """[m/N] along the normals, of nodal diameter 0."""
    group = model["nodal_diameter/0"]
    normals = numpy.array(model["contact/normal"])
    loads = numpy.zeros((len(group["K0"]), len(normals)))
    for k, normal in enumerate(normals):
        loads[3 * k:3 * k + 3, k] = normal
    return numpy.einsum("ik,ik->k", loads, numpy.linalg.solve(group["K0"], loads))


def frequency_errors(coarse, fine, n):
    """Estimated and measured."""
    name = f"verification/nodal_diameter/{n}/unreduced"
    found, exact = coarse[name][0], fine[name][0]
    estimated = coarse["mesh_error/frequency"][n]
    order = numpy.argsort(found / (1 + estimated))[:MODES]
    return estimated[order], found[order] / exact[:MODES] - 1


def tell(what, estimated, measured):
    index = estimated / measured
    print(f"{what}: errors of {100 * measured.min():.2g} to {100 * measured.max():.2g} %, "
          f"effectivity index {index.min():.2f} to {index.max():.2f}", flush=True)
    return RANGE[0] < index.min() and index.max() < RANGE[1]


def main():
    parser = argparse.ArgumentParser()
    for name in ("mesh", "reduce", "case", "folder"):
        parser.add_argument(name)
    parser.add_argument("--sector")
    parser.add_argument("--finer", action="append")
    arguments, given = parser.parse_known_args()
    if arguments.sector and not os.path.exists(arguments.sector):
        print(f"SKIPPED: there is no {arguments.sector}")
        return 77
    os.makedirs(arguments.folder, exist_ok=True)
    keys = ["reduce.verification_speeds=[0.0]", f"reduce.verification_modes={MODES + MORE}", *given]
    sector = arguments.sector or os.path.join(arguments.folder, "sector.msh")
    if not arguments.sector:
        settings = [word for key in keys for word in ("--set", key)]
        subprocess.run([arguments.mesh, arguments.case, "-o", sector, *settings], check=True)
    coarse = reduced(arguments, sector, "coarse", keys)
    good = []
    for finer in arguments.finer or ["reduce.refine=1"]:
        fine = reduced(arguments, sector, "fine", [*keys, finer, "reduce.mesh_error=false"])
        good += [tell(f"{finer}, nodal diameter {n}", *frequency_errors(coarse, fine, n))
                 for n in range(len(coarse["mesh_error/frequency"]))]
        good.append(tell(f"{finer}, compliances", coarse["mesh_error/compliance"][:],
                         1 - compliances(coarse) / compliances(fine)))
        fine.close()
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
