#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The price, side by side: what each kind of work costs, and its goal, as one table.

usage: price.py PROGRAMS_FOLDER FOLDER [--part PART]... [--size THOUSAND_DOFS]...

Runs the parts (orbits, calculix, steps, reduction, scaling), all of them by default, and keeps the table of each in FOLDER. Then
joins what is there into price.tsv, with the machine in price_numbers.tsv, and prints it as Markdown. Both sides of a ratio run in
turn or side by side, and medians are compared. --size is of reduction and calculix: 30, 120 (6 GiB or more), by default both.
"""
import argparse
import csv
import datetime
import os
import statistics
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), "..", ".."))
CASES = os.path.join(ROOT, "cases")
PYTHON = ("/usr/bin/python3", "-B")
sys.path[:0] = [CASES, os.path.join(CASES, "reduction_cost")]

import fill_pages
import reduction_cost

PARTS = ("orbits", "calculix", "steps", "reduction", "scaling")
SIZES = ("30", "120")
WHEELS = {"impeller_quick": "coarse_10", "cc3": "coarse_15"}
# Ten blades have a symmetry in two lobes, fifteen in three.
LOBES = {"without a symmetry": [("impeller_quick", "three lobes"), ("cc3", "two lobes")],
         "with a symmetry": [("impeller_quick", "two lobes"), ("cc3", "three lobes")]}
REPEATS = 3  # of a reduction
SWEEP_GOALS = {("impeller_quick", "0.002"): 90, ("cc3", "0.002"): 350, ("impeller_quick", "0.005"): 45, ("cc3", "0.005"): 100}  # [s]
SAME_SPEED = 0.02            # [%]
REDUCTION_GOALS = {"30": None, "120": 4.0}  # the smaller the sector, the less its factorization counts
CALCULIX_GOALS = {"30": 29, "120": 40}
NOT_MEASURED = ("not measured", "")


def model_of(wheel):
    return os.path.join(CASES, "paper", WHEELS[wheel], "model.h5")


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file, delimiter="\t", lineterminator="\n").writerows(rows)


def read(path):
    """The rows of a table by the names of its columns; none if there is no table."""
    if not os.path.exists(path):
        return []
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader((line for line in file if not line.startswith("#")), delimiter="\t"))


def make_models(programs):
    for folder in WHEELS.values():
        subprocess.run(["make", "-s", "-C", os.path.join(CASES, "paper", folder), "model.h5", f"BIN={programs}"], check=True)


class Parts:
    """Each runs its programs and leaves its table in the folder."""

    def __init__(self, programs, folder, sizes):
        self.programs, self.folder, self.sizes = programs, folder, sizes

    def path(self, name):
        return os.path.join(self.folder, name + ".tsv")

    def start(self, part):
        """Those that take long, as processes."""
        if part == "orbits":
            wheels = [f"{os.path.join(CASES, wheel)}={model_of(wheel)}" for wheel in WHEELS]
            # On one processor, which march and orbit then share; CalculiX has the other one.
            last = {max(os.sched_getaffinity(0))}
            return subprocess.Popen([*PYTHON, os.path.join(CASES, "orbits", "orbits.py"), self.programs, *wheels], cwd=self.folder,
                                    preexec_fn=lambda: os.sched_setaffinity(0, last))
        with open(self.path("calculix"), "w", encoding="utf-8") as table:
            return subprocess.Popen([*PYTHON, os.path.join(ROOT, "tests", "peers", "side_by_side.py"),
                                     *(os.path.join(self.programs, name) for name in ("tiprub-mesh", "tiprub-reduce")),
                                     os.path.join(CASES, "fast_impeller_fine", "case.toml"), os.path.join(self.folder, "calculix"),
                                     *self.sizes], stdout=table)

    def benchmark(self, *words):
        return subprocess.run([os.path.join(self.programs, "tiprub-benchmark"), *words], stdout=subprocess.PIPE, text=True, check=True).stdout

    def steps(self):
        lines = []
        for wheel in WHEELS:
            note, head, *rows = self.benchmark("steps", "--model", model_of(wheel)).splitlines()
            lines += [*([] if lines else ["wheel\t" + head]), note, *(f"{wheel}\t{row}" for row in rows)]
        with open(self.path("steps"), "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")

    def reduction(self):
        rows, threads = [], min(len(os.sched_getaffinity(0)), 2)
        os.chdir(self.folder)  # which holds the runs
        for size in self.sizes:
            mesh = {"fillet_radius": 0, **(reduction_cost.elements(*reduction_cost.MESHES[1]) if size == "30" else {})}
            for run in range(REPEATS):
                line, output = reduction_cost.reduce(self.programs, os.path.join(CASES, "impeller", "case.toml"),
                                                     {**reduction_cost.AT_NODES, "threads": threads}, None if run else mesh)
                seconds, factors = reduction_cost.parts_of(output)
                rows.append([size, line.split("\t")[0], threads, line.split("\t")[4], f"{sum(seconds.values()):.2f}", f"{factors:.2f}"])
        write(self.path("reduction"), [["size_thousand_dofs", "dofs", "threads", "wall_s", "processor_s", "factors_s"], *rows])

    def scaling(self):
        with open(self.path("scaling"), "w", encoding="utf-8") as file:
            file.write(self.benchmark("scaling"))


def between(values, unit=""):
    low, high = min(values), max(values)
    return f"{low:.1f}{unit}" if f"{low:.1f}" == f"{high:.1f}" else f"{low:.1f} to {high:.1f}{unit}"


def verdict(is_met):
    return "met" if is_met else "missed"


def sweep_rows(folder):
    rows = {(row["wheel"], row["damping [1]"]): row for row in read(os.path.join(folder, "orbits.tsv"))}
    for (wheel, damping), goal in SWEEP_GOALS.items():
        row = rows.get((wheel, damping))
        measured = NOT_MEASURED
        if row:
            same = row["critical speeds"] == row["of the same motion"] and float(row["speeds within [%]"]) <= SAME_SPEED
            measured = (f"{row['march [s]']} s march, {row['orbit [s]']} s orbit; {row['of the same motion']} of {row['critical speeds']} "
                        f"motions are the same, speeds within {row['speeds within [%]']} %", verdict(same and float(row["orbit [s]"]) <= goal))
        yield [f"all critical speeds of `{wheel}`, damping {100 * float(damping):g} %", measured[0],
               f"{goal} s by orbit, same motions, speeds within {SAME_SPEED} %", measured[1]]


def step_rows(folder):
    rows = read(os.path.join(folder, "steps.tsv"))

    def row(work, marches, column, goal="none", least=None, most=None):
        values = [float(at[column]) for at in rows if (at["wheel"], at["march"]) in marches]
        is_met = values and (least is None or min(values) >= least) and (most is None or max(values) <= most)
        judged = "" if least is None and most is None else verdict(is_met)
        return [work, *((between(values, " x"), goal, judged) if values else (NOT_MEASURED[0], goal, NOT_MEASURED[1]))]

    all_marches = [march for marches in LOBES.values() for march in marches]
    yield row("time of a step in contact over its bound", all_marches, "over_bound", "at most 2.0 x", most=2.0)
    yield row("time of a step in the air over its bound", [(wheel, name + ", in the air") for wheel, name in all_marches], "over_bound",
              "at most 1.5 x", most=1.5)
    for which, marches in LOBES.items():
        yield row(f"time of a step of the dense march of eqs. 13-15 over ours, {which}", marches, "dense_over_it")
        yield row(f"the same of a revolution, {which}", marches, "dense_over_it_a_revolution")
        yield row(f"time of a step of the plain modal march of the whole wheel over ours, {which}", marches, "plain_modal_over_it", "at least 8 x",
                  least=8.0)


def reduction_rows(folder):
    rows = read(os.path.join(folder, "reduction.tsv"))
    for size, most in REDUCTION_GOALS.items():
        runs = [row for row in rows if row["size_thousand_dofs"] == size]
        work, goal = "time of a reduction over that of its two factorizations", f"at most {most} x" if most else "none"
        if not runs:
            yield [f"{work}, {size},000 dofs", NOT_MEASURED[0], goal, NOT_MEASURED[1]]
            continue
        ratio = statistics.median(float(run["processor_s"]) / float(run["factors_s"]) for run in runs)
        wall = statistics.median(float(run["wall_s"]) for run in runs)
        yield [f"{work}, {int(runs[0]['dofs']):,} dofs, threads: {runs[0]['threads']}", f"{ratio:.1f} x ({wall:.0f} s)", goal,
               verdict(ratio <= most) if most else ""]


def calculix_rows(folder):
    rows = {row["size_thousand_dofs"]: row for row in read(os.path.join(folder, "calculix.tsv")) if row["program"] != "CalculiX"}
    for size, goal in CALCULIX_GOALS.items():
        work = f"time of CalculiX over that of `tiprub-reduce --modes`, {size},000 dofs"
        ratio = float(rows[size]["processor_ratio"]) if size in rows else None
        yield [work, *((f"{ratio:.0f} x", f"at least {goal} x", verdict(ratio >= goal)) if ratio else (NOT_MEASURED[0], f"at least {goal} x", ""))]


def commit():
    found = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], stdout=subprocess.PIPE, text=True, check=False)
    return found.stdout.strip() or "unknown"


def join(folder):
    rows = [row for part in (sweep_rows, step_rows, reduction_rows, calculix_rows) for row in part(folder)]
    write(os.path.join(folder, "price.tsv"), [["work", "measured", "goal", "result"], *rows])
    write(os.path.join(folder, "price_numbers.tsv"), [["key", "value"], ["price.date", datetime.date.today().isoformat()],
                                                      ["price.commit", commit()]])
    print(fill_pages.table_of(os.path.join(folder, "price.tsv")))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("programs", type=os.path.abspath)
    parser.add_argument("folder", type=os.path.abspath)
    parser.add_argument("--part", action="append", choices=PARTS)
    parser.add_argument("--size", action="append", choices=SIZES)
    given = parser.parse_args()
    os.makedirs(given.folder, exist_ok=True)
    wanted = given.part or PARTS
    parts = Parts(given.programs, given.folder, given.size or SIZES)
    if {"orbits", "steps"} & set(wanted):
        make_models(given.programs)
    started = [parts.start(part) for part in ("orbits", "calculix") if part in wanted]
    codes = [process.wait() for process in started]
    for part in ("steps", "reduction", "scaling"):
        if part in wanted:
            getattr(parts, part)()
    join(given.folder)
    return max(codes, default=0)


if __name__ == "__main__":
    sys.exit(main())
