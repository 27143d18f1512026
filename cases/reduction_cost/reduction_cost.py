#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a reduction costs over the size of the mesh, and how exact it is over the size of the model.

usage: reduction_cost.py cost|error|prestress|size PROGRAMS_FOLDER CASE

cost: meshes of the case's wheel between 8,000 and 115,000 dofs; one line each; wall and processor time, peak memory.
error: models of many sizes of the case's own mesh with each prestress model; one line each. The error is the worst of the
wheel's first 50 frequencies against the unreduced sector at five speeds that the basis never saw.
prestress: what nonlinear prestress adds to linear on the case's own mesh: the same figures, terms of K, the processor time of
some of the steps, and that of the whole over that of the two factorizations.
size: meshes up to half a million dofs on one thread, by CHOLMOD as far as 12 GiB of memory go and, with less memory, by MUMPS on
disk; then the laws dofs^p that fit, and what they say of larger sectors.
"""
import glob
import math
import os
import re
import resource
import subprocess
import sys
import time

MESHES = [  # elements along chord, bore and span, through the disc, between blades
    (14, 6, 5, 2, 4),
    (22, 9, 8, 3, 4),
    (29, 12, 12, 4, 6),
    (38, 15, 16, 6, 8),
]
# With a limit of the memory [GiB] that factors in memory exceed and others don't.
LARGE_MESHES = [(MESHES[1], 1.55), (MESHES[3], 4.2), ((54, 22, 23, 9, 12), 10.6), ((68, 27, 30, 11, 16), 20)]
MOST_MEMORY = 12  # [GiB], with the factors in memory
UNSEEN = "[0.15, 0.35, 0.6, 0.85, 0.95]"
# Fixed-interface modes at each of two speeds, generalized dofs at any one speed, and the tolerance between the speeds.
MODELS = [(10, 20, 1.0), (20, 40, 1.0), (40, 60, 1.0), (20, 40, 5e-4), (40, 60, 5e-4), (40, 60, 1e-4), (60, 100, 5e-5)]
AT_NODES = {"contact": '"points"', "contact_nodes": 10, "speed_max_rpm": 22000}
PRESTRESS = ("stress_only", "linear", "nonlinear")
COLUMNS = "sector_dofs\tmodel_dofs\tdofs_at_speed\terror_percent\twall_s\tprocessor_s\tmemory_GiB\texpected_memory_GiB"


def run(*command):
    """Wall and processor time [s], peak memory [GiB] and output of a program."""
    start = time.monotonic()
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        output = process.stdout.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}")
    return time.monotonic() - start, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 2**20, output


def limited(memory, *command):
    """Wall and processor time [s], peak memory and peak of the factors in runs [GiB] of a program with a limit of the memory
    [GiB]; None if it fails."""
    disk = 0.0
    start = time.monotonic()
    with open("runs/log", "w", encoding="utf8") as log, subprocess.Popen(
            command, stdout=log, stderr=log,
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, 2 * (int(memory * 2**30),))) as process:
        while True:
            pid, status, used = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            files = glob.glob("runs/.tiprub-factor-*/*")
            disk = max(disk, sum(os.path.getsize(file) for file in files if os.path.exists(file)) / 2**30)
            time.sleep(0.5)
        process.returncode = os.waitstatus_to_exitcode(status)
    wall, processor = time.monotonic() - start, used.ru_utime + used.ru_stime
    if process.returncode != 0:
        return None
    return wall, processor, used.ru_maxrss / 2**20, disk


def settings(table, keys):
    return [word for key, value in keys.items() for word in ("--set", f"{table}.{key}={value}")]


def reduce(programs, case, keys, mesh_keys=None):
    """One line of figures: dofs of the sector, of the model, at any one speed, error [%], wall, processor, memory, and that
    expected; and what the program said of itself.

    With `mesh_keys`, on a new sector, which the next lines keep."""
    os.makedirs("runs", exist_ok=True)
    if mesh_keys is not None:
        run(f"{programs}/tiprub-mesh", "-q", case, "-o", "runs/sector.msh", *settings("mesh", mesh_keys))
    wall, processor, memory, output = run(f"{programs}/tiprub-reduce", "-v", case, "runs/sector.msh", "-o", "runs/model.h5",
                                          *settings("reduce", keys))
    expected = re.search(r"^memory: ([.\d]+) GiB expected", output, flags=re.M).group(1)
    sector, model, at_speed = re.search(r"of (\d+) dofs -> (\d+) dofs, (\d+) at any one speed", output).groups()
    error = re.search(r"frequencies within ([-+.e\d]+) %", output).group(1)
    line = f"{sector}\t{model}\t{at_speed}\t{error}\t{wall:.2f}\t{processor:.2f}\t{memory:.3f}\t{float(expected):.3f}"
    return line, output


def elements(chord, bore, span, disc, between):
    return {"elements_along_chord": chord, "elements_along_bore": bore, "elements_along_span": span,
            "elements_through_disc": disc, "elements_between_blades": between}


def cost(programs, case, threads):
    print(f"# threads {threads}\n{COLUMNS}")
    for mesh in MESHES:
        print(reduce(programs, case, {"threads": threads}, elements(*mesh))[0], flush=True)


def law(rows, column):
    """p and c of c dofs^p through the logarithms."""
    x, y = [math.log(row[0]) for row in rows], [math.log(row[column]) for row in rows]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    power = sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x)**2 for a in x)
    return power, math.exp(mean_y - power * mean_x)


def laws(name, rows):
    """Lines of the fitted exponents and of larger sectors."""
    known = {column: [row for row in rows if row[column] > 0] for column in range(1, 5)}
    fits = {column: law(some, column) for column, some in known.items() if len(some) > 1}
    print(f"{name}\tdofs^\t" + "\t".join(f"{fits[column][0]:.2f}" if column in fits else "" for column in range(1, 5)))
    for dofs in (1e6, 3e6, 10e6):
        values = (f"{fits[column][1] * dofs**fits[column][0]:.4g}" if column in fits else "" for column in range(1, 5))
        print(f"{name} (extrapolated)\t{dofs:.0f}\t" + "\t".join(values), flush=True)


def free_dofs(programs, case):
    """Of the sector."""
    checked = run(f"{programs}/tiprub-reduce", "--check", case, "runs/sector.msh")[-1]
    return int(re.search(r"(\d+) dofs,", checked).group(1))


def size(programs, case, _):
    print("factors\tsector_dofs\twall_s\tprocessor_s\tmemory_GiB\tdisk_GiB")
    os.makedirs("runs", exist_ok=True)
    for name, factorization in (("CHOLMOD", "cholmod"), ("MUMPS on disk", "automatic")):
        rows = []
        for mesh, too_little in LARGE_MESHES:
            run(f"{programs}/tiprub-mesh", "-q", case, "-o", "runs/sector.msh", *settings("mesh", elements(*mesh)))
            dofs = free_dofs(programs, case)
            command = (f"{programs}/tiprub-reduce", case, "runs/sector.msh", "-o", "runs/model.h5",
                       *settings("reduce", {"threads": 1, "mesh_error": "false", "factorization": f'"{factorization}"'}))
            made = limited(MOST_MEMORY if factorization == "cholmod" else too_little, *command)
            if made is None:
                print(f"{name}: {mesh} was not finished", file=sys.stderr)
                break
            rows.append((dofs, *made))
            print(f"{name}\t{dofs}\t{made[0]:.1f}\t{made[1]:.1f}\t{made[2]:.3f}\t{made[3]:.3f}", flush=True)
        laws(name, rows)


def error(programs, case, threads):
    print(f"prestress\tfixed_interface_modes\tfrequency_tolerance\t{COLUMNS}")
    mesh_keys = {}
    for name in PRESTRESS:
        for modes, at_speed, tolerance in MODELS:
            keys = {"threads": threads, "prestress": f'"{name}"', "fixed_interface_modes": modes, "modes_at_speed": at_speed,
                    "frequency_tolerance": tolerance, "verification_speeds": UNSEEN}
            print(f"{name}\t{modes}\t{tolerance:g}\t{reduce(programs, case, keys, mesh_keys)[0]}", flush=True)
            mesh_keys = None


def parts_of(output):
    """Processor time [s] of each step, and of the two factorizations."""
    parts = re.findall(r"^([a-z, ]+): [.\d]+ s, ([.\d]+) s of processor time$", output, flags=re.M)
    seconds = {what: float(value) for what, value in parts}
    return seconds, seconds["factor at rest"] + seconds["factor at full speed"]


def prestress(programs, case, threads):
    print(f"# threads {threads}\nprestress\t{COLUMNS}\tterms\tfactors_s\tshape_s\tstiffness_s\tmodes_s\tover_factors")
    mesh_keys = {"fillet_radius": 0}
    for name in ("linear", "nonlinear"):
        line, output = reduce(programs, case, {**AT_NODES, "threads": threads, "prestress": f'"{name}"'}, mesh_keys)
        mesh_keys = None
        seconds, factors = parts_of(output)
        terms = re.search(r"eq. 7 of (\d+) terms", output)
        steps = (seconds[what] for what in ("shape under spin", "stiffness under spin", "modes, bases, verification"))
        print(name, line, terms.group(1) if terms else 3, f"{factors:.2f}", *(f"{step:.2f}" for step in steps),
              f"{sum(seconds.values()) / factors:.2f}", sep="\t", flush=True)


def main():
    what, programs, case = sys.argv[1:]
    {"cost": cost, "error": error, "prestress": prestress, "size": size}[what](programs, case, len(os.sched_getaffinity(0)))


if __name__ == "__main__":
    main()
