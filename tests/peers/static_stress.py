#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The static shape under spin in fields.h5, and its stress, against CalculiX's C3D20 on the same mesh.

usage: static_stress.py TIPRUB_MESH TIPRUB_REDUCE CASE WORK_FOLDER

Compares displacements at all nodes, and stresses at the 27 integration points of every brick: there CalculiX prints what
its elements have. (At nodes it prints another extrapolation than ours.) Exit 77 (skipped) if there is no CalculiX.
"""
import os
import shutil
import subprocess
import sys

import h5py
import numpy

from calculix import SKIPPED

DISPLACEMENT_TOLERANCE = 5e-6  # of the largest; CalculiX prints six digits
STRESS_TOLERANCE = 1e-5        # of the largest
GAUSS = numpy.sqrt(0.6)
# VTK's nodes of a 20-node brick.
PLACES = numpy.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1], [-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1],
                      [0, -1, -1], [1, 0, -1], [0, 1, -1], [-1, 0, -1], [0, -1, 1], [1, 0, 1], [0, 1, 1], [-1, 0, 1],
                      [-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
DECK = """*INCLUDE, INPUT=mesh.inp
*STEP
*STATIC
*DLOAD
Eall, CENTRIF, {square:.12e}, 0, 0, 0, 0, 0, 1
*NODE PRINT, NSET=Nall
U
*EL PRINT, ELSET=Eall
S
*END STEP
"""


def shape_gradient(point):
    gradient = numpy.zeros((20, 3))
    for k, place in enumerate(PLACES):
        value = [1 - x * x if a == 0 else 1 + a * x for a, x in zip(place, point)]
        slope = [-2 * x if a == 0 else a for a, x in zip(place, point)]
        product = numpy.array([slope[0] * value[1] * value[2], value[0] * slope[1] * value[2],
                               value[0] * value[1] * slope[2]])
        gradient[k] = product / 4 if k >= 8 else (product * (place @ point - 2) + numpy.prod(value) * place) / 8
    return gradient


def stress_at(point, cells, nodes, moved, young, poisson):
    """xx, yy, zz, xy, xz, yz of every cell."""
    gradient = shape_gradient(point)
    jacobian = numpy.einsum("cki,kj->cij", nodes[cells], gradient)
    slope = numpy.einsum("cki,kj->cij", moved[cells], gradient) @ numpy.linalg.inv(jacobian)
    strain = (slope + slope.transpose(0, 2, 1)) / 2
    pressure = young * poisson / (1 + poisson) / (1 - 2 * poisson) * numpy.trace(strain, axis1=1, axis2=2)
    stress = young / (1 + poisson) * strain + pressure[:, None, None] * numpy.eye(3)
    return numpy.stack([stress[:, i, k] for i, k in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))], 1)


def main(mesh, reduce, case, work):
    if shutil.which("ccx") is None:
        print("SKIPPED: CalculiX (ccx) is not installed; it is Debian's package calculix-ccx")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    sector, model, fields, decks = (os.path.join(work, name) for name in ("sector.msh", "model.h5", "fields.h5", "ccx"))
    speeds = ["--set", "reduce.verification_speeds=[0.0, 1.0]"]
    subprocess.run([mesh, "-q", case, "-o", sector], check=True)
    subprocess.run([reduce, "-q", case, sector, "-o", model, "--fields", fields, *speeds], check=True)
    subprocess.run([reduce, "-q", case, sector, "--export-ccx", decks, *speeds], check=True)
    with h5py.File(model) as file:
        speed = file.attrs["speed_max"]
    with open(os.path.join(decks, "static.inp"), "w", encoding="ascii") as file:
        file.write(DECK.format(square=speed * speed))
    subprocess.run(["ccx", "static"], cwd=decks, env=dict(os.environ, OMP_NUM_THREADS="1"), check=True,
                   stdout=subprocess.DEVNULL)
    with open(os.path.join(decks, "static.dat"), encoding="ascii") as dat:
        rows = [line.split() for line in dat if line.split() and line.split()[0].isdigit()]
    peer_moved = numpy.array([row[1:] for row in rows if len(row) == 4], float)
    peer_stress = numpy.array([row[2:] for row in rows if len(row) == 8], float)
    with h5py.File(fields) as file:
        nodes, cells = file["nodes"][:], file["cells"][:]
        young, poisson = file.attrs["young_modulus"], file.attrs["poisson_ratio"]
        r, theta, z = (speed ** 2 * file["static/displacement_1"][:]).T
    angle = numpy.arctan2(nodes[:, 1], nodes[:, 0])
    moved = numpy.stack([r * numpy.cos(angle) - theta * numpy.sin(angle),
                         r * numpy.sin(angle) + theta * numpy.cos(angle), z], 1)
    points = [numpy.array([a, b, c]) for c in (-GAUSS, 0, GAUSS) for b in (-GAUSS, 0, GAUSS) for a in (-GAUSS, 0, GAUSS)]
    stress = numpy.stack([stress_at(point, cells, nodes, moved, young, poisson) for point in points], 1)
    assert peer_moved.shape == moved.shape and peer_stress.size == stress.size
    displacement_error = abs(peer_moved - moved).max() / abs(moved).max()
    stress_error = abs(peer_stress.reshape(stress.shape) - stress).max() / abs(stress).max()
    print(f"{len(nodes)} nodes: displacement within {displacement_error:.1e}; {peer_stress.shape[0]} integration points: "
          f"stress within {stress_error:.1e}, up to {abs(stress).max() / 1e6:.0f} MPa")
    return 0 if displacement_error < DISPLACEMENT_TOLERANCE and stress_error < STRESS_TOLERANCE else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
