#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A sweep over speeds that are too far apart never says more than a fine one knows.

usage: coarse_grids.py PROGRAMS_FOLDER CASE.toml [MODEL.h5] WORK_FOLDER

Without a model: a small disc, made here, over 12 speeds. With one: that of cases/impeller_quick, in its casing with 0.19 and 0.18 mm
of clearance, over 27 speeds. Each is swept over these speeds alone, then as the case says by default, and both reports are compared;
the fine one, in turn, with single speeds one revolution a minute apart around its worst peak.
"""
import csv
import math
import os
import re
import subprocess
import sys

try:
    import h5py
except ImportError:
    print("SKIPPED: needs python3-h5py")
    sys.exit(77)

RPM = 30 / math.pi
AROUND = 8  # [rpm] on each side of a peak
GIVEN = 'speeds_rpm = [20000, 24000, 27000, 30000]\nspeeds = "given"\n'
RANGE = "speed_min_rpm = 9000\nspeed_max_rpm = 20000\nspeed_count = 12\n"
SMALL = ["simulate.damping_ratio=0.005", "simulate.step_tolerance=5e-3", "simulate.max_revolutions=200"]
DEMO = ["simulate.speed_count=27", "casing.clearance=[[0.0, 0.19e-3], [1.0, 0.18e-3]]"]


class Report:
    """The tables of a report, and what was printed."""

    def __init__(self, folder, printed):
        self.folder, self.printed = folder, printed
        self.peaks = self.rows("critical_speeds.csv")
        self.checks = {row["check"].split(":")[0]: row["passed"] for row in self.rows("exactness.csv")}
        with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
            self.page = file.read()

    def rows(self, name):
        with open(os.path.join(self.folder, name), encoding="utf-8", newline="") as file:
            return list(csv.DictReader(file))

    @property
    def passed(self):
        return sum(row["passed"] == "yes" for row in self.rows("exactness.csv"))


class Chain:
    def __init__(self, programs, case, work, settings):
        self.programs, self.case, self.work = os.path.abspath(programs), os.path.abspath(case), work
        self.settings = settings
        os.makedirs(work, exist_ok=True)
        self.model = os.path.join(work, "model.h5")

    def run(self, program, *words):
        done = subprocess.run([os.path.join(self.programs, program), self.case, "-q", *words], stdout=subprocess.PIPE, text=True,
                              check=True)
        return done.stdout

    def make_model(self):
        """Of the small disc, over a range of speeds."""
        with open(self.case, encoding="utf-8") as file:
            text = file.read()
        assert GIVEN in text
        self.case = os.path.join(self.work, "case.toml")
        with open(self.case, "w", encoding="utf-8") as file:
            file.write(text.replace(GIVEN, RANGE))
        sector = os.path.join(self.work, "sector.msh")
        self.run("tiprub-mesh", "-o", sector)
        self.run("tiprub-reduce", sector, "-o", self.model)

    def response(self, name, *settings):
        path = os.path.join(self.work, name + ".h5")
        self.run("tiprub-simulate", self.model, "-o", path, *self.set(*settings))
        return path

    def report(self, name, *settings):
        path, folder = self.response(name, *settings), os.path.join(self.work, name)
        return Report(folder, self.run("tiprub-postprocess", self.model, path, "-o", folder, *self.set(*settings)))

    def set(self, *settings):
        return [word for setting in (*self.settings, *settings) for word in ("--set", setting)]


def value(row, column):
    return float(row[column])


def holds_more_than_it_says(coarse, fine):
    """What the coarse report says of speed and amplitude is no narrower than the fine one's answer, and its marks are no better."""
    assert coarse.printed.startswith("Not trustworthy. The speeds are too far apart"), coarse.printed
    assert "<dt>Not trustworthy</dt>" in coarse.page and "<dt>Not trustworthy</dt>" not in fine.page
    assert coarse.page.index("<dt>Not trustworthy</dt>") < coarse.page.index("<dt>How bad</dt>")
    for check in ("speeds beside each peak", "speeds over the range"):
        assert coarse.checks[check] == "no" and fine.checks[check] == "yes", check
    assert coarse.passed <= fine.passed, (coarse.passed, fine.passed)
    for text in re.findall(r"Goodman's rule[^.]*\.\d\d[^.;]*", coarse.page):
        assert "not trustworthy" in text, text
    motions = [(value(row, "speed [rpm]"), value(row, "amplitude [mm]")) for row in fine.rows("speeds.csv")]
    for row in coarse.peaks:
        low, high = value(row, "speed low [rpm]"), value(row, "speed high [rpm]")
        inside = [amplitude for rpm, amplitude in motions if low <= rpm <= high]
        top = max(inside)
        assert top not in (inside[0], inside[-1]), f"the fine response has no peak within {low:.0f} .. {high:.0f} rpm"
        print(f"coarse {value(row, 'speed [rpm]'):.0f} rpm in {low:.0f} .. {high:.0f}, {value(row, 'amplitude [mm]'):.4f} to "
              f"{value(row, 'amplitude high [mm]'):.4f} mm; fine {top:.4f} mm")
        assert top <= value(row, "amplitude high [mm]")


def covers_a_sweep_of_single_speeds(chain, peak):
    """The highest of single speeds around a peak stands within its interval, and within its amplitude."""
    rpm = value(peak, "speed [rpm]")
    response = chain.response("single", f"simulate.speed_min_rpm={round(rpm) - AROUND}", f"simulate.speed_max_rpm={round(rpm) + AROUND}",
                              f"simulate.speed_count={2 * AROUND + 1}", 'simulate.speeds="given"', 'simulate.examine="none"')
    with h5py.File(response) as file:
        amplitude, speed = max((1e3 * group.attrs["amplitude"], group.attrs["speed"] * RPM) for group in file["speed"].values())
    print(f"{rpm:.1f} rpm {value(peak, 'amplitude [mm]'):.5f} mm, up to {value(peak, 'amplitude high [mm]'):.5f}; single speeds: "
          f"{speed:.0f} rpm {amplitude:.5f} mm")
    assert value(peak, "speed low [rpm]") <= speed <= value(peak, "speed high [rpm]")
    assert amplitude <= value(peak, "amplitude high [mm]")


def main(programs, case, *rest):
    *model, work = rest
    chain = Chain(programs, case, work, DEMO if model else SMALL)
    if model:
        chain.model = model[0]
    else:
        chain.make_model()
    coarse, fine = chain.report("coarse", 'simulate.speeds="given"'), chain.report("fine", 'simulate.speeds="adaptive"')
    holds_more_than_it_says(coarse, fine)
    covers_a_sweep_of_single_speeds(chain, max(fine.peaks, key=lambda row: value(row, "amplitude [mm]")))


if __name__ == "__main__":
    main(*sys.argv[1:])
