#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what a case publishes, from its report into expected/: tables, pictures, and the numbers that its page quotes.

usage: publish.py PROGRAMS_FOLDER CASE_FOLDER

numbers.tsv names the version and the commit of the programs, and the day. The commit ends with "+" if files differed from it. Of a study,
which has no case of its own, tables and pictures are copied, of its report those that expected/ holds already, and version_numbers.tsv
names the same.
"""
import csv
import datetime
import math
import os
import shutil
import subprocess
import sys

import h5py
import numpy

from fill_pages import rounded

PICTURES = {"interaction_map_leading_edge": "interaction_map", **{name: name for name in (
    "error_budget", "interaction_map_trailing_edge", "interaction_map_parts", "campbell", "contact_map_leading_edge", "contact_map_trailing_edge", "branches")}}
TABLES = ("critical_speeds.txt", "error_budget.csv", "scene_needs.csv", "exactness.csv", "linear_rules.csv", "branches.csv", "sweeps.csv")
MOTIONS = ("periodic", "subharmonic", "modulated", "broadband", "not settled")


def rows_of(path):
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def number(row, column, form):
    """The rounded value of a cell; empty if the cell is, or if it is no number."""
    value = float(row.get(column) or "nan")
    return "" if numpy.isnan(value) else rounded(value, form)


def percent(row, column):
    return f"{100 * float(row[column]):.0f} %"


def version_of(programs):
    version = subprocess.run([os.path.join(programs, "tiprub-simulate"), "--version"], text=True, check=True, stdout=subprocess.PIPE).stdout
    here = os.path.dirname(os.path.abspath(__file__))
    git = ["git", "-C", here]
    commit = subprocess.run([*git, "rev-parse", "--short", "HEAD"], text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout.strip()
    changed = commit and subprocess.run([*git, "diff", "--quiet", "HEAD", "--", "../mesh", "../reduce", "../simulate", "../postprocess"],
                                        cwd=here).returncode
    return {"version": version.split()[-1], "commit": commit + ("+" if changed else ""), "date": datetime.date.today().isoformat()}


def seen(row):
    """The motion of the whole wheel, where the symmetric one is not clearly stable; |u| [mm] of its blades: least, median, largest."""
    sizes = [number(row, f"tip |u| of the whole wheel, {which} of the blades [mm]", ".2f") for which in ("least", "median", "largest")]
    return f"{row['motion of the whole wheel']}, {' / '.join(sizes)} mm" if row["motion of the whole wheel"] else ""


def peak_line(row):
    """A line of critical_speeds.tsv."""
    return {"speed [rpm]": number(row, "speed [rpm]", ".0f"),
            "between [rpm]": number(row, "speed low [rpm]", ".0f") + " and " + number(row, "speed high [rpm]", ".0f"),
            "tip |u| [mm]": number(row, "tip |u| [mm]", ".2f"), "stress of the vibration [MPa]": number(row, "von Mises, vibration [MPa]", ".0f"),
            "Goodman": number(row, "Goodman utilisation [1]", ".2f"), "along the normal [mm]": number(row, "amplitude [mm]", ".3f"),
            "wave": row["wave"], "share": percent(row, "wave share [1]"), "motion": row["motion"], "seen on the whole wheel": seen(row),
            "from other starts": row["motions from other starts"]}


def changes(row):
    columns = {"change of speed [%]": "change of speed [%]", "of |u| [%]": "change of |u| [%]", "of the stress [%]": "change of stress [%]"}
    return {name: number(row, column, "+.1f") for name, column in columns.items()}


def budget_line(row):
    """A line of budget.tsv. The sum of all sources is a change, and no speed."""
    speed = "" if row["source"].startswith("root of") else number(row, "speed [rpm]", ",.0f")
    return {"source": row["source"], "critical speed [rpm]": speed, **changes(row)}


def other_model_lines(rows):
    """The lines of other_model.tsv: what the model that error budgets compare with changes at each critical speed."""
    return [{"critical speed [rpm]": number(row, "critical speed [rpm]", ",.0f"), "with the other model [rpm]": number(row, "speed [rpm]", ",.0f") or "not found",
             **changes(row)} for row in rows if row["source"].startswith("model of")]


def is_within_the_rest(rows):
    """Whether the other model changes a critical speed, its |u| and its stress by no more than all other sources together."""
    other, together = (next(row for row in rows if row["source"].startswith(start)) for start in ("model of", "root of"))
    is_summed = not other["motion"].endswith("not in the sum")

    def is_within(column):
        change = float(other[column])
        return abs(change) <= math.sqrt(max(float(together[column])**2 - is_summed * change**2, 0))

    return all(map(is_within, ("change of speed [%]", "change of |u| [%]", "change of stress [%]")))


def moves_most(rows, column):
    """The source that changes a column most, by how much, and the larger peak that this one joins. What is not in
    the sum, and the sum itself, are no sources."""
    sources = [row for row in rows if number(row, column, ".1f") and not row["source"].startswith("root of") and not row["motion"].endswith("not in the sum")]
    if not sources:
        return ""
    most = max(sources, key=lambda row: abs(float(row[column])))
    joined = number(most, "joins the peak of [rpm]", ",.0f")
    return f"{most['source']}: {number(most, column, '+.1f')} %" + (f", joins {joined} rpm" if joined else "")


def budgets_line(rows):
    """A line of budgets.tsv, from the rows of a critical speed in error_budget.csv."""
    columns = {"the speed": "change of speed [%]", "|u|": "change of |u| [%]", "the stress": "change of stress [%]"}
    together = next(row for row in rows if row["source"].startswith("root of"))
    return {"critical speed [rpm]": number(rows[0], "critical speed [rpm]", ",.0f"),
            "all sources: speed, |u|, stress [%]": ", ".join(number(together, column, ".1f") for column in columns.values())
            + together["motion"].replace("without", "; no such peak with"),
            **{f"moves {name} most": moves_most(rows, column) for name, column in columns.items()}}


def write_table(path, lines):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, list(lines[0]), delimiter="\t", lineterminator="\n")
        writer.writeheader()
        writer.writerows(lines)


def of_sweep(folder):
    """Numbers of all speeds, and how many of them symmetry does not describe."""
    speeds = [row for row in rows_of(os.path.join(folder, "report", "speeds.csv")) if not row["failure"]]
    kinds = [row["motion"] for row in speeds]
    found = {"speeds": str(len(speeds)), "range": f"{number(speeds[0], 'speed [rpm]', ',.0f')} to {number(speeds[-1], 'speed [rpm]', ',.0f')}",
             **{kind.replace(" ", "_"): str(sum(name.startswith(kind) for name in kinds)) for kind in MOTIONS},
             "unstable": str(sum(row.get("symmetry") == "breaking" for row in speeds))}
    unsettled = next((row for row in rows_of(os.path.join(folder, "report", "exactness.csv")) if row["check"].startswith("unsettled motion")), None)
    if unsettled:
        found["unsettled"] = unsettled["speeds beyond the limit"]
    outside = [row for row in rows_of(os.path.join(folder, "report", "critical_speeds.csv")) if row["outside validity"]]
    return found | {"outside": str(len(outside))}


def of_model(folder):
    with h5py.File(os.path.join(folder, "model.h5")) as model:
        rest = numpy.array([block["unreduced"][0, 0] for block in model["verification/nodal_diameter"].values()]) if "verification" in model else []
    return {"first_hz": f"{min(rest):.0f} to {max(rest):.0f}"} if len(rest) else {}


def of_branches(folder):
    """The speeds of the folds of all branches."""
    with h5py.File(os.path.join(folder, "response.h5")) as response:
        branches = response["branch"].values() if "branch" in response else []
        folds = sorted(30 / numpy.pi * speed for branch in branches if "fold" in branch for speed in branch["fold"][:])
    return {f"fold.{place}": rounded(speed, ",.0f") for place, speed in enumerate(folds, 1)}


def of_largest(rows):
    """Numbers of the critical speed with the largest motion of the tip."""
    row = max(rows, key=lambda row: float(row["tip |u| [mm]"]))
    return {"largest.rpm": number(row, "speed [rpm]", ",.0f"), "largest.u_mm": number(row, "tip |u| [mm]", ".1f"),
            "largest.normal_mm": number(row, "amplitude [mm]", ".2f"), "largest.wave": row["wave"],
            "largest.share": percent(row, "wave share [1]"), "largest.mpa": number(row, "von Mises, vibration [MPa]", ",.0f"),
            "largest.goodman": number(row, "Goodman utilisation [1]", ".2f"), "largest.spin_mpa": number(row, "von Mises, spin [MPa]", ",.0f")}


def write_numbers(path, numbers):
    write_table(path, [{"key": key, "value": value} for key, value in numbers.items()])


def publish_study(programs, folder, expected):
    for name in os.listdir(folder):
        if os.path.splitext(name)[1] in (".tsv", ".csv", ".svg", ".png"):
            shutil.copy(os.path.join(folder, name), expected)
    for name in os.listdir(expected):
        of_report = os.path.join(folder, "report", name)
        if os.path.exists(of_report):
            shutil.copy(of_report, expected)
    write_numbers(os.path.join(expected, "version_numbers.tsv"), version_of(programs))


def publish_case(programs, folder, expected):
    report = os.path.join(folder, "report")
    critical, rules = rows_of(os.path.join(report, "critical_speeds.csv")), rows_of(os.path.join(report, "linear_rules.csv"))
    numbers = {**version_of(programs), **of_model(folder), **of_sweep(folder), **of_branches(folder), "critical": str(len(critical)),
               **({} if not critical else of_largest(critical)),
               **{f"rule.{row['rule'].split()[-1].strip('.')}.{key}": row[column] for row in rules
                  for key, column in (("missed", "missed"), ("false", "false alarms"))}}
    if critical:
        write_table(os.path.join(expected, "critical_speeds.tsv"), [peak_line(row) for row in critical])
    budget = rows_of(os.path.join(report, "error_budget.csv"))
    if budget:
        by_peak = {}
        for row in budget:
            by_peak.setdefault(row["critical speed [rpm]"], []).append(row)
        largest = max(by_peak.values(), key=lambda rows: float(rows[0]["tip |u| [mm]"]))
        write_table(os.path.join(expected, "budget.tsv"), [budget_line(row) for row in largest])
        write_table(os.path.join(expected, "budgets.tsv"), [budgets_line(rows) for rows in by_peak.values()])
        other_model = other_model_lines(budget)
        if other_model:
            write_table(os.path.join(expected, "other_model.tsv"), other_model)
            numbers["other_model.inside"] = f"{sum(map(is_within_the_rest, by_peak.values()))} of {len(by_peak)}"
    write_numbers(os.path.join(expected, "numbers.tsv"), numbers)
    copies = {**{name: name for name in TABLES}, **{f"figures/{name}.png": f"{copy}.png" for name, copy in PICTURES.items()}}
    for name, copy in copies.items():
        if os.path.exists(os.path.join(report, name)):
            shutil.copy(os.path.join(report, name), os.path.join(expected, copy))


def main(programs, folder):
    expected = os.path.join(folder, "expected")
    os.makedirs(expected, exist_ok=True)
    is_case = os.path.exists(os.path.join(folder, "case.toml"))  # a study may hold the report of its last run
    (publish_case if is_case else publish_study)(programs, folder, expected)


if __name__ == "__main__":
    main(*sys.argv[1:3])
