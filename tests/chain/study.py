#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A study of a small disc: shared models, single points beside each other, one table, and what is refused.

usage: study.py PROGRAMS_FOLDER CASES_FOLDER SMALL_CASE WORK_FOLDER
"""
import csv
import glob
import os
import shutil
import subprocess
import sys

STUDY = """
title = "Small <study>"
case = "small_disc.toml"
[settings]
"mesh.elements_along_span" = 4
"mesh.elements_along_chord" = 3
"postprocess.prominence" = 0.001
[grid.clearance]
key = "casing.clearance"
unit = "mm"
values = {"0.13" = [[0.0, 0.13e-3]], "0.12" = [[0.0, 0.12e-3]]}
[points.heavy]
"reduce.density" = 5000
"casing.lobes" = 3
"""
# What is put in, and what is said of it.
WRONG = (('"casing.lobes" = 3', '"casing.lobs" = 3', "point heavy: ", 'unknown key "lobs"'),
         ('"casing.lobes" = 3', 'lobes = 3', '[points.heavy]: "lobes" must be TABLE.KEY of a case'),
         ('"casing.lobes" = 3', '"casing.lobes" = inf', "casing.lobes = inf must be a number"),
         ('"casing.lobes" = 3', '"casing.lobes" = 2026-01-01', "must be a number"),
         ('{"0.13"', '{"../0.13"', '[grid.clearance]: "../0.13" names a folder'),
         ('key = "casing.clearance"', 'keys = "casing.clearance"', '[grid.clearance]: unknown key "keys"; known: key, values, unit'),
         ('case = "small_disc.toml"', '', "needs case ="),
         ('[settings]', '[setings]', 'unknown key "setings"'),
         ('"postprocess.prominence" = 0.001', "\"postprocess.response_up\" = \"response_up.h5\"", "response_up and response_down lie beside a case"),
         ('title =', 'title', "study.toml: "))


class Bench:
    def __init__(self, programs, cases, case, work):
        self.programs, self.work = programs, work
        shutil.rmtree(work, ignore_errors=True)
        os.makedirs(work)
        shutil.copy(case, work)
        self.write("Makefile", f"include {cases}/study/study.mk\n")
        self.write("study.toml", STUDY)
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}

    def write(self, name, text):
        with open(os.path.join(self.work, name), "w", encoding="utf-8") as file:
            file.write(text)

    def start(self, *arguments):
        return subprocess.Popen(["make", *arguments, f"BIN={self.programs}"], cwd=self.work, env=self.environment, text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT)

    def make(self, *arguments):
        run = self.start(*arguments)
        return run.communicate()[0], run.returncode

    def must_make(self, *arguments):
        said, code = self.make(*arguments)
        assert code == 0, said
        return said

    def rows(self, name):
        with open(os.path.join(self.work, name), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))


def points_at_once(bench):
    """As the tasks of a job array: each makes its point, one of them the model, the other waits for it."""
    assert "3 points, 2 models, 1 meshes" in bench.must_make("runs")
    both = [bench.start("-C", "runs", "point", f"INDEX={index}") for index in (1, 2)]
    said = [run.communicate()[0] for run in both]
    assert all(run.returncode == 0 for run in both), said
    assert sum(text.count("wrote sector.msh") for text in said) == 1 and sum(text.count("tiprub-reduce: model.h5") for text in said) == 1, said
    bench.must_make("table")
    with open(os.path.join(bench.work, "report", "study.txt"), encoding="utf-8") as file:
        assert [line.split()[0] for line in file if "no report" in line] == ["heavy"]


def table_and_page(bench):
    said = bench.must_make("-j2")
    assert "points/heavy" not in said.split("study")[0] and "clearance_0.12" in said, said
    assert len(glob.glob(os.path.join(bench.work, "runs", "models", "*", "model.h5"))) == 2
    joint, expected = bench.rows("report/study.csv"), []
    for point, clearance in (("clearance_0.13", "0.13"), ("clearance_0.12", "0.12"), ("heavy", "")):
        expected += [{"point": point, "clearance [mm]": clearance, **row} for row in bench.rows(f"runs/points/{point}/report/critical_speeds.csv")]
    assert joint == expected and {row["point"] for row in joint} >= {"clearance_0.13", "heavy"}, (joint, expected)
    with open(os.path.join(bench.work, "report", "study.html"), encoding="utf-8") as file:
        page = file.read()
    assert "Small &lt;study&gt;" in page and "3 of 3 points" in page and page.count("<svg") == 2, page[:2000]
    assert 'name="viewport"' in page and page.count('scope="col"') == 7 and page.count('role="img"') == 2, page[:2000]
    assert 'href="../runs/points/heavy/report/report.html"' in page and "http://" not in page.replace("http://www.w3.org", "")


def only_what_changed(bench):
    bench.write("study.toml", STUDY.replace("0.12e-3", "0.11e-3"))
    said = bench.must_make()
    assert said.count("tiprub-simulate ") == 1 and "casing.clearance=[[0.0, 0.00011]]" in said and "tiprub-reduce" not in said, said


def refusals(bench):
    for before, after, *phrases in WRONG:
        assert before in STUDY
        bench.write("study.toml", STUDY.replace(before, after))
        said, code = bench.make("runs")
        assert code != 0 and all(phrase in said for phrase in phrases) and "Traceback" not in said, (after, said)


def main(*arguments):
    bench = Bench(*map(os.path.abspath, arguments))
    for step in (points_at_once, table_and_page, only_what_changed, refusals):
        step(bench)


if __name__ == "__main__":
    main(*sys.argv[1:])
