#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A blade with friction against another contact algorithm, which knows nothing of tiprub-simulate.

usage: sliding_march.py TIPRUB_MESH TIPRUB_REDUCE TIPRUB_SIMULATE CASE WORK_FOLDER [BLADE_FOLDER]

The blade of CASE meets the casing of Piollet, Nyssen and Batailly (2019), eqs. 3 and 4, with a coefficient of friction of 0.15. The
algorithm is that of Monjaraz-Tec, Gross and Krack (Computers & Structures 260, 2022): modes with mass that are stepped by
leapfrog, a boundary without mass, and Coulomb's and Signorini's conditions on the velocities of each closed node, as a projection
that is iterated. It reads model.h5. Compared are the motion along the normals and in all directions, and the mean contact force.

BLADE_FOLDER is EXAMPLES/03_bladeCasingRubbing/FEmodel of NLstep (github.com/maltekrack/NLstep): its blade is then taken in place of
that of CASE, by the matrices that CalculiX writes for it, with its radial normals and its speed. NLstep's own example lets the
casing slide the other way, so that the drag pushes the blade forward; here it is against the rotation.
"""
import os
import re
import subprocess
import sys

import h5py
import numpy
from numpy.linalg import cholesky, eigh, solve

from matrices import NO_MATERIAL

CLEARANCE, BUMP, WIDTH = 0.356e-3, 2 * 0.356e-3, 0.15  # [m], [m], of half a revolution
FRICTION, MODES, STEPS = 0.15, 50, (2000, 4000)
TOLERANCE = 0.02
CONTACT = [188, 190, 192, 194, 196, 198, 200, 203, 253, 255, 257, 259, 261, 263, 265, 267]  # nodes of NLstep's blade


def bump(turn):
    """[m] The casing's inward distortion after so many half revolutions, and its derivative."""
    x = (turn % 1 - 0.5) / WIDTH
    inward = BUMP * numpy.exp(-x * x)
    return inward, -2 * x / WIDTH * inward


class Blade:
    """Free-interface modes and the residual flexibility of the contact nodes along -normal, the tip line and theta."""

    def __init__(self, path, speed):
        with h5py.File(path) as file:
            self.position, normal = file["contact/position"][()], file["contact/normal"][()]
            block = file["nodal_diameter/0"]
            K = sum(block[f"K{i}"][()] * speed**(2 * i) for i in range(3))
            M = block["M"][()]
        self.speed, nodes = speed, len(normal)
        frames = numpy.zeros((3 * nodes, 3 * nodes))
        for k, n in enumerate(normal):
            frames[3 * k:3 * k + 3, 3 * k:3 * k + 3] = -n, (-n[2], 0, n[0]), (0, 1, 0)
        L = cholesky(M)
        squares, shapes = eigh(solve(L, solve(L, K).T))
        boundary = frames @ solve(L.T, shapes)[:3 * nodes]
        self.omega, self.shapes = numpy.sqrt(squares[:MODES]), boundary[:, :MODES]
        self.residual = boundary[:, MODES:] / squares[MODES:] @ boundary[:, MODES:].T


def projected(force):
    """The nearest forces that push and lie in the cone of friction; a row for each node: normal and two tangential."""
    normal = numpy.maximum(force[:, 0], 0)
    sideways = numpy.hypot(force[:, 1], force[:, 2])
    scale = FRICTION * normal / numpy.maximum(sideways, numpy.maximum(FRICTION * normal, 1e-300))
    return numpy.column_stack([normal, force[:, 1] * scale, force[:, 2] * scale])


def contact_forces(G, c, force):
    """Forces that are the projection of themselves less a multiple of the velocities G force + c."""
    relax = (1 / abs(G).sum(axis=1)).reshape(-1, 3).min(axis=1, keepdims=True)
    for _ in range(10000):
        following = projected(force - relax * (G @ force.ravel() + c).reshape(-1, 3))
        if abs(following - force).max() <= 1e-6 * abs(following).max():
            return following
        force = following
    raise RuntimeError("the forces of a step do not converge")


def march(blade, damping, revolutions, steps):
    """The displacements [m] of the last revolution along -normal, the tip line and theta, and the mean contact force [N]."""
    h = 2 * numpy.pi / blade.speed / steps
    G, slow, fast = blade.residual / h, 1 / h - damping * blade.omega, 1 / h + damping * blade.omega
    q = v = numpy.zeros(MODES)
    tip, tip_velocity = numpy.zeros((2, 3 * len(blade.position)))
    force = numpy.zeros((len(blade.position), 3))
    slide = numpy.zeros((len(blade.position), 3))
    slide[:, 2] = blade.position[:, 0] * blade.speed
    moved, pushed = [], 0
    for i in range(revolutions * steps):
        inward, slope = bump(2 * i / steps + blade.position[:, 1] / numpy.pi)
        slide[:, 0] = -slope * blade.speed / numpy.pi
        predicted = (tip + h * tip_velocity).reshape(-1, 3)[:, 0] + CLEARANCE - inward
        closed = (predicted <= 0) | (force[:, 0] > 0)
        force[~closed] = 0
        free = blade.shapes @ q
        if closed.any():
            rows = numpy.repeat(closed, 3)
            force[closed] = contact_forces(G[numpy.ix_(rows, rows)], ((free - tip) / h + slide.ravel())[rows], force[closed])
        after = free + blade.residual @ force.ravel()
        tip_velocity, tip = (after - tip) / h, after
        v = (slow * v - blade.omega**2 * q + blade.shapes.T @ force.ravel()) / fast
        q = q + h * v
        if i >= (revolutions - 1) * steps:
            moved.append(tip.reshape(-1, 3))
            pushed += force[:, 0].sum() / steps
    return numpy.array(moved), pushed


def measures(moved, force):
    """Half the largest range along a normal [m], the largest motion in all directions [m], and the mean force [N]."""
    normal = moved[..., 0]
    everywhere = numpy.linalg.norm(moved - moved.mean(axis=0), axis=-1)
    return numpy.array([numpy.ptp(normal, axis=0).max() / 2, everywhere.max(), force])


def own_blade(mesh, reduce, case):
    """Writes model.h5. Returns the speed [rad/s], the damping ratio, and the revolutions to march."""
    subprocess.run([mesh, "-q", case, "-o", "sector.msh"], check=True)
    subprocess.run([reduce, "-q", case, "sector.msh", "-o", "model.h5", "--set", 'reduce.contact="points"', "--set", "reduce.contact_nodes=10"],
                   check=True)
    return 1800.0, 0.02, 20


def in_metres(folder):
    """Writes NLstep's deck, which has N, mm, t and s, in SI units, so that CalculiX stores its matrices. Returns its nodes."""
    with open(os.path.join(folder, "blade.msh"), encoding="ascii") as file:
        places, elements = file.read().split("*ELEMENT")
    with open(os.path.join(folder, "blade.inp"), encoding="ascii") as file:
        clamped = re.search(r"(?s)\*BOUNDARY\n.*?(?=\n\*\*)", file.read()).group(0)
    nodes = {int(node): tuple(float(x) / 1e3 for x in place.split(","))
             for node, place in re.findall(r"(?m)^ *(\d+),([^,\n]+,[^,\n]+,[^,\n]+)$", places)}
    lines = [f"{node},{x:.12e},{y:.12e},{z:.12e}" for node, (x, y, z) in nodes.items()]
    with open("blade.inp", "w", encoding="ascii") as file:
        file.write("\n".join(["*NODE, NSET=Nall", *lines, "*ELEMENT" + elements.rstrip(), clamped]) +
                   "\n*MATERIAL,NAME=MAT\n*ELASTIC\n210e9,0.3\n*DENSITY\n9000.\n*SOLID SECTION,ELSET=Eall,MATERIAL=MAT\n"
                   "*STEP\n*FREQUENCY, SOLVER=MATRIXSTORAGE\n1\n*END STEP\n")
    return nodes


def blade_of(folder, reduce, case):
    """The same for NLstep's blade."""
    nodes = in_metres(folder)
    subprocess.run(["ccx", "blade"], check=True, stdout=subprocess.DEVNULL)
    with open("nodes.csv", "w", encoding="ascii") as file:
        file.write("node,x,y,z,set\n")
        for node in sorted(nodes, key=lambda node: (node not in CONTACT, nodes[node][2])):
            file.write(f"{node},{','.join(map(repr, nodes[node]))},{'contact' if node in CONTACT else ''}\n")
    subprocess.run([reduce, "-q", case, "--matrices", "blade.sti", "blade.mas", "nodes.csv", "--matrix-dofs", "blade.dof", "-o", "model.h5",
                    "--set", f"reduce.contact_nodes={len(CONTACT)}", "--set", "reduce.fixed_interface_modes=60",
                    "--set", "reduce.speed_max_rpm=13000", *NO_MATERIAL], check=True)
    with h5py.File("model.h5", "r+") as file:
        file["contact/normal"][...] = (1, 0, 0)
        del file.attrs["digest"]
    return 1344.0, 0.005, 50


def simulated(simulate, speed, damping, revolutions):
    """The last revolution of a march from rest as that of march(), with drag on all modes, and without a ramp."""
    with open("distortion.csv", "w", encoding="ascii") as file:
        for degrees in numpy.arange(0, 180, 0.25):
            file.write(f"{degrees},{bump(degrees / 180)[0]:.12e}\n")
    with open("casing.toml", "w", encoding="ascii") as file:
        file.write(f"""[casing]
shape = "table"
lobes = 2
distortion_table = "distortion.csv"
clearance = [[0, {CLEARANCE}]]
friction_coefficient = {FRICTION}
ramp_revolutions = 1e-6
[simulate]
speeds = "given"
speeds_rpm = [{speed * 30 / numpy.pi!r}]
examine = "none"
steady_state = "march"
gap = "linear"
damping_ratio = {damping}
resolved_frequency_hz = 1e6
steps_per_revolution = 7680
step_tolerance = 0.5
min_revolutions = {revolutions}
max_revolutions = {revolutions}
recorded_revolutions = 1
""")
    if os.path.exists("response.h5"):
        os.remove("response.h5")
    subprocess.run([simulate, "-q", "casing.toml", "model.h5", "-o", "response.h5"], check=True)
    with h5py.File("response.h5") as file, h5py.File("model.h5") as model:
        at = next(iter(file["speed"].values()))
        u, n = at["displacement"][:, 0], model["contact/normal"][()]
        return numpy.stack([-(u * n).sum(-1), u[..., 2] * n[:, 0] - u[..., 0] * n[:, 2], u[..., 1]], -1), at["contact_force"][:, 0].sum(-1).mean()


def main(mesh, reduce, simulate, case, work, folder=None):
    os.makedirs(work, exist_ok=True)
    os.chdir(work)
    speed, damping, revolutions = blade_of(folder, reduce, case) if folder else own_blade(mesh, reduce, case)
    own = measures(*simulated(simulate, speed, damping, revolutions))
    blade = Blade("model.h5", speed)
    print("steps a revolution   along the normal [m]   |u| [m]   mean force [N]")
    print("tiprub-simulate     ", *own)
    for steps in STEPS:
        expected = measures(*march(blade, damping, revolutions, steps))
        print(f"{steps:6d}              ", *expected, flush=True)
    sys.exit(0 if (abs(own / expected - 1) < TOLERANCE).all() else 1)


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
