#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A march with a gap of second order against another program, which knows nothing of tiprub-simulate.

usage: second_order_march.py TIPRUB_MESH TIPRUB_REDUCE TIPRUB_SIMULATE CASE WORK_FOLDER

It reads model.h5 and marches the wheel at two speeds beside the largest peak. Unlike tiprub-simulate, it takes the
displacements along and around the casing from all modes, and turns the casing exactly. Compared is the largest motion along
a normal, half its range.
"""
import os
import subprocess
import sys

import h5py
import numpy
from numpy.linalg import cholesky, eigh, solve

SPEEDS = (19180, 19532)   # rev/min
FAMILIES = 6              # with the lower damping
DAMPING = (0.005, 0.02)   # of the families, and beyond
STEPS, REVOLUTIONS, RAMP = 1200, 40, 3
CLEARANCE, AMPLITUDE, LOBES, SPEED_OF_CLEARANCE = (0.21e-3, 0.20e-3), 0.25e-3, 2, 22000
TOLERANCE = 0.03
SETTINGS = ("simulate.speeds=\"given\"", "simulate.examine=\"none\"", "simulate.gap=\"second_order\"",
            "simulate.symmetry_check_revolutions=0", "simulate.speed_min_rpm=", "simulate.speed_max_rpm=", "simulate.speed_count=")

AT_NODES = ["--set", "mesh.fillet_radius=0", "--set", 'reduce.contact="points"', "--set", "reduce.contact_nodes=10"]


class Wheel:
    def __init__(self, path):
        with h5py.File(path) as file:
            contact = file["contact"]
            self.position, self.normal, self.arc = (contact[name][()] for name in ("position", "normal", "arc_length"))
            self.shift = [contact[f"static_shift_{i}"][()] for i in (1, 2)]
            self.curvature, self.V, self.Q = (contact["second_order"][name][()] for name in ("curvature", "V", "Q"))
            self.blocks = {int(n): {name: self.matrix(data) for name, data in block.items()}
                           for n, block in file["nodal_diameter"].items()}
            self.sectors = int(file.attrs["sector_count"])
        self.tangent = numpy.stack([-self.normal[:, 2], 0 * self.arc, self.normal[:, 0]], 1)
        self.nodes = len(self.arc)

    @staticmethod
    def matrix(data):
        values = data[()]
        return values if values.dtype.kind in "fc" else values["r"] + 1j * values["i"]

    def modes(self, n, speed):
        block = self.blocks[n]
        K, M = block["K0"] + speed**2 * block["K1"] + speed**4 * block["K2"], block["M"]
        L = cholesky(M)
        squares, shapes = eigh(solve(L, solve(L, K).conj().T).conj().T)
        return numpy.sqrt(squares), solve(L.conj().T, shapes)[:3 * self.nodes]

    def clearance(self, speed):
        moved = [sum(shift * omega**(2 * i + 2) for i, shift in enumerate(self.shift))
                 for omega in (speed, SPEED_OF_CLEARANCE * numpy.pi / 30)]
        place = (self.arc - self.arc[0]) / (self.arc[-1] - self.arc[0])
        return CLEARANCE[0] + (CLEARANCE[1] - CLEARANCE[0]) * place - (self.normal * (moved[0] - moved[1])).sum(1)


def contact_forces(gap, W):
    """lambda >= 0 that complements g + W lambda >= 0."""
    closed = numpy.flatnonzero(gap < 0)
    for _ in range(30):
        forces = numpy.zeros(len(gap))
        forces[closed] = solve(W[numpy.ix_(closed, closed)], -gap[closed])
        after = gap + W @ forces
        after[closed] = 0
        wanted = (forces > 0) | (after < -1e-12)
        if (wanted == numpy.isin(numpy.arange(len(gap)), closed)).all():
            return forces
        closed = numpy.flatnonzero(wanted)
    raise RuntimeError("no set of closed nodes")


class March:
    """The symmetric nodal diameters of a wheel at a speed, in real modes of the sectors that differ."""

    def __init__(self, wheel, rpm):
        self.wheel, self.speed = wheel, rpm * numpy.pi / 30
        symmetry = numpy.gcd(wheel.sectors, LOBES)
        self.sectors, alpha = wheel.sectors // symmetry, 2 * numpy.pi / wheel.sectors
        shapes, omegas, weights = [], [], []
        for n in range(0, wheel.sectors // 2 + 1, symmetry):
            omega, own = wheel.modes(n, self.speed)
            ring = (numpy.exp(1j * n * alpha * numpy.arange(self.sectors))[:, None, None] * own).reshape(-1, len(omega))
            standing = 2 * n in (0, wheel.sectors)
            for part in (ring.real,) if standing else (ring.real, -ring.imag):
                shapes.append(part)
                omegas.append(omega)
                weights.append(numpy.full(len(omega), (1 if standing else 2) / self.sectors))
        ratio = numpy.hstack([numpy.where(numpy.arange(len(omega)) < FAMILIES, *DAMPING) for omega in omegas])
        self.U, omega, weight = (numpy.hstack(parts) for parts in (shapes, omegas, weights))
        h = 2 * numpy.pi / self.speed / STEPS
        decay, angle = numpy.exp(-ratio * omega * h), numpy.minimum(omega * numpy.sqrt(1 - ratio**2) * h, 2.4)
        self.lost, self.pulled = 1 - decay**2, 1 - 2 * decay * numpy.cos(angle) + decay**2
        self.pushed = (self.U * (self.pulled / omega**2 * weight)).T
        self.around = wheel.position[:, 1] + alpha * numpy.arange(self.sectors)[:, None]
        self.clearance = wheel.clearance(self.speed)

    def of_nodes(self, modes):
        u = (self.U @ modes).reshape(self.sectors, self.wheel.nodes, 3)
        return u, u[..., 1], (u * self.wheel.tangent).sum(2), u.reshape(self.sectors, -1) @ self.wheel.V

    def casing(self, instant, u_theta):
        """Its distortion where the tips are, and the slope of that over u_theta."""
        x = min(instant / RAMP, 1)
        grown = AMPLITUDE * x**3 * (10 - 15 * x + 6 * x * x)
        radius = self.wheel.position[:, 0]
        angle = LOBES * (self.around + 2 * numpy.pi * instant + u_theta / radius)
        return grown * numpy.cos(angle), -grown * LOBES / radius * numpy.sin(angle)

    def gap(self, modes, instant):
        wheel, (u, u_theta, u_m, y) = self.wheel, self.of_nodes(modes)
        return (self.clearance - self.casing(instant, u_theta)[0] - (wheel.normal * u).sum(2)
                - (wheel.curvature[:, 0] * u_theta**2 + wheel.curvature[:, 1] * u_m**2) / 2
                - numpy.einsum("kab,sa,sb->sk", wheel.Q, y, y)).ravel()

    def directions(self, modes, instant):
        """The gradients of the gaps over the displacements of all contact nodes, with the opposite sign."""
        wheel, (_, u_theta, u_m, y) = self.wheel, self.of_nodes(modes)
        slopes = 2 * numpy.einsum("kab,sb,ia->ski", wheel.Q, y, wheel.V)
        own = wheel.normal + (wheel.curvature[:, 1] * u_m)[..., None] * wheel.tangent
        own[..., 1] += wheel.curvature[:, 0] * u_theta + self.casing(instant, u_theta)[1]
        for k in range(wheel.nodes):
            slopes[:, k, 3 * k:3 * k + 3] += own[:, k]
        D = numpy.zeros((self.sectors, wheel.nodes, self.sectors, 3 * wheel.nodes))
        D[range(self.sectors), :, range(self.sectors)] = slopes
        return D.reshape(self.sectors * wheel.nodes, -1)

    def amplitude(self):
        q = increment = numpy.zeros(len(self.lost))
        low, high = numpy.inf, -numpy.inf
        for i in range(REVOLUTIONS * STEPS):
            increment = (1 - self.lost) * increment - self.pulled * q
            gap = self.gap(q + increment, (i + 1) / STEPS)
            if (gap < 0).any():
                D = self.directions(q, i / STEPS)
                increment = increment - self.pushed @ (D.T @ contact_forces(gap, (D @ self.U) @ (self.pushed @ D.T)))
            q = q + increment
            if i >= (REVOLUTIONS - 2) * STEPS:
                moved = (self.wheel.normal * self.of_nodes(q)[0]).sum(2)
                low, high = numpy.minimum(low, moved), numpy.maximum(high, moved)
        return (high - low).max() / 2


def main(mesh, reduce, simulate, case, folder):
    os.makedirs(folder, exist_ok=True)
    sector, model, response = (os.path.join(folder, name) for name in ("sector.msh", "model.h5", "response.h5"))
    if os.path.exists(response):
        os.remove(response)
    subprocess.run([mesh, "-q", case, "-o", sector, *AT_NODES], check=True)
    subprocess.run([reduce, "-q", case, sector, "-o", model, *AT_NODES], check=True)
    words = [word for setting in (*SETTINGS, f"simulate.speeds_rpm={list(SPEEDS)}") for word in ("--set", setting)]
    subprocess.run([simulate, "-q", case, model, "-o", response, *words], check=True)
    with h5py.File(response) as file:
        computed = file["amplitude"][()]
    wheel, good = Wheel(model), True
    print("rev/min   this march [mm]   tiprub-simulate [mm]")
    for rpm, own in zip(SPEEDS, computed):
        expected = March(wheel, rpm).amplitude()
        print(f"{rpm:7.0f}   {1e3 * expected:15.4f}   {1e3 * own:20.4f}")
        good &= abs(own / expected - 1) < TOLERANCE
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main(*sys.argv[1:6])
