#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the study reduction_cost reads of tiprub-reduce's words is there. Symptom: it stopped once these had changed.

usage: reduction_cost.py PROGRAMS_FOLDER CASES_FOLDER SMALL_CASE WORK_FOLDER
"""
import os
import shutil
import sys


def main(programs, cases, case, work):
    sys.path.insert(0, os.path.join(cases, "reduction_cost"))
    import reduction_cost as study
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    os.chdir(work)
    line, output = study.reduce(programs, case, {"threads": 1}, {})
    figures = dict(zip(study.COLUMNS.split("\t"), map(float, line.split("\t")), strict=True))
    assert figures["model_dofs"] >= figures["dofs_at_speed"] > 0 and figures["memory_GiB"] > 0, line
    assert study.free_dofs(programs, case) == figures["sector_dofs"], line
    seconds, factors = study.parts_of(output)
    assert {"shape under spin", "stiffness under spin", "modes, bases, verification"} <= set(seconds), output
    assert 0 < factors < sum(seconds.values()) < figures["processor_s"] + 0.01, output


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
