#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What cases/publish.py writes of a report, and cases/fill_pages.py into a page.

usage: publish.py PROGRAMS_FOLDER CASES_FOLDER MADE_FOLDER WORK_FOLDER

MADE_FOLDER is a case that make has made.
"""
import csv
import os
import re
import shutil
import subprocess
import sys

PAGE = "Of <!-- speeds -->0<!----> speeds, the largest at <!-- largest.rpm -->0<!----> rpm:\n\n<!-- critical_speeds.tsv -->\n<!---->\n"
BUDGET = """critical speed [rpm],source,speed [rpm],change of speed [%],tip |u| [mm],change of |u| [%],stress [MPa],change of stress [%]
9000.1,as computed,9000.1,0,2.5,0,1200,0
9000.1,friction 0.1,8910.1,-1,2.25,-10,1199,-0.04
9900.2,as computed,9900.2,0,0.5,0,90,0
9900.2,friction 0.1,9999.2,1,1.0,100,99,10
"""
BUDGET_PAGE = "With friction" + "".join(f" <!-- budget:{key} -->0<!---->" for key in (
    "largest:friction_0.1:u", "1:friction_0.1:stress", "2:friction_0.1:rpm", "2:as_computed:u_mm"))


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
    fills_from_the_budget(work, page, expected)
    publishes_a_study(programs, cases, work, report)
    counts_what_the_other_model_changes(cases)


def publishes_a_study(programs, cases, work, report):
    """Symptom: a study that left the report of its last run was taken for a case without a model."""
    study = os.path.join(work, "study")
    shutil.copytree(report, os.path.join(study, "report"))
    with open(os.path.join(study, "peaks.tsv"), "w", encoding="utf-8") as file:
        file.write("speed\n9000\n")
    os.mkdir(os.path.join(study, "expected"))
    stale = os.path.join(study, "expected", "speeds.csv")
    with open(stale, "w", encoding="utf-8") as file:
        file.write("of the report before\n")
    subprocess.run([sys.executable, "-B", os.path.join(cases, "publish.py"), programs, study], check=True)
    assert sorted(os.listdir(os.path.join(study, "expected"))) == ["peaks.tsv", "speeds.csv", "version_numbers.tsv"]
    assert rows_of(stale) == rows_of(os.path.join(report, "speeds.csv"))


def counts_what_the_other_model_changes(cases):
    """It changes less than all other sources together, more, more without being in the sum, and there is no such peak."""
    sys.path.insert(0, cases)
    from publish import is_within_the_rest
    columns = ("change of speed [%]", "change of |u| [%]", "change of stress [%]")

    def is_within(stress, motion="periodic"):
        return is_within_the_rest([{"source": "model of 28 segments", "motion": motion, **dict(zip(columns, ("-1", "3", stress)))},
                                   {"source": "root of the sum of squares", "motion": "", **dict(zip(columns, ("2", "5", "5")))}])

    assert is_within("3.5") and not is_within("-3.6") and is_within("-3.6", "modulated; not in the sum") and not is_within("NaN")


def fills_from_the_budget(work, page, expected):
    for path, text in ((os.path.join(expected, "error_budget.csv"), BUDGET), (page, BUDGET_PAGE)):
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    assert fill(work).returncode == 0
    with open(page, encoding="utf-8") as file:
        text = file.read()
    assert re.findall(r"-->([^<]+)<!---->", text) == ["-10", "0", "9,999", "0.50"], text
    with open(page, "w", encoding="utf-8") as file:
        file.write(BUDGET_PAGE.replace("friction_0.1", "friction_0.2"))
    assert "the cell budget:largest:friction_0.2:u stands in no table" in fill(work).stderr


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
