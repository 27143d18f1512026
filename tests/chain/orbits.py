#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Orbits are the motions that marches settle on: at every speed the same class of motion, the same verdict on symmetry, and the same
displacements where the motion repeats.

usage: orbits.py PROGRAMS_FOLDER CASE.toml WORK_FOLDER SPEED_COUNT [MODEL.h5]

Without a model, makes one with contact at ten nodes of a blade and no fillets.
"""
import os
import shutil
import subprocess
import sys

try:
    import h5py
    import numpy
except ImportError:
    print("SKIPPED: needs python3-h5py")
    sys.exit(77)

RPM = 30 / numpy.pi
# One step for both, so that they differ only in how the motion is found, and enough revolutions for slow marches.
SETTINGS = {"simulate.speeds": '"given"', "simulate.examine": '"none"', "simulate.budget": '"none"',
            "simulate.steps_per_revolution": 2400, "simulate.max_revolutions": 1000}
MARCH_TOLERANCE = 0.1  # of the orbit's settle_tolerance: a march only estimates its distance, which was up to four times as large
FOUND = 0.5  # of the speeds, at least, have an orbit


def words_of(values):
    return [word for key, value in values.items() for word in ("--set", f"{key}={value}")]


def make_model(programs, case, work):
    sector, model = os.path.join(work, "sector.msh"), os.path.join(work, "model.h5")
    subprocess.run([os.path.join(programs, "tiprub-mesh"), "-q", case, "-o", sector, "--set", "mesh.fillet_radius=0"], check=True)
    subprocess.run([os.path.join(programs, "tiprub-reduce"), "-q", case, sector, "-o", model,
                    *words_of({"reduce.contact": '"points"', "reduce.contact_nodes": 10})], check=True)
    return model


def sweep(programs, case, model, output, values):
    """The response, as an open file."""
    subprocess.run([os.path.join(programs, "tiprub-simulate"), "-q", case, model, "-o", output, *words_of({**SETTINGS, **values})], check=True)
    return h5py.File(output)


def distance(here, there):
    """Of two recordings of one motion, over as many revolutions as both have."""
    a, b = here["displacement"][:], there["displacement"][:]
    count = min(len(a), len(b))
    a, b = a[:count], b[:count]
    return numpy.linalg.norm(a - b) / max(numpy.linalg.norm(a), numpy.linalg.norm(b))


def compare(march, orbit):
    """Prints all speeds before it fails."""
    tolerance = orbit.attrs["settle_tolerance"]
    faults, found, repeating = [], 0, 0
    for name, here in march["speed"].items():
        there = orbit["speed"][name]
        words = [(at.attrs["motion"], at.attrs["symmetry"]) for at in (here, there)]
        found += there.attrs["orbit"] == b"found"
        line = f"{here.attrs['speed'] * RPM:.0f} rpm: {words[0]}, {there.attrs['orbit']}"
        if words[0] != words[1]:
            faults.append(f"{line}: by orbit {words[1]}")
        if here.attrs["motion"] == b"periodic":
            repeating += 1
            apart = distance(here, there)
            line += f", {apart:.1e} apart"
            if apart > tolerance:
                faults.append(line)
        print(line)
    print(f"{found} orbits at {len(march['speed'])} speeds, {repeating} of them periodic; settle_tolerance {tolerance:.1e}")
    assert not faults, "\n".join(faults)
    assert found >= FOUND * len(march["speed"])


def main(programs, case, work, speeds, model=None):
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    model = model or make_model(programs, case, work)
    count = {"simulate.speed_count": speeds}
    with sweep(programs, case, model, os.path.join(work, "orbit.h5"), {**count, "simulate.steady_state": '"orbit"'}) as orbit:
        tight = {"simulate.settle_tolerance": MARCH_TOLERANCE * orbit.attrs["settle_tolerance"]}
        with sweep(programs, case, model, os.path.join(work, "march.h5"), {**count, **tight}) as march:
            compare(march, orbit)


if __name__ == "__main__":
    main(*sys.argv[1:])
