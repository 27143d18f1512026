#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest peak of a wheel over the coefficient of friction, with a linear gap and with one of second order.

usage: friction.py PROGRAMS_FOLDER CASE_FOLDER

Sweeps over the peak with each gap and coefficient. Writes speeds.tsv (a line a speed) and friction.tsv (a line a sweep: the
critical speed with its motion, stress, force and power).
"""
import csv
import itertools
import os
import subprocess
import sys

import h5py
import numpy

RPM = 30 / numpy.pi
GAPS = ("linear", "second_order")
COEFFICIENTS = (0, 0.05, 0.1, 0.15, 0.2)  # this wheel jams from 0.246 on
SPEEDS = {"speed_min_rpm": 17400, "speed_max_rpm": 19800, "speed_count": 13}


def simulate(programs, wheel, gap, friction):
    """The speeds of the sweep, as attributes with the tangential motion and the mean force of a blade."""
    output = "response.h5"
    if os.path.exists(output):
        os.remove(output)
    settings = [f'simulate.gap="{gap}"', f"casing.friction_coefficient={friction}", *(f"simulate.{key}={value}" for key, value in SPEEDS.items())]
    words = [word for setting in settings for word in ("--set", setting)]
    case = os.path.join(wheel, "case.toml")
    model, fields = (os.path.join(wheel, name) for name in ("model.h5", "fields.h5"))
    subprocess.run([os.path.join(programs, "tiprub-simulate"), "-q", case, model, "-o", output, *words], check=True)
    subprocess.run([os.path.join(programs, "tiprub-postprocess"), "-q", case, model, output, "--fields", fields, "-o", "report", *words],
                   check=True, stdout=subprocess.DEVNULL)
    speeds = []
    with h5py.File(output) as file:
        for group in file["speed"].values():
            at = dict(group.attrs)
            if at["failure"]:
                continue
            at["rpm"] = at["speed"] * RPM
            at["along"] = numpy.ptp(group["displacement"][..., 1], axis=0).max() / 2
            at["force"] = group["contact_force"][()].sum(axis=2).mean()
            speeds.append(at)
    with open("report/critical_speeds.csv", encoding="utf-8") as table:
        largest = max(csv.DictReader(table), key=lambda row: float(row["amplitude [mm]"]))
    return speeds, largest


def main(programs, wheel):
    with open("speeds.tsv", "w", encoding="utf-8") as by_speed, open("friction.tsv", "w", encoding="utf-8") as by_run:
        by_speed.write("gap\tfriction [1]\tspeed [rpm]\tamplitude [mm]\talong theta [mm]\tmean force of a blade [N]\tmean power [kW]\tsymmetry\n")
        by_run.write("gap\tfriction [1]\tcritical speed [rpm]\tamplitude [mm]\talong theta [mm]\tvibration [MPa]\tmean force of a blade [N]\t"
                     "mean power [kW]\tlargest power [kW]\n")
        for gap, friction in itertools.product(GAPS, COEFFICIENTS):
            speeds, largest = simulate(programs, wheel, gap, friction)
            for at in speeds:
                by_speed.write(f"{gap}\t{friction:g}\t{at['rpm']:.0f}\t{1e3 * at['amplitude']:.4f}\t{1e3 * at['along']:.3f}\t{at['force']:.0f}\t"
                               f"{1e-3 * at.get('rub_power_mean', 0):.0f}\t{at['symmetry'].decode()}\n")
            by_speed.write("\n\n")  # a block of its own for gnuplot
            peak = min(speeds, key=lambda at: abs(at["rpm"] - float(largest["speed [rpm]"])))
            by_run.write(f"{gap}\t{friction:g}\t{peak['rpm']:.0f}\t{1e3 * peak['amplitude']:.4f}\t{1e3 * peak['along']:.3f}\t"
                         f"{float(largest['von Mises, vibration [MPa]']):.0f}\t{peak['force']:.0f}\t"
                         f"{1e-3 * peak.get('rub_power_mean', 0):.0f}\t{1e-3 * peak.get('rub_power_largest', 0):.0f}\n")
            by_run.flush()


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:3]))
