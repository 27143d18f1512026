#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""All critical speeds by marching to the settled motions, and by searching for orbits: cost, and whether they are the same.

usage: orbits.py PROGRAMS_FOLDER CASE_FOLDER=MODEL...

Each wheel is swept both ways side by side, each in one thread, with two dampings of its first families; the cost is the processor time
of tiprub-simulate. Writes orbits.tsv and critical_speeds.tsv.
"""
import csv
import os
import shutil
import subprocess
import sys

WAYS = ("march", "orbit")
DAMPINGS = (0.002, 0.005)
FAMILIES = 6
AS_IN_THE_PAPER = {"simulate.gap": '"linear"', "simulate.speed_min_rpm": 9000, "simulate.speed_max_rpm": 22000, "simulate.speed_count": 53}
RUNS = "runs"


def settings(way, damping):
    values = {**AS_IN_THE_PAPER, "simulate.steady_state": f'"{way}"', "simulate.examine": '"none"',
              "simulate.damping_ratio_by_family": [*FAMILIES * [damping], 0.02]}
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


def start(programs, wheel, model, way, damping, output):
    shutil.rmtree(output + ".speeds", ignore_errors=True)  # what is there already would cost nothing
    if os.path.exists(output):
        os.remove(output)
    return subprocess.Popen([os.path.join(programs, "tiprub-simulate"), "-q", os.path.join(wheel, "case.toml"), model,
                             "-o", output, "--threads", "1", *settings(way, damping)])


def processor_time(process):
    """[s] of a process, which is waited for."""
    _, status, used = os.wait4(process.pid, 0)
    assert status == 0, process.args
    return used.ru_utime + used.ru_stime


def critical_speeds(programs, wheel, model, way, damping, response):
    """Rows of the report: speed [rpm], amplitude [mm], motion."""
    report = response.replace(".h5", "_report")
    subprocess.run([os.path.join(programs, "tiprub-postprocess"), "-q", os.path.join(wheel, "case.toml"), model, response,
                    "-o", report, *settings(way, damping)], check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(report, "critical_speeds.csv"), newline="", encoding="utf-8") as file:
        return [(float(row["speed [rpm]"]), float(row["amplitude [mm]"]), row["motion"]) for row in csv.DictReader(file)]


def compare(programs, wheel, model, damping):
    """A row of orbits.tsv, and the rows of critical_speeds.tsv."""
    name = os.path.basename(wheel)
    outputs = [os.path.join(RUNS, f"{name}_{damping}_{way}.h5") for way in WAYS]
    processes = [start(programs, wheel, model, way, damping, output) for way, output in zip(WAYS, outputs)]
    march, orbit = map(processor_time, processes)
    by_march, by_orbit = (critical_speeds(programs, wheel, model, way, damping, output) for way, output in zip(WAYS, outputs))
    assert len(by_march) == len(by_orbit), f"{name}, {damping}: {len(by_march)} critical speeds by march, {len(by_orbit)} by orbit"
    speed, amplitude = (100 * max(abs(b[k] / a[k] - 1) for a, b in zip(by_march, by_orbit)) for k in (0, 1))
    same = sum(a[2] == b[2] for a, b in zip(by_march, by_orbit))
    rows = [[name, damping, f"{a[0]:.1f}", f"{b[0]:.1f}", f"{a[1]:.5f}", f"{b[1]:.5f}", a[2], b[2]] for a, b in zip(by_march, by_orbit)]
    return [name, damping, f"{march:.0f}", f"{orbit:.0f}", f"{march / orbit:.2f}", len(by_march), same, f"{speed:.4f}", f"{amplitude:.4f}"], rows


def write(name, header, rows):
    with open(name, "w", encoding="utf-8") as file:
        file.writelines("\t".join(map(str, row)) + "\n" for row in [header, *rows])


def main(programs, wheels):
    os.makedirs(RUNS, exist_ok=True)
    summary, critical = [], []
    for wheel, model in wheels:
        for damping in DAMPINGS:
            row, rows = compare(programs, wheel, model, damping)
            summary.append(row)
            critical += rows
            write("orbits.tsv.part", ["wheel", "damping [1]", "march [s]", "orbit [s]", "ratio", "critical speeds", "of the same motion",
                                      "speeds within [%]", "amplitudes within [%]"], summary)
            write("critical_speeds.tsv", ["wheel", "damping [1]", "march [rpm]", "orbit [rpm]", "march [mm]", "orbit [mm]", "march", "orbit"],
                  critical)
    os.replace("orbits.tsv.part", "orbits.tsv")  # make goes by this table


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]), [[*map(os.path.abspath, pair.split("="))] for pair in sys.argv[2:]])
