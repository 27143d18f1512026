#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The second order of the gaps in model.h5 against CalculiX's large displacements on the same mesh of 20-node bricks.

usage: second_order.py TIPRUB_MESH TIPRUB_REDUCE CASE WORK_FOLDER

With the cut faces held, the inertia loads of a mode bend the blade to both sides (NLGEOM). What both sides have in common
is of even order. It is compared, along the normals of the contact nodes, with y'Qy of the model; the motion of the modes
that are the model's coordinates, which CalculiX answers statically, is taken out of it. Prints a table for the modes of the
first two coordinates. Exit 77 (skipped) if there is no CalculiX.
"""
import os
import shutil
import subprocess
import sys

import h5py
import numpy

from calculix import SKIPPED
from static_stress import GAUSS, PLACES, shape_gradient

AMPLITUDES = numpy.array([1e-3, 2e-3, 3.5e-3])  # m, of the contact node that moves most
COMPARED = 1              # of these: where the fourth order is still small
TOLERANCE = 0.05          # of the displacement of a node
LEAST = 2e-3              # of the largest displacement: CalculiX prints six digits of the whole motion
MODES = 16
WEIGHTS = {-GAUSS: 5 / 9, 0: 8 / 9, GAUSS: 5 / 9}


def shape_value(point):
    product = numpy.prod([[1 - x * x if a == 0 else 1 + a * x for a, x in zip(place, point)] for place in PLACES], 1)
    return numpy.concatenate([product[:8] * (PLACES[:8] @ point - 2) / 8, product[8:] / 4])


def inertia(nodes, cells, density, motion):
    """M times a motion; nodes x 3."""
    force = numpy.zeros_like(motion)
    for point in numpy.stack(numpy.meshgrid(*[list(WEIGHTS)] * 3), -1).reshape(-1, 3):
        shape = shape_value(point)
        volume = numpy.linalg.det(numpy.einsum("cki,kj->cij", nodes[cells], shape_gradient(point)))
        moved = numpy.einsum("k,cki->ci", shape, motion[cells])
        weight = density * volume * numpy.prod([WEIGHTS[x] for x in point])
        numpy.add.at(force, cells, shape[:, None] * (weight[:, None] * moved)[:, None, :])
    return force


class Calculix:
    """Decks on the sector with both cut faces held."""

    def __init__(self, folder, node_count):
        self.folder, self.node_count = folder, node_count
        with open(os.path.join(folder, "mesh.inp"), encoding="ascii") as file:
            before, after = file.read().split("*SURFACE, NAME=low")
        with open(os.path.join(folder, "held.inp"), "w", encoding="ascii") as file:
            file.write(before + after[after.index("*MATERIAL"):] + "low, 1, 3\nhigh, 1, 3\n")

    def displacements(self, name, steps):
        """Of all nodes, after each step or of each mode; and the frequencies [Hz], if it has any."""
        with open(os.path.join(self.folder, name + ".inp"), "w", encoding="ascii") as file:
            file.write("*INCLUDE, INPUT=held.inp\n")
            for step in steps:
                file.write(step + "*NODE PRINT, NSET=Nall\nU\n*END STEP\n")
        subprocess.run(["ccx", name], cwd=self.folder, env=dict(os.environ, OMP_NUM_THREADS="1"), check=True,
                       stdout=subprocess.DEVNULL)
        with open(os.path.join(self.folder, name + ".dat"), encoding="ascii") as dat:
            rows = [line.split() for line in dat if line.split() and line.split()[0].isdigit()]
        moved = numpy.array([row[1:] for row in rows if len(row) == 4], float).reshape(-1, self.node_count, 3)
        return moved, numpy.array([row[3] for row in rows if len(row) == 5], float)

    def modes(self):
        return self.displacements("modes", [f"*STEP\n*FREQUENCY\n{MODES}\n"])

    def loaded(self, name, forces):
        """Large displacements under nodal forces, one after the other."""
        steps = []
        for force in forces:
            loads = "".join(f"{node + 1}, {i + 1}, {force[node, i]:.12e}\n" for node, i in zip(*numpy.nonzero(force)))
            steps.append("*STEP, NLGEOM, INC=1000\n*CONTROLS, PARAMETERS=FIELD\n1e-9, 1e-9\n*STATIC\n1, 1\n*CLOAD, OP=NEW\n"
                         + loads)
        return self.displacements(name, steps)[0]


class Tip:
    """The contact nodes, in x, y, z of space."""

    def __init__(self, model, nodes):
        gap = model["contact/second_order"]
        self.Q, self.V, self.curvature = gap["Q"][:], gap["V"][:], gap["curvature"][:]
        self.nodes = nodes
        theta = model["contact/position"][:, 1]
        zero, one = numpy.zeros_like(theta), numpy.ones_like(theta)
        self.frame = numpy.stack([numpy.stack(axis, 1) for axis in (
            (numpy.cos(theta), numpy.sin(theta), zero), (-numpy.sin(theta), numpy.cos(theta), zero), (zero, zero, one))], 1)
        self.normal = model["contact/normal"][:]

    def motion(self, displacement):
        """r, theta, z of each contact node."""
        return numpy.einsum("kij,kj->ki", self.frame, displacement[self.nodes])

    def along_normal(self, displacement):
        return numpy.einsum("ki,ki->k", self.normal, self.motion(displacement))

    def coordinates(self, displacement):
        return self.V.T @ self.motion(displacement).ravel()

    def bent(self, displacement):
        y = self.coordinates(displacement)
        return numpy.einsum("a,kab,b->k", y, self.Q, y)

    def casing(self, displacement):
        """How much nearer the casing is at the place of the tip than at rest."""
        around = self.motion(displacement)[:, 1]
        along = self.motion(displacement)[:, 2] * self.normal[:, 0] - self.motion(displacement)[:, 0] * self.normal[:, 2]
        return (self.curvature[:, 0] * around ** 2 + self.curvature[:, 1] * along ** 2) / 2


def modes_of_coordinates(tip, modes):
    """The number of the mode that is each coordinate of the model."""
    found = numpy.stack([tip.coordinates(mode) for mode in modes], 1)
    missed = [numpy.linalg.norm(tip.motion(mode).ravel() - numpy.linalg.pinv(tip.V.T) @ y) / numpy.linalg.norm(y)
              for mode, y in zip(modes, found.T)]
    share = abs(found) / numpy.linalg.norm(found, axis=0)
    numbers = [int(numpy.argmax(row - 10 * numpy.array(missed))) for row in share]
    assert len(set(numbers)) == len(numbers), numbers
    for row, number in zip(share, numbers):
        assert row[number] > 0.999 and missed[number] < 1e-2, "a coordinate of the model is no mode of CalculiX's"
    return numbers


AT_NODES = ["--set", "mesh.fillet_radius=0", "--set", 'reduce.contact="points"', "--set", "reduce.contact_nodes=10"]


def main(mesh, reduce, case, work):
    if shutil.which("ccx") is None:
        print("SKIPPED: CalculiX (ccx) is not installed; it is Debian's package calculix-ccx")
        return SKIPPED
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    sector, model, fields, decks = (os.path.join(work, name) for name in ("sector.msh", "model.h5", "fields.h5", "ccx"))
    subprocess.run([mesh, "-q", case, "-o", sector, *AT_NODES], check=True)
    subprocess.run([reduce, "-q", case, sector, "-o", model, "--fields", fields, *AT_NODES], check=True)
    subprocess.run([reduce, "-q", case, sector, "--export-ccx", decks, *AT_NODES], check=True)
    with h5py.File(fields) as file:
        nodes, cells, density = file["nodes"][:], file["cells"][:], file.attrs["density"]
        at_tip = file["node_set/contact"][:]
    with h5py.File(model) as file:
        tip = Tip(file, at_tip)
    peer = Calculix(decks, len(nodes))
    modes, frequencies = peer.modes()
    chosen = modes_of_coordinates(tip, modes)
    momenta = numpy.stack([inertia(nodes, cells, density, modes[number]) for number in chosen])
    worst = 0.0
    for number, momentum in list(zip(chosen, momenta))[:2]:
        force = (2 * numpy.pi * frequencies[number]) ** 2 / numpy.linalg.norm(tip.motion(modes[number]), axis=1).max() * momentum
        sides = [peer.loaded(f"mode_{number}_{name}", sign * AMPLITUDES[:, None, None] * force)
                 for name, sign in (("there", 1), ("back", -1))]
        print(f"mode {number + 1} of {frequencies[number]:.0f} Hz, by contact node in um")
        for row, (amplitude, there, back) in enumerate(zip(AMPLITUDES, *sides)):
            even, odd = (there + back) / 2, (there - back) / 2
            of_modes = sum(numpy.vdot(momentum, even) * modes[one] for one, momentum in zip(chosen, momenta))
            found, ours = tip.along_normal(even - of_modes), tip.bent(odd)
            for name, values in (("n.u of first order", tip.along_normal(odd)), ("n.u of even order, whole", tip.along_normal(even)),
                                 ("  but for the coordinates", found), ("  y'Qy of model.h5", ours),
                                 ("the gap opens", -found - tip.casing(odd))):
                print(f"{1e3 * amplitude:4.1f} mm  {name:26}" + "".join(f"{1e6 * value:9.2f}" for value in values))
            if row == COMPARED:
                error = abs(ours - found) / (TOLERANCE * abs(found) + LEAST * abs(found).max())
                worst = max(worst, error.max())
    print(f"y'Qy at {1e3 * AMPLITUDES[COMPARED]} mm: {worst:.2f} of the error allowed")
    return 0 if worst <= 1 else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
