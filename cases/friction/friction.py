#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest peak of a wheel over the coefficient of friction, with a linear gap and with one of second order.

usage: friction.py PROGRAMS_FOLDER CASE_FOLDER MODEL_FOLDER

Sweeps over the peak with each gap and coefficient. With the name of the case's folder, it writes NAME_speeds.tsv (a line a
speed) and NAME.tsv (a line a sweep: the critical speed with its motion, stress, force and power).
"""
import csv
import os
import subprocess
import sys

import h5py
import numpy

RPM = 30 / numpy.pi
COEFFICIENTS = {"linear": (0, 0.05, 0.1, 0.15, 0.2, 0.25), "second_order": (0, 0.05, 0.1, 0.15, 0.2)}  # by gap
JAMS_FROM = {"impeller_quick": 0.246, "cc3": 0.291}
SPEEDS = {"impeller_quick": (17400, 19800, 13), "cc3": (18400, 21200, 15)}  # rev/min


def excursion(displacement):
    """The largest distance of a contact node from its mean place, in all directions together."""
    return numpy.linalg.norm(displacement - displacement.mean(axis=0), axis=-1).max()


def simulate(programs, wheel, models, gap, friction):
    """The speeds of the sweep, as attributes with the motion in all directions and the mean force of a blade."""
    output = "response.h5"
    if os.path.exists(output):
        os.remove(output)
    speeds = zip(("speed_min_rpm", "speed_max_rpm", "speed_count"), SPEEDS[os.path.basename(wheel)])
    settings = [f'simulate.gap="{gap}"', f"casing.friction_coefficient={friction}", 'simulate.budget="none"',
                *(f"simulate.{key}={value}" for key, value in speeds)]
    words = [word for setting in settings for word in ("--set", setting)]
    case = os.path.join(wheel, "case.toml")
    model, fields = (os.path.join(models, name) for name in ("model.h5", "fields.h5"))
    subprocess.run([os.path.join(programs, "tiprub-simulate"), "-q", case, model, "-o", output, *words], check=True)
    subprocess.run([os.path.join(programs, "tiprub-postprocess"), "-q", case, model, output, "--fields", fields, "-o", "report", *words],
                   check=True, stdout=subprocess.DEVNULL)
    swept = []
    with h5py.File(output) as file:
        for group in file["speed"].values():
            at = dict(group.attrs)
            if at["failure"]:
                continue
            at["rpm"] = at["speed"] * RPM
            at["excursion"] = excursion(group["displacement"][()])
            at["force"] = group["contact_force"][()].sum(axis=2).mean()
            swept.append(at)
    with open("report/critical_speeds.csv", encoding="utf-8") as table:
        largest = max(csv.DictReader(table), key=lambda row: float(row["amplitude [mm]"]))
    return swept, largest


def main(programs, wheel, models):
    name = os.path.basename(wheel)
    with open(f"{name}_speeds.tsv", "w", encoding="utf-8") as by_speed, open(f"{name}.tsv.part", "w", encoding="utf-8") as by_run:
        by_speed.write("gap\tfriction [1]\tspeed [rpm]\tamplitude [mm]\ttip |u| [mm]\tmean force of a blade [N]\tmean power [kW]\tsymmetry\n")
        by_run.write("gap\tfriction [1]\tcritical speed [rpm]\tamplitude [mm]\ttip |u| [mm]\tvibration [MPa]\tmean force of a blade [N]\t"
                     "mean power [kW]\tlargest power [kW]\n")
        for gap, friction in ((gap, friction) for gap, values in COEFFICIENTS.items() for friction in values if friction < JAMS_FROM[name]):
            speeds, largest = simulate(programs, wheel, models, gap, friction)
            for at in speeds:
                by_speed.write(f"{gap}\t{friction:g}\t{at['rpm']:.0f}\t{1e3 * at['amplitude']:.4f}\t{1e3 * at['excursion']:.3f}\t{at['force']:.0f}\t"
                               f"{1e-3 * at.get('rub_power_mean', 0):.0f}\t{at['symmetry'].decode()}\n")
            by_speed.write("\n\n")  # a block of its own for gnuplot
            peak = min(speeds, key=lambda at: abs(at["rpm"] - float(largest["speed [rpm]"])))
            by_run.write(f"{gap}\t{friction:g}\t{peak['rpm']:.0f}\t{1e3 * peak['amplitude']:.4f}\t{1e3 * peak['excursion']:.3f}\t"
                         f"{float(largest['von Mises, vibration [MPa]']):.0f}\t{peak['force']:.0f}\t"
                         f"{1e-3 * peak.get('rub_power_mean', 0):.0f}\t{1e-3 * peak.get('rub_power_largest', 0):.0f}\n")
            by_run.flush()
    os.replace(f"{name}.tsv.part", f"{name}.tsv")  # make goes by this table


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:4]))
