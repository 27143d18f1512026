#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Response, class of motion and cost over damping.

usage: damping.py PROGRAMS_FOLDER CASE_FOLDER

Each damping ratio twice: on every mode, and with 2 % above the resolved frequency. Writes speeds.tsv (a line a speed) and
damping.tsv (a line a run: speeds of each class, and the rest). The cost is the processor time of tiprub-simulate, in one thread.
"""
import os
import resource
import subprocess
import sys

import h5py
import numpy

RPM = 30 / numpy.pi
RATIOS = (0.0005, 0.001, 0.002, 0.005, 0.01, 0.02)
BEYOND = 0.02
# From the first family's peak on engine order 4 to a speed at which the tips chatter.
SPEEDS = {"speeds": '"given"', "speed_min_rpm": 21600, "speed_max_rpm": 30400, "speed_count": 12, "examine": '"none"'}
PEAK_RPM = 22400
CLASSES = ("periodic", "subharmonic", "modulated", "broadband", "not settled")


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def simulate(programs, quick, keys):
    """Processor time [s] and the attributes of each speed."""
    before, output = processor_time(), "response.h5"
    if os.path.exists(output):
        os.remove(output)
    settings = {**SPEEDS, **keys}
    subprocess.run([os.path.join(programs, "tiprub-simulate"), "-q", os.path.join(quick, "case.toml"), os.path.join(quick, "model.h5"),
                    "-o", output, "--threads", "1", *(word for key, value in settings.items() for word in ("--set", f"simulate.{key}={value}"))],
                   check=True)
    with h5py.File(output) as file:
        speeds = [dict(group.attrs) for group in file["speed"].values() if not group.attrs["failure"]]
    os.remove(output)
    return processor_time() - before, speeds


def main(programs, quick):
    with open("speeds.tsv", "w", encoding="utf-8") as by_speed, open("damping.tsv.part", "w", encoding="utf-8") as by_run:
        by_speed.write("beyond\tdamping [%]\tspeed [rpm]\tamplitude [mm]\tmotion\trevolutions\tchatter [1]\thalving difference [1]\n")
        by_run.write("\t".join(["beyond", "damping [%]", *CLASSES, "peak [mm]", "largest halving difference [1]", "revolutions",
                                "processor time [s]"]) + "\n")
        for name in ("same", "2 %"):
            for ratio in RATIOS:
                cost, speeds = simulate(programs, quick, {"damping_ratio": ratio, "damping_ratio_beyond": ratio if name == "same" else BEYOND})
                motions = [at["motion"].decode() for at in speeds]
                for at, motion in zip(speeds, motions):
                    by_speed.write(f"{name}\t{100 * ratio:g}\t{at['speed'] * RPM:.0f}\t{1e3 * at['amplitude']:.5f}\t{motion}\t{at['revolutions']}\t"
                                   f"{at['chatter']:.4f}\t{at.get('halving_difference', numpy.nan):.5f}\n")
                by_speed.write("\n\n")  # a block of its own for gnuplot
                peak = min(speeds, key=lambda at: abs(at["speed"] * RPM - PEAK_RPM))
                worst = max(at.get("halving_difference", numpy.nan) for at in speeds)
                counts = "\t".join(str(motions.count(kind)) for kind in CLASSES)
                by_run.write(f"{name}\t{100 * ratio:g}\t{counts}\t{1e3 * peak['amplitude']:.5f}\t{worst:.5f}\t"
                             f"{sum(int(at['revolutions']) for at in speeds)}\t{cost:.2f}\n")
                by_run.flush()
    os.replace("damping.tsv.part", "damping.tsv")  # make goes by this table


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:3]))
