#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What cases/publish.py writes of a report, and cases/fill_pages.py into a page.

usage: publish.py PROGRAMS_FOLDER CASES_FOLDER MADE_FOLDER WORK_FOLDER

MADE_FOLDER is a case that make has made.
"""
import csv
import os
import shutil
import subprocess
import sys

PAGE = "Of <!-- speeds -->0<!----> speeds, the largest at <!-- largest.rpm -->0<!----> rpm:\n\n<!-- critical_speeds.tsv -->\n<!---->\n"


def rows_of(path, delimiter=","):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file, delimiter=delimiter))


def fill(work, *options):
    return subprocess.run([sys.executable, "-B", os.path.join(work, "fill_pages.py"), *options], text=True, stderr=subprocess.PIPE)


def main(programs, cases, made, work):
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(made, os.path.join(work, "wheel"), symlinks=True)
    shutil.copy(os.path.join(cases, "fill_pages.py"), work)
    wheel = os.path.join(work, "wheel")
    subprocess.run([sys.executable, "-B", os.path.join(cases, "publish.py"), programs, wheel], check=True)
    expected, report = os.path.join(wheel, "expected"), os.path.join(wheel, "report")
    numbers = {row["key"]: row["value"] for row in rows_of(os.path.join(expected, "numbers.tsv"), "\t")}
    critical = rows_of(os.path.join(report, "critical_speeds.csv"))
    table = rows_of(os.path.join(expected, "critical_speeds.tsv"), "\t")
    assert critical and [row["speed [rpm]"] for row in table] == [f"{float(row['speed [rpm]']):.0f}" for row in critical]
    assert numbers["speeds"] == str(len(rows_of(os.path.join(report, "speeds.csv")))) and numbers["version"].count(".") == 2, numbers
    largest = max(critical, key=lambda row: float(row["tip |u| [mm]"]))
    assert numbers["largest.rpm"] == f"{float(largest['speed [rpm]']):,.0f}", numbers

    page = os.path.join(wheel, "README.md")
    with open(page, "w", encoding="utf-8") as file:
        file.write(PAGE)
    assert "wheel/README.md: differs from the tables" in fill(work, "--check").stderr
    assert fill(work).returncode == 0 and fill(work, "--check").returncode == 0
    with open(page, encoding="utf-8") as file:
        text = file.read()
    assert f"Of <!-- speeds -->{numbers['speeds']}<!----> speeds" in text and table[0]["wave"] in text, text


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
