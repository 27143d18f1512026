#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Time and memory of the modes of an unreduced sector, side by side with CalculiX on the same mesh and core.

usage: side_by_side.py TIPRUB_MESH TIPRUB_REDUCE CASE WORK_FOLDER [SIZE...]

The case's wheel at rest, 10 modes at every nodal diameter, one thread, on meshes of about SIZE thousand dofs (30, 120).
tiprub-reduce --modes runs twice before and twice after CalculiX's one run, all on the first core that this process may use; the
median counts. Prints a table; exit 1 where a frequency differs by more than 1e-6 or a ratio is below its bar. Exit 77
(skipped) if there is no CalculiX.
"""
import os
import shutil
import statistics
import subprocess
import sys
import time

import h5py

from calculix import SKIPPED, TOLERANCE, calculix_frequencies

MODES = 10
RUNS = 4  # of ours, half of them before CalculiX's, half after
# Thousand dofs: elements along chord, bore and span, through the disc, between blades; the least ratio of the times; the
# most memory over CalculiX's (on a small mesh the libraries' own 0.2 GiB tell).
SIZES = {
    "30": ((22, 9, 8, 3, 4), 15, 1.5),
    "120": ((38, 15, 16, 6, 8), 25, 1),
}
MESH_KEYS = ("elements_along_chord", "elements_along_bore", "elements_along_span", "elements_through_disc",
             "elements_between_blades")


class Cost:
    """What a program took: wall and processor time [s], peak memory [GiB]."""

    def __init__(self, command, folder):
        start = time.monotonic()
        environment = dict(os.environ, OMP_NUM_THREADS="1")
        with subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL) as process:
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{' '.join(command)}: exit code {process.returncode}")
        self.wall = time.monotonic() - start
        self.processor = usage.ru_utime + usage.ru_stime
        self.memory = usage.ru_maxrss / 2**20


def largest_difference(ours, theirs):
    """Of any frequency, relative: the file that --modes wrote against CalculiX's table."""
    with h5py.File(ours) as file:
        table = {int(n): modes["frequency"][0] for n, modes in file["nodal_diameter"].items()}
    return max(abs(mine / peer - 1) for n, row in table.items() for mine, peer in zip(row, theirs[n], strict=True))


def settings(table, keys):
    return [word for key, value in keys.items() for word in ("--set", f"{table}.{key}={value}")]


def compare(mesh, reduce, case, folder, elements):
    """Dofs, the largest difference of a frequency, the median cost of ours and CalculiX's."""
    os.makedirs(folder)
    shape = settings("mesh", dict(zip(MESH_KEYS, elements)))
    linear = settings("reduce", {"verification_speeds": "[0.0]", "verification_modes": MODES, "threads": 1})
    subprocess.run([mesh, "-q", case, "-o", "sector.msh", *shape], cwd=folder, check=True)
    subprocess.run([reduce, "-q", case, "sector.msh", "--export-ccx", ".", *linear], cwd=folder, check=True)
    ours = [reduce, "-q", case, "sector.msh", "--modes", "modes.h5", *linear]
    runs = [Cost(ours, folder) for _ in range(RUNS // 2)]
    peer = Cost(["ccx", "speed_0"], folder)
    runs += [Cost(ours, folder) for _ in range(RUNS // 2)]
    frequencies = calculix_frequencies(os.path.join(folder, "speed_0.dat"))
    return largest_difference(os.path.join(folder, "modes.h5"), frequencies), runs, peer


def main(mesh, reduce, case, work, *sizes):
    if shutil.which("ccx") is None:
        print("SKIPPED: CalculiX (ccx) is not installed; it is Debian's package calculix-ccx")
        return SKIPPED
    mesh, reduce, case = map(os.path.abspath, (mesh, reduce, case))
    os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
    shutil.rmtree(work, ignore_errors=True)
    good = True
    print("size_thousand_dofs\tprogram\twall_s\tprocessor_s\tmemory_GiB\twall_ratio\tprocessor_ratio\tlargest_difference")
    for size in sizes or SIZES:
        elements, faster, larger = SIZES[size]
        difference, runs, peer = compare(mesh, reduce, case, os.path.join(work, size), elements)
        wall, processor, memory = (statistics.median(getattr(run, what) for run in runs)
                                   for what in ("wall", "processor", "memory"))
        ratios = peer.wall / wall, peer.processor / processor
        print(f"{size}\tCalculiX\t{peer.wall:.1f}\t{peer.processor:.1f}\t{peer.memory:.2f}\t1\t1\t0")
        print(f"{size}\ttiprub-reduce\t{wall:.2f}\t{processor:.2f}\t{memory:.2f}\t{ratios[0]:.1f}\t{ratios[1]:.1f}\t{difference:.1e}",
              flush=True)
        good = good and difference <= TOLERANCE and min(ratios) >= faster and memory <= larger * peer.memory
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
