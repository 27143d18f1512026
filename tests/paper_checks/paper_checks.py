#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks 1 to 81 of what a reproduction of the paper must show, one line each.

usage: paper_checks.py BUILD_FOLDER CASES_FOLDER CASE_FOLDER... [--table=FILE.tsv]

BUILD_FOLDER holds bin/ with the programs and tests, CASES_FOLDER holds `aliasing` and `convergence`; each CASE_FOLDER is a case
that `make` has made. A line reads `holds`, `does not hold on this wheel`, `by construction`, or `can't be made`, with what was
measured; the table holds the same. Exit code 1 if a check that does not depend on the paper's own wheel doesn't hold; else 2 if one can't be made; else 0.
"""
import functools
import importlib.util
import os
import subprocess
import sys
import tempfile

import linear_checks  # each adds its checks to the registry, in this order
import contact_checks
import result_checks
from free_ring import FreeRing
from registry import CHECKS, PLACE_OF, WHEEL, ByConstruction, CannotBeMade
from scene import Case, Mesh, Model, Tests, read_table


class Context:
    def __init__(self, build, cases_folder, folders, work):
        self.tests, self.cases_folder, self.work = Tests(build), cases_folder, work
        self.cases = [Case(folder) for folder in folders]
        self.any_case = self.cases[0]
        # The wheel's own case: the one that holds [mesh], which others may share.
        self.wheel = next((case for case in self.cases if "[mesh]" in case.written), self.any_case)

    @functools.cached_property
    def mesh(self):
        return Mesh(self.wheel.path("sector.msh"))

    @functools.cached_property
    def model(self):
        return Model(self.any_case.path("model.h5"))

    @functools.cached_property
    def free_ring(self):
        """The two-lobed case with all nodal diameters, at its critical speeds."""
        return FreeRing(self, self.lobed(2))

    @functools.cached_property
    def convergence(self):
        folder = os.path.join(self.cases_folder, "convergence")
        for name in ("convergence.tsv", "expected/convergence.tsv"):  # what was made here, or the record
            if os.path.exists(os.path.join(folder, name)):
                return read_table(os.path.join(folder, name))
        raise CannotBeMade(f"no {folder}/convergence.tsv; make -C {folder}")

    @functools.cached_property
    def aliasing(self):
        spec = importlib.util.spec_from_file_location("aliasing", os.path.join(self.cases_folder, "aliasing", "aliasing.py"))
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        return module

    def lobed(self, lobes):
        for case in self.cases:
            if case.lobes == lobes:
                return case
        raise CannotBeMade(f"no case with {lobes} lobes was given")

    def run_program(self, name, *arguments):
        path = os.path.join(self.tests.build, "bin", name)
        if not os.path.exists(path):
            raise CannotBeMade(f"{path} is not built")
        done = subprocess.run([path, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            raise CannotBeMade(f"{name}: {done.stdout.strip()}")
        return done.stdout

    @staticmethod
    def figures_exist(case, *names):
        there = os.listdir(case.path("report", "figures"))
        missing = [name for name in names if not any(file.startswith(name) and file.endswith((".svg", ".png")) for file in there)]
        if missing:
            raise CannotBeMade(f"{case.name} has no figure {', '.join(missing)}")
        return True, "figures " + ", ".join(names)


def outcome_of(function, context):
    try:
        good, measured = function(context)
        return ("holds" if good else "does not hold on this wheel"), measured
    except ByConstruction as reason:
        return "by construction", str(reason)
    except CannotBeMade as reason:
        return "can't be made", str(reason)


def write_table(path, rows):
    with open(path, "w", encoding="utf-8") as file:
        file.write("check\tin the paper\twhat\tverdict\tmeasured\n")
        file.writelines("\t".join((str(number), PLACE_OF[number], text, outcome, " ".join(measured.split()))) + "\n"
                        for number, text, outcome, measured in rows)


def main(build, cases_folder, *folders, table=None):
    rows, tally = [], dict.fromkeys(("holds", "does not hold on this wheel", "by construction", "can't be made"), 0)
    failed = []
    with tempfile.TemporaryDirectory() as work:
        try:
            context = Context(build, cases_folder, folders, work)
        except CannotBeMade as reason:
            print(f"no check can be made: {reason}")
            return 2
        for number, text, depends, function in CHECKS:
            outcome, measured = outcome_of(function, context)
            tally[outcome] += 1
            rows.append((number, text, outcome, measured))
            if outcome == "does not hold on this wheel" and depends != WHEEL:
                failed.append(number)
            print(f"{number:2d}  {outcome}{' [D]' if depends == WHEEL else ''}: {text}: {measured}", flush=True)
    if table:
        write_table(table, rows)
    print("; ".join(f"{count} {outcome}" for outcome, count in tally.items()) +
          (f"; of those that don't depend on the paper's own wheel, these don't hold: {failed}" if failed else ""))
    return 1 if failed else 2 if tally["can't be made"] else 0


if __name__ == "__main__":
    folders = [word for word in sys.argv[1:] if not word.startswith("--table=")]
    if len(folders) < 3:
        sys.exit(__doc__)
    wanted = [word.partition("=")[2] for word in sys.argv[1:] if word not in folders]
    sys.exit(main(*map(os.path.abspath, folders), table=wanted[0] if wanted else None))
