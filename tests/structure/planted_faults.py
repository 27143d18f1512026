#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each check of the structure fails on a fault that is planted into a copy of the sources.

usage: planted_faults.py ROOT FOLDER
"""
import os
import re
import shutil
import subprocess
import sys

import source_tree

TOUCHED = set()
HERE = os.path.dirname(os.path.abspath(__file__))


def put(copy, path, text, mode="a"):
    os.makedirs(os.path.dirname(os.path.join(copy, path)), exist_ok=True)
    with open(os.path.join(copy, path), mode, encoding="utf-8") as file:
        file.write(text)
    TOUCHED.add(path)


def include(copy, path, header):
    put(copy, path, f'#include "{header}"\n')


def without_row(copy):
    put(copy, "cases/equations.md", re.sub(r"^\| *7 *\|.*\n", "", source_tree.read(copy, "cases/equations.md"), flags=re.M), "w")


def row_of_a_ghost(copy):
    without_row(copy)
    put(copy, "cases/equations.md", "| 7 | a ghost | `no_such_symbol` in `reduce/main` | `A.B` in `tests/reduce/wheel_test.cc` |\n")


def long_body(line, count):
    return "".join(f"{line}\n" for _ in range(count))


# Check, what is planted, what it must say.
FAULTS = [
    ("includes", lambda copy: include(copy, "simulate/scene/planted.h", "simulate/sweep/sweep.h"),
     "simulate/scene/planted.h: includes upwards"),
    ("includes", lambda copy: include(copy, "postprocess/tables/planted.cc", "simulate/march/time_march.h"),
     "postprocess/tables/planted.cc: includes what is no file header"),
    ("includes", lambda copy: include(copy, "simulate/response/response.h", "simulate/march/time_march.h"),
     "reaches simulate/march/time_march.h: simulate/response/response.h -> simulate/march/time_march.h"),
    ("includes", lambda copy: put(copy, "reduce/model/reduced_model.h", "#include <mpi.h>\n"), "a file header reaches <mpi.h>"),
    ("includes", lambda copy: (include(copy, "mesh/curves/one.h", "mesh/curves/other.h"),
                               include(copy, "mesh/curves/other.cc", "mesh/curves/one.h"),
                               include(copy, "mesh/curves/other.h", "mesh/curves/third.h"),
                               put(copy, "mesh/curves/third.h", "")), "a circle of includes: mesh/curves/o"),
    ("includes", lambda copy: include(copy, "reduce/model/reduced_model.h", "reduce/model/hdf5_handle.h"),
     "includes another folder's private header"),
    ("includes", lambda copy: put(copy, "reduce/attic/planted.h", ""), "lies in no known storey"),
    ("includes", lambda copy: (include(copy, "mesh/curves/inner/one.h", "mesh/curves/other.h"),
                               include(copy, "mesh/curves/third.h", "mesh/curves/inner/two.h"),
                               put(copy, "mesh/curves/other.h", ""), put(copy, "mesh/curves/inner/two.h", "")),
     "folders include each other: mesh/curves -> mesh/curves/inner -> mesh/curves"),
    ("equations", without_row, "has no row for eq. 7"),
    ("equations", row_of_a_ghost, "holds no no_such_symbol"),
    ("sizes", lambda copy: put(copy, "mesh/curves/planted.cc", "int planted(int a) {\n" + long_body("  a += 1;", 39) +
                               "  return a;\n}\n"), "a function of 42 lines, at most 40: int planted(int a) {"),
    ("sizes", lambda copy: put(copy, "tests/chain/planted.py", "def planted():\n" + long_body("    pass", 40)),
     "a function of 41 lines, at most 40: def planted"),
    ("sizes", lambda copy: put(copy, "mesh/curves/planted.h", long_body("// long", 401)), "has 401 lines, at most 400"),
    ("pages", lambda copy: put(copy, "README.md", re.sub(r"(checks.either -->)\d+", r"\g<1>99", source_tree.read(copy, "README.md")), "w"),
     "README.md: differs from the tables"),
    ("pages", lambda copy: put(copy, "README.md", "<!-- paper/no.such -->7<!---->\n"), "the cell no.such stands in no table"),
    ("pages", lambda copy: put(copy, "README.md", "<!-- paper/checks.either -->7<!----> hold\n"), "the cell paper/checks.either begins a line"),
    ("versions", lambda copy: put(copy, ".github/CITATION.cff", "version: 9.9.9\n", "w"), "CITATION.cff: says version 9.9.9"),
]


def copy_of(root, copy):
    shutil.rmtree(copy, ignore_errors=True)
    documents = ["README.md", "cases/equations.md", "cases/paper/expected/check_numbers.tsv",
                 "cases/impeller_quick/expected/numbers.tsv", "cases/impeller_quick/expected/error_budget.csv",
                 "cases/price_of_accuracy/expected/first_page.tsv", "cases/price_of_accuracy/expected/uncertainty_numbers.tsv",
                 "CMakeLists.txt", ".github/CHANGELOG.md", ".github/CITATION.cff"]
    for path in source_tree.files(root) + documents:
        if os.path.isfile(os.path.join(root, path)):
            os.makedirs(os.path.join(copy, os.path.dirname(path)), exist_ok=True)
            shutil.copy(os.path.join(root, path), os.path.join(copy, path))


def restore(root, copy):
    """Takes back what put() did."""
    for path in TOUCHED:
        os.remove(os.path.join(copy, path))
        if os.path.exists(os.path.join(root, path)):
            shutil.copy(os.path.join(root, path), os.path.join(copy, path))
    TOUCHED.clear()


def outcome(check, copy):
    run = subprocess.run([sys.executable, "-B", os.path.join(HERE, check + ".py"), copy], text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    return run.returncode, run.stdout


def main(root, copy):
    copy_of(root, copy)
    before = {check: outcome(check, copy)[1] for check, _, _ in FAULTS}
    for check, plant, phrase in FAULTS:
        plant(copy)
        code, text = outcome(check, copy)
        assert phrase not in before[check], f"{check} says \"{phrase}\" without the planted fault:\n{before[check]}"
        assert code == 1 and phrase in text, f"{check} does not say \"{phrase}\":\n{text}"
        restore(root, copy)
        print(f"{check}: {phrase}")
    shutil.rmtree(copy)


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:3]))
