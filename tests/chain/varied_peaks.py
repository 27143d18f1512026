#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The error budget of a small disc. usage: varied_peaks.py PROGRAMS_FOLDER CASES_FOLDER SMALL_CASE WORK_FOLDER (made by small_chain.py)"""
import csv
import json
import math
import os
import re
import subprocess
import sys

import small_chain

# The corner of the tip is inside it with contact at points, and on segments, whose centres lie farther inward.
TIP_PATCH = "postprocess.tip_patch_mm=8.5"


def check_settings(rows):
    """Half the step changes a peak within the step's tolerance. Blades that differ have Whitehead's bound, and the sum is the root
    of the squares of all others."""
    change = "change of amplitude [%]"
    halved = [row for row in rows if row["source"] == "half the time step"]
    bound = [row for row in rows if row["source"] == "blades that differ"]
    assert halved and len(halved) == len(bound), rows
    for row in halved:
        assert 0 < abs(float(row[change])) < 1 and abs(float(row["change of speed [%]"])) < 0.02, row
    for row in bound:
        assert math.isclose(float(row[change]), 100 * ((1 + math.sqrt(6)) / 2 - 1), rel_tol=1e-6), row
    first = rows[:next(i for i, row in enumerate(rows) if row["source"] == "root of the sum of squares") + 1]
    largest = {}
    for row in first[:-1]:
        if row["source"] != "blades that differ":
            source = row["source"].split()[0]
            largest[source] = max(largest.get(source, 0), abs(float(row[change])))
    assert math.isclose(float(first[-1][change]), math.sqrt(sum(x * x for x in largest.values())), rel_tol=1e-6), rows


def check_gap(rows, folder, run):
    """A peak with a gap of second order is what that gap gives at its speed."""
    row = next(row for row in rows if row["source"] == "gap of second order")
    run("simulate", "-o", "curved.h5", *(word for setting in (
        'simulate.gap="second_order"', 'simulate.speeds="given"', 'simulate.examine="none"', f"simulate.speeds_rpm=[{row['speed [rpm]']}]",
        "simulate.step_tolerance=0.01", "simulate.max_revolutions=100") for word in ("--set", setting)))
    run("postprocess", "curved.h5", "-o", "curved")
    found = next(csv.DictReader(folder.read("curved/speeds.csv").decode().splitlines()))
    assert math.isclose(float(found["amplitude [mm]"]), float(row["amplitude [mm]"]), rel_tol=5e-3), (row, found)


def check_model(bench, folder, budget):
    """The peak of another model is that of a sweep with it, and so is its stress; a model that is the same changes nothing."""
    subprocess.run([os.path.join(bench.programs, "tiprub-reduce"), "case.toml", "sector.msh", "-o", "segments.h5", "-q", "--fields",
                    "segments_fields.h5", "--set", 'reduce.contact="segments"'], cwd=folder.path, check=True)

    def row_of(source, *arguments):
        subprocess.run([os.path.join(bench.programs, "tiprub-postprocess"), "case.toml", "model.h5", "models.h5", "-o", "models", "-q",
                        "--fields", "fields.h5", "--set", TIP_PATCH, *arguments], cwd=folder.path, check=True)
        rows = csv.DictReader(folder.read("models/error_budget.csv").decode().splitlines())
        return next(row for row in rows if row["source"] == source)

    for model, fields, source in (("model.h5", "fields.h5", "another model"),
                                  ("segments.h5", "segments_fields.h5", "contact on segments")):
        budget("models", "simulate.budget_damping=[0.02]", f'simulate.budget_model="{model}"')
        row = row_of(source)
        assert row["stress [MPa]"] == "NaN" and float(row["amplitude [mm]"]) > 0, row
        row = row_of(source, "--budget-fields", fields)
        moved, stress = (abs(float(row[f"change of {what} [%]"])) for what in ("speed", "stress"))
        assert moved < 0.05 and stress < 0.1 if model == "model.h5" else moved > 0.05 and stress > 0.1, row
    for response, reason in (("models.h5", "was not written with the model that the error budgets compare with"),
                             ("same.h5", "no error budget of the response compares with another model")):
        refused = subprocess.run([os.path.join(bench.programs, "tiprub-postprocess"), "case.toml", "model.h5", response, "-o", "models", "-q",
                                  "--fields", "fields.h5", "--budget-fields", "fields.h5"], cwd=folder.path, text=True, stderr=subprocess.PIPE)
        assert refused.returncode == 2 and reason in refused.stderr, refused
    speed = float(row["speed [rpm]"])
    subprocess.run([os.path.join(bench.programs, "tiprub-simulate"), "case.toml", "segments.h5", "-o", "segments_response.h5", "-q",
                    *(word for setting in (f"simulate.speeds_rpm=[{0.97 * speed}, {speed}, {1.03 * speed}]", "simulate.step_tolerance=0.01",
                                           "simulate.max_revolutions=100") for word in ("--set", setting))],
                   cwd=folder.path, check=True)
    subprocess.run([os.path.join(bench.programs, "tiprub-postprocess"), "case.toml", "segments.h5", "segments_response.h5", "-o", "alone", "-q",
                    "--fields", "segments_fields.h5", "--set", TIP_PATCH], cwd=folder.path, check=True)
    for table, of_sweep, of_budget in (("speeds", "amplitude [mm]", "amplitude [mm]"),
                                       ("stress_peaks", "von Mises, vibration [MPa]", "stress [MPa]")):
        found = next(found for found in csv.DictReader(folder.read(f"alone/{table}.csv").decode().splitlines())
                     if math.isclose(float(found["speed [rpm]"]), speed))
        assert math.isclose(float(found[of_sweep]), float(row[of_budget]), rel_tol=5e-3), (row, found)


def check_make(bench, folder):
    """make computes the response again after the model has changed that its budgets compare with, and only then. Symptom: a
    model with an absolute path was not watched, and its fields were not passed."""
    for place in (".", folder.path):
        for name, file in (("name_budget_model", "model.h5"), ("name_budget_fields", "fields.h5")):
            said = subprocess.run(["sh", os.path.join(bench.cases, "chain.sh"), name, "case.toml", "--set", 'simulate.budget="largest"',
                                   "--set", f'simulate.budget_model="{place}/model.h5"'], cwd=folder.path, text=True, check=True,
                                  env={**os.environ, "BIN": bench.programs}, stdout=subprocess.PIPE).stdout.strip()
            assert os.path.normpath(os.path.join(folder.path, said)) == folder.file(file), said
    flags = "SIMULATE_FLAGS=--set 'simulate.budget=\"largest\"' --set 'simulate.budget_model=\"segments.h5\"'"
    os.utime(folder.file("segments.h5"), (0, 0))
    folder.must_make(flags)
    assert folder.would_run(flags) == []
    os.utime(folder.file("segments.h5"))
    assert folder.would_run(flags) == ["simulate", "postprocess"]
    os.utime(folder.file("segments.h5"), (1, 1))
    assert folder.would_run(flags) == ["simulate", "postprocess"]


def varied_peaks(bench):
    """A peak that is followed with the case's own damping, and with hardly any friction or change of the clearance, is the peak
    itself; what jams is named."""
    folder = bench.folder("varied")

    def run(program, *arguments):
        subprocess.run([os.path.join(bench.programs, f"tiprub-{program}"), "case.toml", "model.h5", *arguments, "-q"],
                       cwd=folder.path, check=True)

    def budget(name, *settings):
        run("simulate", "-o", f"{name}.h5", *(word for setting in (
            'simulate.speeds="adaptive"', "simulate.step_tolerance=0.01", "simulate.max_revolutions=100",
            'simulate.budget="critical_speeds"', *settings) for word in ("--set", setting)))
        run("postprocess", f"{name}.h5", "-o", name, "--fields", "fields.h5")
        return list(csv.DictReader(folder.read(f"{name}/error_budget.csv").decode().splitlines()))

    rows = budget("same", "simulate.budget_damping=[0.02]", "simulate.budget_clearance=1e-9", "simulate.budget_friction=1e-9")
    varied = [row for row in rows if row["source"].split()[0] in ("friction", "damping", "clearance")]
    assert len(varied) == 4, rows
    for row in varied:
        assert abs(float(row["change of speed [%]"])) < 0.05, row
        assert all(abs(float(row[f"change of {what} [%]"])) < 0.1 for what in ("amplitude", "|u|", "stress")), row
    check_settings(rows)
    check_gap(rows, folder, run)
    check_model(bench, folder, budget)
    check_make(bench, folder)
    rows = budget("other", "simulate.budget_damping=[0.01]", "simulate.budget_friction=5")
    found = {row["source"]: row for row in rows}
    assert float(found["damping 0.01"]["change of amplitude [%]"]) > 5, rows
    assert "jams" in found["friction 5"]["motion"], rows
    trust = json.loads(folder.read("other/summary.json"))["verdict"]["Trust"].split("\n")
    assert "data and physics leave" in trust[0], trust
    opened = [float(re.search(r"uncertain by (\S+) %, most by", line)[1]) for line in trust if line.startswith("Budget: ")]
    assert len(opened) >= 3 and opened == sorted(opened, reverse=True), trust


if __name__ == "__main__":
    small_chain.STEPS += (varied_peaks,)
    small_chain.main("varied_peaks", *sys.argv[1:])
