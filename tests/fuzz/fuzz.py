#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""All readers on damaged inputs of a new seed; a table at the end, and exit code 1 if a reader failed on one.

    fuzz.py PROGRAMS_FOLDER CASE WORK_FOLDER INPUTS [SEED]     (make fuzz)
"""
import concurrent.futures
import os
import subprocess
import sys
import time

from bases import MESH_FORMATS, SCENES, make_bases

FILES = {"case": "case.toml", "mesh": "sector.msh", "model": "model.h5", "fields": "fields.h5", "response": "response.h5"}
# Files beside this one, of formats of others.
FOREIGN = {"sections": "blades/sections.txt", "profile": "blades/profile.curve", "meanline": "blades/meanline.rtzt",
           "stiffness": "matrices/stiffness.mtx", "mass": "matrices/mass.mtx", "nodes": "matrices/nodes.csv", "rows": "matrices/rows.dof",
           "casing": "tables/casing.csv", "pairs": "tables/pairs.csv",
           **{name: f"meshes/brick.{name}" for name in ("inp", "bdf", "cdb", "unv")}}


def main(programs, case, work, inputs, seed=None):
    seed = seed or str(int(time.time()))
    bases = os.path.join(work, "bases")
    make_bases(programs, case, bases)

    def fuzz(reader):
        files = [os.path.join(os.path.dirname(__file__), FOREIGN[reader])] if reader in FOREIGN else []
        files += [os.path.join(bases, scene, FILES[reader]) for scene in SCENES if reader in FILES]
        if reader == "mesh":
            files += [os.path.join(bases, "open", name) for name in MESH_FORMATS]
        return subprocess.run([os.path.join(programs, "tiprub_fuzz"), reader, seed, str(int(inputs) // len(FILES | FOREIGN)), "0",
                               os.path.join(work, reader), *files],
                              env=dict(os.environ, OPENBLAS_NUM_THREADS="1"), stdout=subprocess.PIPE, text=True, check=False)

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        runs = list(pool.map(fuzz, FILES | FOREIGN))
    print(f"seed {seed}")
    for number, run in enumerate(runs):
        print("\n".join(run.stdout.splitlines()[number > 0:]))
    sys.exit(any(run.returncode for run in runs))


if __name__ == "__main__":
    main(*sys.argv[1:])
