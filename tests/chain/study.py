#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A study of a small disc: shared models, single points beside each other, one table, and what is refused.

usage: study.py PROGRAMS_FOLDER CASES_FOLDER SMALL_CASE WORK_FOLDER
"""
import csv
import glob
import os
import random
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
"simulate.speeds" = "adaptive"
[grid.clearance]
key = "casing.clearance"
unit = "mm"
values = {"0.13" = [[0.0, 0.13e-3]], "0.12" = [[0.0, 0.12e-3]]}
[points.heavy]
"reduce.density" = 5000
"casing.lobes" = 3
"""
HEAVY = '[points.heavy]\n"casing.lobes" = 3\n'
# What is put in, and what is said of it.
WRONG = (('"casing.lobes" = 3', '"casing.lobs" = 3', "point heavy: ", 'unknown key "lobs"'),
         ('"casing.lobes" = 3', 'lobes = 3', "[points.heavy]: 'lobes' must be TABLE.KEY of a case"),
         ('"casing.lobes" = 3', '"casing.lobes" = inf', "casing.lobes = inf must be a number"),
         ('"casing.lobes" = 3', '"casing.lobes" = 2026-01-01', "must be a number"),
         ('{"0.13"', '{"../0.13"', "[grid.clearance]: '../0.13' names a folder"),
         ('{"0.13"', f'{{"{300 * "9"}"', "has a name of 310 letters; that of a folder may have 200"),
         ('"casing.lobes" = 3', '"casing.shape" = "\\u2028cosine"', "must be a number, a text of one line"),
         ('[grid.clearance]', '[grid."x$(shell touch ran)"]', "[grid]: 'x$(shell touch ran)' names a folder; use letters, digits and ._+-"),
         ('[grid.clearance]', '[grid."../../../evil"]', "[grid]: '../../../evil' names a folder"),
         ('[grid.clearance]', '[grid."g<img src=x onerror=alert(2)>"]', "names a folder"),
         ('[points.heavy]', '[points.".."]', "[points]: '..' names a folder"),
         ('[points.heavy]', '[points."clearance_0.12"]', "two points have the name clearance_0.12"),
         ('case = "small_disc.toml"', 'case = "small_disc.toml"\nmodel = "m.h5;touch ran"', "must name a file by letters"),
         ('case = "small_disc.toml"', 'case = "small_disc.toml\\n$(shell touch ran)"', "must be a text of one line"),
         ('unit = "mm"', 'unit = "mm\\nsystem \'touch ran\'"', "must be a text of one line"),
         ('[points.heavy]', '[grid.again]\nkey = "casing.clearance"\nvalues = [2]\n[points.heavy]',
          "[grid.again]: varies casing.clearance, as [grid.clearance] does"),
         ('values = {', f'values = {list(range(20000))}\nmore = {{', "unknown key 'more'"),
         ('key = "casing.clearance"', 'keys = "casing.clearance"', "[grid.clearance]: unknown key 'keys'; known: key, values, unit"),
         ('case = "small_disc.toml"', '', "needs case ="),
         ('[settings]', '[setings]', "unknown key 'setings'"),
         (STUDY, 'case = 3\n' + HEAVY, "case = 3 must be a text"),
         (STUDY, 'case = "small_disc.toml"\nsettings = [1]\n' + HEAVY, "[settings]: must be a table"),
         (STUDY, 'case = "small_disc.toml"\npoints = [1]\n', "[points]: must be a table"),
         (STUDY, 'case = "small_disc.toml"\ngrid = 3\n', "[grid]: must be a table"),
         (STUDY, "\udcff\udcfe", "study.toml: "),
         (STUDY, "case = " + 5000 * "[", "study.toml: "),
         ('"postprocess.prominence" = 0.001', "\"postprocess.response_up\" = \"response_up.h5\"", "response_up and response_down are responses that a study"),
         ('title =', 'title', "study.toml: "))


class Bench:
    def __init__(self, programs, cases, case, work):
        self.programs, self.cases, self.work = programs, cases, work
        shutil.rmtree(work, ignore_errors=True)
        os.makedirs(work)
        shutil.copy(case, work)
        self.write("Makefile", f"include {cases}/study/study.mk\n")
        self.write("study.toml", STUDY)
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}

    def write(self, name, text):
        with open(os.path.join(self.work, name), "w", encoding="utf-8", errors="surrogateescape") as file:
            file.write(text)

    def text(self, name):
        with open(os.path.join(self.work, name), encoding="utf-8") as file:
            return file.read()

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
    assert [line.split()[0] for line in bench.text("report/study.txt").splitlines() if "no report" in line] == ["heavy"]


def table_and_page(bench):
    said = bench.must_make("-j2")
    assert "points/heavy" not in said.split("study")[0] and "clearance_0.12" in said, said
    assert len(glob.glob(os.path.join(bench.work, "runs", "models", "*", "model.h5"))) == 2
    joint, expected = bench.rows("report/study.csv"), []
    for point, clearance in (("clearance_0.13", "0.13"), ("clearance_0.12", "0.12"), ("heavy", "")):
        expected += [{"point": point, "clearance [mm]": clearance, **row} for row in bench.rows(f"runs/points/{point}/report/critical_speeds.csv")]
    assert joint == expected and {row["point"] for row in joint} >= {"clearance_0.12", "heavy"}, (joint, expected)
    for row in joint:
        label = f"{float(row['speed [rpm]']):.0f} ({row['wave'].split(':')[0]})"
        assert label in bench.text("report/study.txt"), f"symptom: a mixed motion was called by its largest wave, and ND 0 had a sign: {label}"
    page = bench.text("report/study.html")
    assert "Small &lt;study&gt;" in page and "3 of 3 points" in page and page.count("<svg") == 2, page[:2000]
    assert 'name="viewport"' in page and page.count('scope="col"') == 11 and page.count('role="img"') == 2, page[:2000]
    assert all(name in page for name in ("stress with spin [MPa]", "Goodman", "speeds to avoid")), page[:2000]
    assert 'href="../runs/points/heavy/report/report.html"' in page and "http://" not in page.replace("http://www.w3.org", "")


def only_what_changed(bench):
    bench.write("study.toml", STUDY.replace("0.12e-3", "0.11e-3") + '"simulate.speeds" = "given"\n')
    said = bench.must_make()
    assert said.count("tiprub-simulate ") == 2 and "casing.clearance=[[0.0, 0.00011]]" in said and "tiprub-reduce" not in said, said
    distrusted = [line for line in bench.text("report/study.txt").splitlines() if "The speeds are too far apart: " in line]
    assert [line.split()[0] for line in distrusted] == ["heavy"], "symptom: the table did not say which reports are not trustworthy"


def refusals(bench):
    """By `make table` too, which reads the study for itself. No command of a study is run, and no folder is made elsewhere or changed."""
    bench.write("study.toml", STUDY)
    bench.must_make("runs")
    runs = bench.text("runs/Makefile")
    for before, after, *phrases in WRONG:
        assert before in STUDY
        bench.write("study.toml", STUDY.replace(before, after))
        said, code = bench.make("runs")
        assert code != 0 and all(phrase in said for phrase in phrases) and "Traceback" not in said, (after, said)
        assert "Traceback" not in bench.make("table")[0], after
        assert bench.text("runs/Makefile") == runs, after
    bench.make("-n", "-C", "runs", "all")
    around = os.path.dirname(bench.work)
    assert not glob.glob(os.path.join(bench.work, "**", "ran"), recursive=True) and not glob.glob(os.path.join(around, "evil*"))


def texts_of_strangers(bench):
    """gnuplot runs what stands in backquotes; make and the shell see signs in texts and lists."""
    bench.write("study.toml", STUDY.replace('unit = "mm"', 'unit = "`touch ran`"').replace('title = "Small <study>"', 'title = "`touch ran`"'))
    bench.must_make("table")
    texts = ("a#b", "a\\\\#b", "$(shell touch ran)", "`touch ran`", "'; touch ran; '", "\\U0001F600 infinity and nan")
    for text in texts:
        bench.write("study.toml", STUDY.replace('"casing.lobes" = 3', f'"casing.shape" = "{text}"'))
        said, code = bench.make("runs")
        assert code != 0 and "must be one of: cosine" in said and "TOML" not in said, said
    assert not glob.glob(os.path.join(bench.work, "**", "ran"), recursive=True)


def damaged(bench):
    """2,000 studies with a few words or signs changed are taken or refused, and nothing else."""
    sys.path.insert(0, os.path.join(bench.cases, "study"))
    import study
    words = STUDY.split() + ['"', "[", "]", "{", "}", "=", "\n", "nan", "1e999", "true", "..", "\u202e", "\0", "a.b", '""', "[[]]", "1979-05-27", "0" * 5000]
    random.seed(12)
    refused = 0
    for _ in range(2000):
        pieces = STUDY.split(" ")
        for _ in range(random.choice((1, 1, 2, 4))):
            place = random.randrange(len(pieces))
            if random.random() < 0.5:
                pieces[place] = random.choice(words)
            else:
                at = random.randrange(len(pieces[place]) + 1)
                pieces[place] = pieces[place][:at] + random.choice(words) + pieces[place][at + random.randrange(3):]
        bench.write("damaged.toml", " ".join(pieces))
        try:
            study.Study(os.path.join(bench.work, "damaged.toml"))
        except study.Wrong:
            refused += 1
    assert 0 < refused < 2000
    print(f"ok: 2000 damaged studies, {refused} of them refused")


def main(*arguments):
    bench = Bench(*map(os.path.abspath, arguments))
    for step in (points_at_once, table_and_page, only_what_changed, refusals, texts_of_strangers, damaged):
        step(bench)


if __name__ == "__main__":
    main(*sys.argv[1:])
