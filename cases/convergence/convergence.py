#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Radial motion of the leading edge over the number of modes, the time step and the mesh.

usage: convergence.py PROGRAMS_FOLDER CASES_FOLDER

Starts from the case of fast_impeller and changes one thing at a time. Writes, in this folder, convergence.tsv (one line a
run) and traces.tsv (one revolution of the motion for each number of modes, as the paper's fig. 9). A difference is the
root mean square of the radial motion's difference to the finest run of its row, over that run's root mean square.
"""
import contextlib
import os
import shutil
import subprocess
import sys

import h5py
import numpy

# First family on engine orders 6 and 4, the tallest peaks whose motion is periodic, and a speed between them.
SPEEDS_RPM = [13500, 17500, 22500]
SAMPLES = 240
# The paper's eta = 150 gives its wheel 600 component modes, and doesn't say how. Here eta is a quarter of the wheel's
# component modes, so that 150 means the same size: 60 a nodal diameter on ten sectors.
ETAS, WHEEL_MODES_PER_ETA = [50, 100, 150, 200, 250], 4
MODES_IN_FILE = 80  # fixed-interface modes at each of two speeds; all of them are the reference
FEWEST_STEPS, HALVINGS = 480, 6
# Sectors between the quick one and the paper's size, and one that is too coarse.
MESHES = {
    "coarse": {"elements_along_chord": 6, "elements_along_bore": 3, "elements_along_span": 3,
               "elements_through_blade": 2, "elements_through_splitter": 2, "elements_through_disc": 2},
    "medium": {"elements_along_chord": 20, "elements_along_bore": 8, "elements_along_span": 9,
               "elements_through_splitter": 3, "elements_through_disc": 4, "elements_between_blades": 4},
}

# What the wheel is studied with, whatever its case says, unless a script says otherwise.
BASES = {"impeller_quick": {"mesh": {"fillet_radius": 0}, "reduce": {"contact": '"points"', "contact_nodes": 10, "speed_max_rpm": 22000},
                            "simulate": {"gap": '"linear"', "budget": '"none"'}}}


@contextlib.contextmanager
def written(name):
    """A table that takes its name once it is whole: make goes by that."""
    with open(name + ".part", "w", encoding="utf-8") as file:
        yield file
    os.replace(name + ".part", name)


class Bench:
    def __init__(self, programs, cases, folder="runs", case="fast_impeller"):
        self.programs, self.folder, self.case = programs, folder, os.path.join(folder, "case.toml")
        self.base = BASES.get(case, {})
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        # Speeds come as a list: those that the case spaces evenly go.
        with open(os.path.join(cases, case, "case.toml"), encoding="utf-8") as file:
            simulate = file.read().partition("[simulate]")
        kept = [line for line in simulate[2].splitlines(True) if not line.startswith(("speed_min_rpm", "speed_max_rpm", "speed_count", "speeds"))]
        with open(self.case, "w", encoding="utf-8") as file:
            file.write("".join([*simulate[:2], *kept]))

    def run(self, program, inputs, output, table, keys):
        """`inputs` may end with further options."""
        keys = {**self.base.get(table, {}), **keys}
        settings = [word for key, value in keys.items() for word in ("--set", f"{table}.{key}={value}")]
        subprocess.run([os.path.join(self.programs, program), "-q", self.case, *inputs, "-o", output, *settings], check=True,
                       stdout=subprocess.DEVNULL)

    def mesh(self, name, keys):
        sector = os.path.join(self.folder, name + ".msh")
        self.run("tiprub-mesh", [], sector, "mesh", keys)
        return sector

    def model(self, name, sector, keys):
        model = os.path.join(self.folder, name + ".h5")
        self.run("tiprub-reduce", [sector], model, "reduce", keys)
        return model

    def motion(self, name, model, keys):
        """By speed: radial displacement of the leading edge of sector 0 over one period, and the motion's class."""
        response = os.path.join(self.folder, name + "_response.h5")
        self.run("tiprub-simulate", [model], response, "simulate",
                 {"speeds_rpm": SPEEDS_RPM, "speeds": '"given"', "samples_per_revolution": SAMPLES, **keys})
        with h5py.File(response) as file:
            return [(group["displacement"][:, 0, 0, 0], group.attrs["motion"].decode())
                    for group in file["speed"].values()]


def sector_dofs(sector):
    """Three for each node of a gmsh 4.1 file."""
    with open(sector, "rb") as file:
        for line in file:
            if line.startswith(b"$Nodes"):
                return 3 * int(file.readline().split()[1])
    raise ValueError(f"{sector}: has no nodes")


def over_modes(bench, quick_sector, sectors):
    """Component modes: (eta, motions); the last keeps all."""
    rows = []
    for eta in ETAS + [0]:  # 0 keeps all
        count = eta * WHEEL_MODES_PER_ETA // sectors
        model = bench.model(f"eta{eta}", quick_sector, {"fixed_interface_modes": MODES_IN_FILE, "modes_at_speed": count,
                                                       "verification_speeds": [0.0]})
        with h5py.File(model) as file:
            size = len(file["nodal_diameter/0/M"]) - 3 * len(file["contact/arc_length"])
        rows.append((eta or size * sectors // WHEEL_MODES_PER_ETA, bench.motion(f"eta{eta}", model, {})))
    return rows


def over_steps(bench, quick_model):
    rows = []
    for k in range(HALVINGS):
        steps = FEWEST_STEPS * 2 ** k
        rows.append((steps, bench.motion(f"steps{steps}", quick_model, {"steps_per_revolution": steps, "examine": '"none"'})))
    return rows


def over_meshes(bench, quick_sector, quick_model, cases):
    meshes = [(quick_sector, quick_model),
              tuple(os.path.join(cases, "fast_impeller_fine", name) for name in ("sector.msh", "model.h5"))]
    for name, keys in MESHES.items():
        sector = bench.mesh(name, keys)
        meshes.append((sector, bench.model(name, sector, {"verification_speeds": [0.0]})))
    return [(sector_dofs(sector), bench.motion(f"mesh{sector_dofs(sector)}", model, {}))
            for sector, model in sorted(meshes, key=lambda pair: sector_dofs(pair[0]))]


def write_differences(rows):
    with written("convergence.tsv") as file:
        file.write("over\tvalue\tspeed [rpm]\tamplitude [mm]\tdifference [1]\tmotion\n")
        for over, runs in rows.items():
            for value, motions in runs:
                for rpm, (trace, kind), (finest, _) in zip(SPEEDS_RPM, motions, runs[-1][1]):
                    length = min(len(trace), len(finest))
                    difference = numpy.sqrt(((trace[:length] - finest[:length]) ** 2).mean() / (finest ** 2).mean())
                    amplitude = 0.5e3 * (trace.max() - trace.min())
                    file.write(f"{over}\t{value}\t{rpm}\t{amplitude:.6f}\t{difference:.3e}\t{kind}\n")


def write_traces(counts):
    with written("traces.tsv") as file:
        file.write("angle [deg]\t" + "\t".join(f"eta = {value}, {rpm} rpm [mm]" for rpm in SPEEDS_RPM for value, _ in counts) + "\n")
        for s in range(SAMPLES):
            values = [1e3 * motions[i][0][s] for i in range(len(SPEEDS_RPM)) for _, motions in counts]
            file.write(f"{360.0 * s / SAMPLES:g}\t" + "\t".join(f"{value:.6f}" for value in values) + "\n")


def main(programs, cases):
    bench = Bench(programs, cases)
    quick_sector, quick_model = (os.path.join(cases, "fast_impeller", name) for name in ("sector.msh", "model.h5"))
    with h5py.File(quick_model) as model:
        sectors = int(model.attrs["sector_count"])
    rows = {"eta": over_modes(bench, quick_sector, sectors),
            "steps a revolution": over_steps(bench, quick_model),
            "dofs a sector": over_meshes(bench, quick_sector, quick_model, cases)}
    write_differences(rows)
    write_traces(rows["eta"])


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:3]))
