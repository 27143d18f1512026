#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A packager's tiprub-simulate, without Trilinos and MPI: it computes the same bytes, and refuses what it can't do.

usage: fewer_libraries.py CMAKE SOURCE FOLDER_OF_THE_PROGRAMS SMALL_CASE WORK_FOLDER
"""
import os
import re
import shutil
import subprocess
import sys

REFUSALS = [
    ({}, ["--set", 'simulate.steady_state="orbit"'], 2, 'steady_state = "orbit" needs a build with TIPRUB_ORBITS=ON'),
    ({}, ["--set", 'simulate.branches="critical_speeds"'], 2, 'branches = "critical_speeds" needs a build with TIPRUB_ORBITS=ON'),
    ({"OMPI_COMM_WORLD_SIZE": "2"}, [], 1, "mpirun started this program, which was built without MPI"),
]


def run(*command, **options):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False, **options)
    assert done.returncode == 0, f"{command}:\n{done.stdout}"
    return done.stdout


def build(cmake, source, work):
    folder = os.path.join(work, "build")
    run(cmake, "-G", "Ninja", "-S", source, "-B", folder, "-DBUILD_TESTING=OFF", "-DTIPRUB_ORBITS=OFF", "-DTIPRUB_MPI=OFF")
    run(cmake, "--build", folder, "--target", "tiprub-simulate")
    return os.path.join(folder, "bin", "tiprub-simulate")


def main(cmake, source, programs, case, work):
    os.makedirs(work, exist_ok=True)
    small = build(cmake, source, work)
    loaded = run("ldd", small)
    assert "libhdf5" in loaded and not re.search("trilinos|libmpi", loaded), loaded
    shutil.copy(case, os.path.join(work, "case.toml"))
    run(os.path.join(programs, "tiprub-mesh"), "case.toml", "-q", cwd=work)
    run(os.path.join(programs, "tiprub-reduce"), "case.toml", "sector.msh", "-q", cwd=work)
    responses = []
    for program in (small, os.path.join(programs, "tiprub-simulate")):
        run(program, "case.toml", "model.h5", "-q", cwd=work)
        with open(os.path.join(work, "response.h5"), "rb") as file:
            responses.append(file.read())
        os.remove(os.path.join(work, "response.h5"))
    assert responses[0] == responses[1], "the responses of the two programs differ"
    for environment, options, code, message in REFUSALS:
        done = subprocess.run([small, "case.toml", "model.h5", *options], cwd=work, env={**os.environ, **environment}, text=True,
                              stderr=subprocess.PIPE, check=False)
        assert done.returncode == code and message in done.stderr, (options, done)


if __name__ == "__main__":
    main(sys.argv[1], *map(os.path.abspath, sys.argv[2:]))
