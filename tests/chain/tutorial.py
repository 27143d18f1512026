#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands of the tutorial, as its text has them, in one shell that stops at the first that fails. The exports, which
tell a reader's shell where cases and programs are, are left out, because the test's own are elsewhere.

usage: tutorial.py PROGRAMS_FOLDER SOURCE_FOLDER WORK_FOLDER
"""
import csv
import os
import re
import shutil
import subprocess
import sys


def commands(case):
    """The blocks of commands in a case's text, one below the other, without exports."""
    with open(os.path.join(case, "README.md"), encoding="utf-8") as file:
        blocks = re.findall(r"^```sh\n(.*?)^```", file.read(), re.S | re.M)
    assert blocks, f"{case}: no block of commands"
    return re.sub(r"^export .*\n", "", "".join(blocks), flags=re.M)


def run(script, programs, source, folder):
    """In a folder, with the programs on the PATH; what was said."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    environment.update(PATH=programs + os.pathsep + os.environ["PATH"], TIPRUB=source)
    done = subprocess.run(["bash", "-eux", "-c", script], cwd=folder, env=environment, text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout
    return done.stdout


def worst_peak(report):
    """The critical speed with the largest amplitude, as a row of the report's table."""
    with open(os.path.join(report, "critical_speeds.csv"), newline="", encoding="utf-8") as file:
        return max(csv.DictReader(file), key=lambda peak: float(peak["amplitude [mm]"]))


def main(programs, source, work):
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    here = os.path.join(source, "cases", "your_blade")
    run(commands(here), programs, source, work)
    for name in ("blade.txt", "case.toml"):
        with open(os.path.join(here, name), encoding="utf-8") as theirs, open(os.path.join(work, "my_blade", name), encoding="utf-8") as ours:
            assert theirs.read().replace("# SPDX-License-Identifier: GPL-3.0-or-later\n", "") == ours.read(), f"{name} is not what the text writes"
    report = os.path.join(work, "my_blade", "report")
    peak = worst_peak(report)
    assert 12500 < float(peak["speed [rpm]"]) < 12600 and peak["wave"] == "EO 10 ND -2", peak
    assert peak["largest wave"] == "EO 8 ND -4" and peak["predicted by eq. 2"] == peak["predicted with aliasing"] == "no", peak
    assert os.path.getsize(os.path.join(report, "report.html")) > 0


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
