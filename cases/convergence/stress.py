#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress at critical speeds over the mesh, outside and inside the tip patch.

usage: stress.py PROGRAMS_FOLDER CASES_FOLDER [MESH ...]

Each mesh of the wheel of fast_impeller is swept over three windows around the first family's peaks on engine orders 8, 6 and
4; stress is read at the tallest peak of each, wherever it lies with that mesh. Writes stress.tsv, a line a mesh and window.
"""
import csv
import os
import sys

from convergence import MESHES, Bench, sector_dofs, written

WINDOWS_RPM = {"EO 8": range(9700, 10500, 40), "EO 6": range(13000, 14200, 50), "EO 4": range(21200, 23200, 100)}
BY_MESH = {
    "quick": {},
    "medium": MESHES["medium"],
    "fine": {"elements_along_chord": 28, "elements_along_bore": 11, "elements_along_span": 12,
             "elements_through_splitter": 3, "elements_through_disc": 5, "elements_between_blades": 6},
    "paper's size": {"elements_along_chord": 38, "elements_along_bore": 15, "elements_along_span": 16,
                     "elements_through_splitter": 3, "elements_through_disc": 6, "elements_between_blades": 8},
}
COLUMNS = ["amplitude [mm]", "von Mises, vibration [MPa]", "alternating [MPa]", "mean [MPa]",
           "in the tip patch, vibration [MPa]", "where these are"]


def critical_speeds(bench, name, sector):
    """The rows of critical_speeds.csv of one mesh, over all windows."""
    files = {key: os.path.join(bench.folder, f"{name} {key}") for key in ("model.h5", "fields.h5", "response.h5", "report")}
    bench.run("tiprub-reduce", [sector, "--fields", files["fields.h5"]], files["model.h5"], "reduce",
              {"verification_speeds": [0.0]})
    speeds = [rpm for window in WINDOWS_RPM.values() for rpm in window]
    bench.run("tiprub-simulate", [files["model.h5"]], files["response.h5"], "simulate", {"speeds_rpm": speeds, "speeds": '"given"'})
    bench.run("tiprub-postprocess", [files["model.h5"], files["response.h5"], "--fields", files["fields.h5"]],
              files["report"], "postprocess", {"prominence": 0.1})
    with open(os.path.join(files["report"], "critical_speeds.csv"), encoding="utf-8") as file:
        return list(csv.DictReader(file))


def peaks(rows):
    """By window: its tallest peak, if it has one."""
    for window, speeds in WINDOWS_RPM.items():
        inside = [row for row in rows if speeds[0] < float(row["speed [rpm]"]) < speeds[-1]]
        if inside:
            yield window, max(inside, key=lambda row: float(row["amplitude [mm]"]))


def main(programs, cases, names):
    bench = Bench(os.path.abspath(programs), os.path.abspath(cases), "stress_runs")
    with written("stress.tsv") as file:
        file.write("\t".join(["mesh", "dofs a sector", "peak", "speed [rpm]", *COLUMNS]) + "\n")
        for name in names or BY_MESH:
            sector = bench.mesh(name, BY_MESH[name])
            for window, row in peaks(critical_speeds(bench, name, sector)):
                values = [row[column] for column in COLUMNS]
                short = [f"{float(value):.4g}" if value and column.endswith("]") else value
                         for column, value in zip(COLUMNS, values)]
                file.write("\t".join([name, str(sector_dofs(sector)), window, f"{float(row['speed [rpm]']):.0f}", *short]) + "\n")
                file.flush()


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
