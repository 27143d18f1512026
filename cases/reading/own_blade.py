#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A blade of one's own: matrices of scipy, a reduced model, its frequencies, and its response at three clearances.   own_blade.py"""
import os
import subprocess

import numpy as np
from matplotlib import pyplot
from scipy import sparse

import tiprub

CASE = """[reduce]
speed_max_rpm = 20000
contact_nodes = 1
fixed_interface_modes = 10
[casing]
shape = "cosine"
lobes = 2
amplitude = 0.12e-3
clearance = [[0.0, 0.1e-3]]
[simulate]
speeds = "given"
speed_min_rpm = 9600
speed_max_rpm = 13000
speed_count = 35
damping_ratio = 0.03
examine = "none"
[postprocess]
"""
# A titanium strip by central differences. It leans by 20 degrees, so that contact bends it.
YOUNG, DENSITY, ROOT, LENGTH, WIDTH, THICKNESS, COUNT = 114e9, 4430.0, 0.10, 0.05, 0.03, 0.002, 61
step = LENGTH / (COUNT - 1.5)  # the strip is clamped midway between its first two nodes
along, across = np.array([np.cos(0.35), np.sin(0.35), 0]), np.array([-np.sin(0.35), np.cos(0.35), 0])
slope = sparse.diags([-1, 1], [0, 1], shape=(COUNT - 1, COUNT)) / step
curvature = sparse.diags([1, -2, 1], [0, 1, 2], shape=(COUNT - 2, COUNT)) / step**2


def bending(thickness, width):
    return YOUNG * width * thickness**3 / 12 * step * curvature.T @ curvature


parts = ((YOUNG * WIDTH * THICKNESS * step * slope.T @ slope, along), (bending(THICKNESS, WIDTH), across), (bending(WIDTH, THICKNESS), [0, 0, 1]))
K = sum(sparse.kron(part, np.outer(axis, axis)) for part, axis in parts)
M = sparse.kron(sparse.diags(DENSITY * WIDTH * THICKNESS * step * np.array([1.0] * (COUNT - 1) + [0.5])), sparse.eye(3))
nodes = [ROOT, 0, 0] + step * np.outer(np.arange(COUNT), along)
os.makedirs("runs", exist_ok=True)
with open("runs/case.toml", "w", encoding="utf-8") as file:
    file.write(CASE)
arguments = tiprub.matrices((K + K.T) / 2, M, nodes, {"clamped": [0, 1], "contact": [COUNT - 1]}, folder="runs")
subprocess.run(["tiprub-reduce", "runs/case.toml", *arguments, "-o", "runs/model.h5"], check=True)
beam = 1.8751**2 / LENGTH**2 * np.sqrt(YOUNG * THICKNESS**2 / 12 / DENSITY) / (2 * np.pi)
print(f"first frequency {tiprub.Model.read('runs/model.h5').frequencies(0)[0]:.1f} Hz, that of a clamped beam {beam:.1f} Hz")

figure, axes = pyplot.subplots(figsize=(8, 4), layout="constrained")
for clearance in (0.105, 0.110, 0.115):
    sweep = tiprub.run("runs/case.toml", set={"casing.clearance": [[0.0, clearance * 1e-3]]}, MODEL="runs/model.h5").sweep
    axes.plot(sweep.rpm, tiprub.mm(sweep.amplitude), ".-", label=f"clearance {clearance:.3f} mm")
axes.set(xlabel="speed [rpm]", ylabel="amplitude [mm]")
axes.legend()
figure.savefig("own_blade.png", dpi=120)
