#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Peaks and cost of the adaptive sweep, and of an even grid ten times finer than its first one.

usage: located_peaks.py PROGRAMS_FOLDER CASE_FOLDER [SCENE...]

Both sweeps run here, one after the other, in one thread; the cost is the processor time of tiprub-simulate. A peak is one of the
amplitude over speed; its prominence is its height above the higher of its two valleys, over its height. A peak of the even grid is
found if the adaptive sweep has one of half that prominence within one spacing of the even grid: half, because nobody asked for the
valleys. Writes peaks.tsv, missed.tsv and a table of the amplitudes for each sweep.
"""
import os
import resource
import shutil
import subprocess
import sys

import h5py
import numpy

RPM = 30 / numpy.pi
PROMINENCES = (0.10, 0.25)
FINER = 10
# Name, what it changes in the case, range [rev/min], speeds of the first grid.
SCENES = {
    "two_lobes": ({}, (9000, 55000), 93),
    "three_lobes": ({"casing.lobes": 3}, (9000, 25000), 33),
    "half_damping": ({"simulate.damping_ratio": 0.005}, (9000, 25000), 33),
}


def peaks(amplitude, share):
    """Indices of the local maxima whose prominence is at least `share` of their height; the ends of the range are none."""
    found = []
    for i in range(1, len(amplitude) - 1):
        if not amplitude[i - 1] < amplitude[i] >= amplitude[i + 1]:
            continue
        valleys = []
        for side in (amplitude[i::-1], amplitude[i:]):
            above = numpy.flatnonzero(side > amplitude[i])
            valleys.append(side[:above[0] if len(above) else len(side)].min())
        if amplitude[i] - max(valleys) >= share * amplitude[i]:
            found.append(i)
    return numpy.array(found, dtype=int)


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def sweep(programs, quick, output, changes):
    """Processor time [s], speeds [rev/min] and largest amplitudes [m] of a sweep."""
    settings = {"simulate.examine": '"none"', **changes}
    shutil.rmtree(output + ".speeds", ignore_errors=True)  # what is there already would cost nothing
    if os.path.exists(output):
        os.remove(output)
    before = processor_time()
    subprocess.run([os.path.join(programs, "tiprub-simulate"), "-q", os.path.join(quick, "case.toml"),
                    os.path.join(quick, "model.h5"), "-o", output, "--threads", "1",
                    *(word for key, value in settings.items() for word in ("--set", f"{key}={value}"))], check=True)
    cost = processor_time() - before
    with h5py.File(output) as file:
        rows = sorted((at.attrs["speed"] * RPM, at.attrs["amplitude"]) for at in file["speed"].values() if not at.attrs["failure"])
    rows = numpy.array(rows)
    numpy.savetxt(output.replace(".h5", ".tsv"), rows * [1, 1e3], "%.6g", "\t", header="speed [rpm]\tamplitude [mm]", comments="")
    return cost, rows[:, 0], rows[:, 1]


def compare(name, even, adaptive):
    """Rows of peaks.tsv and of missed.tsv."""
    summary, missed = [], []
    spacing = numpy.diff(even[1]).mean()
    for share in PROMINENCES:
        of_even, of_adaptive = peaks(even[2], share), peaks(adaptive[2], share / 2)
        away = abs(even[1][of_even][:, None] - adaptive[1][of_adaptive])
        nearest = away.argmin(axis=1)
        found = away.min(axis=1) <= spacing
        higher = adaptive[2][of_adaptive[nearest]][found] / even[2][of_even][found] - 1
        apart = abs(even[1][peaks(even[2], share / 2)][:, None] - adaptive[1][peaks(adaptive[2], share)]).min(axis=0)
        further = (apart > spacing).sum()
        summary.append([name, len(even[1]), f"{even[0]:.1f}", len(adaptive[1]), f"{adaptive[0]:.1f}", f"{adaptive[0] / even[0]:.3f}",
                        share, len(of_even), found.sum(), further, f"{higher.min():.3f}", f"{higher.max():.3f}"])
        missed += [[name, share, f"{even[1][i]:.0f}", f"{1e3 * even[2][i]:.5f}", f"{adaptive[1][of_adaptive[j]]:.1f}",
                    f"{1e3 * adaptive[2][of_adaptive[j]]:.5f}"] for i, j in zip(of_even[~found], nearest[~found])]
    return summary, missed


def write(name, header, rows):
    with open(name, "w", encoding="utf-8") as file:
        file.writelines("\t".join(map(str, row)) + "\n" for row in [header, *rows])


def main(programs, quick, names):
    summary, missed = [], []
    for name in names:
        changes, (low, high), count = SCENES[name]
        changes = {**changes, "simulate.speed_min_rpm": low, "simulate.speed_max_rpm": high}
        adaptive = sweep(programs, quick, f"{name}_adaptive.h5",
                         {**changes, "simulate.speed_count": count, "simulate.speeds": '"adaptive"'})
        even = sweep(programs, quick, f"{name}_even.h5",
                     {**changes, "simulate.speed_count": FINER * (count - 1) + 1, "simulate.speeds": '"given"'})
        for rows, more in zip((summary, missed), compare(name, even, adaptive)):
            rows += more
        write("peaks.tsv.part", ["scene", "even speeds", "even [s]", "adaptive speeds", "adaptive [s]", "cost ratio", "prominence", "even peaks",
                                 "found", "further peaks", "least rise [1]", "largest rise [1]"], summary)
        write("missed.tsv", ["scene", "prominence", "even [rpm]", "even [mm]", "nearest adaptive [rpm]", "nearest adaptive [mm]"], missed)
    os.replace("peaks.tsv.part", "peaks.tsv")  # make goes by this table


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:3]), sys.argv[3:] or list(SCENES))
