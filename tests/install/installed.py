#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is installed works where there is no source: a case by make, the manual, completion in bash, and a program of somebody else's.

usage: installed.py CMAKE BUILD_FOLDER SMALL_CASE READER_FOLDER WORK_FOLDER
"""
import os
import re
import shutil
import subprocess
import sys

STAGES = ("mesh", "reduce", "simulate", "postprocess")


def run(*command, **options):
    done = subprocess.run(command, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options)
    assert done.returncode == 0, f"{command}:\n{done.stdout}"
    return done.stdout


def case_by_make(prefix, case, work):
    """Cases begin as copies of one; make finds the programs beside the cases."""
    folder = os.path.join(work, "my case")
    shutil.copytree(os.path.join(prefix, "share/tiprub/cases/impeller_quick"), folder)
    shutil.copy(case, os.path.join(folder, "case.toml"))
    said = run("make", f"TIPRUB={prefix}/share/tiprub", cwd=folder, env={"PATH": "/usr/bin:/bin", "HOME": work})
    assert "tiprub-mesh case.toml" in said, said
    for name in ("model.h5", "response.h5", "report/report.html"):
        assert os.path.getsize(os.path.join(folder, name)) > 0, name
    return folder


def only_sources(prefix):
    """Cases are installed without what their runs made."""
    for folder, _, names in os.walk(os.path.join(prefix, "share/tiprub")):
        parts = folder.split(os.sep)
        assert "report" not in parts and ".chain" not in parts, folder
        assert not [name for name in names if name.endswith((".h5", ".msh", ".part", ".cc", ".h"))], (folder, names)
    assert os.path.exists(os.path.join(prefix, "share/tiprub/cases/impeller_quick/expected/interaction_map.png"))


def manual(prefix):
    """Each option of each program."""
    for stage in STAGES:
        program = os.path.join(prefix, "bin", f"tiprub-{stage}")
        with open(os.path.join(prefix, f"share/man/man1/tiprub-{stage}.1"), encoding="utf-8") as file:
            page = file.read().replace("\\-", "-")
        options = set(re.findall(r"--[a-z][a-z-]+", run(program, "--help")))
        assert len(options) >= 8 and all(option in page for option in options), (stage, options)
        assert "EXIT STATUS" in page and run(program, "--version").split()[1] in page


def pages(prefix):
    """Their links lead somewhere, from the documentation and from the cases."""
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "structure"))
    import links  # pylint: disable=import-outside-toplevel,import-error
    for folder in ("share/doc/tiprub", "share/tiprub"):
        root = os.path.join(prefix, folder)
        found = list(links.pages(root))
        dead = [fault for page in found for fault in links.dead_links(root, page)]
        assert found and not dead, dead


def completed(prefix, folder, *words):
    """What bash offers for the last of the words."""
    script = (f"source '{prefix}/share/bash-completion/completions/tiprub-simulate'; compopt() {{ :; }}; COMP_WORDS=(\"$@\"); "
              '_tiprub "$1" "${@: -1}" "${@: -2:1}"; printf "%s\\n" "${COMPREPLY[@]}"')
    return run("bash", "-c", script, "bash", os.path.join(prefix, "bin/tiprub-simulate"), *words, cwd=folder).split()


def completion(prefix, folder):
    assert completed(prefix, folder, "--thr") == ["--threads"]
    assert {"--help", "--output", "--check", "-q"} <= set(completed(prefix, folder, "-"))
    assert completed(prefix, folder, "case.toml", "--set", "casing.lo") == ["casing.lobes="]
    assert completed(prefix, folder, "case.toml", "--set", "simulate.sw") == ["simulate.sweep="]


def python(prefix, folder, work):
    """The package finds the installed cases and programs."""
    script = ("import sys, tiprub; folder = sys.argv[1] + '/'; files = {'MODEL': folder + 'model.h5', 'FIELDS': folder + 'fields.h5'}; "
              "print(tiprub.__file__, len(tiprub.run(folder + 'case.toml', progress=False, **files).sweep.rpm))")
    environment = {"PATH": "/usr/bin:/bin", "HOME": work, "PYTHONPATH": os.path.join(prefix, "lib/python3/dist-packages")}
    place, speeds = run(sys.executable, "-B", "-c", script, folder, cwd=work, env=environment).split()
    assert place.startswith(prefix) and speeds == "4", (place, speeds)


def make_without_reduce(prefix, work):
    """What make says where tiprub-reduce is not installed."""
    folder = os.path.join(work, "without reduce")
    shutil.copytree(os.path.join(prefix, "share/tiprub/cases/impeller_quick"), folder)
    done = subprocess.run(["make", f"TIPRUB={prefix}/share/tiprub"], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          env={"PATH": "/usr/bin:/bin", "HOME": work}, check=False)
    assert done.returncode != 0 and not os.path.exists(os.path.join(folder, "model.h5")), done
    return done.stdout


def components(cmake, build, work):
    """Only one of them holds tiprub-reduce, which needs deal.II: its program, its manual and its completion."""
    held = {}
    for component in ("programs", "reduce", "python", "development"):
        prefix = os.path.join(work, "components", component)
        run(cmake, "--install", build, "--prefix", prefix, "--component", component)
        held[component] = {os.path.relpath(os.path.join(folder, name), prefix) for folder, _, names in os.walk(prefix) for name in names}
    of_reduce = {"bin/tiprub-reduce", "share/man/man1/tiprub-reduce.1", "share/bash-completion/completions/tiprub-reduce"}
    assert held["reduce"] == of_reduce, held["reduce"]
    assert {f"bin/tiprub-{stage}" for stage in STAGES} - of_reduce == {name for name in held["programs"] if name.startswith("bin/")}
    said = make_without_reduce(os.path.join(work, "components", "programs"), work)
    assert "tiprub-reduce is neither in" in said and "on Debian it is in the package tiprub-reduce" in said, said
    libraries = {os.path.basename(name) for name in held["development"] if name.endswith(".a")}
    assert libraries == {f"libtiprub_{part}.a" for part in ("files", "cells", "model_file", "response_file")}, libraries


def reader(cmake, prefix, source, folder, work):
    """Of other libraries, it needs Eigen, HDF5, BLAS and LAPACK alone."""
    with open(os.path.join(prefix, "lib/cmake/Tiprub/TiprubTargets.cmake"), encoding="utf-8") as file:
        targets = file.read()
    assert "hdf5" in targets and not re.search("CLI11|tomlplusplus", targets), targets
    built = os.path.join(work, "reader")
    run(cmake, "-S", source, "-B", built, f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Debug")
    run(cmake, "--build", built)
    printed = run(os.path.join(built, "reader"), os.path.join(folder, "model.h5"), os.path.join(folder, "response.h5"))
    assert printed.split() == ["6", "4"], printed


def main(cmake, build, case, source, work):
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    prefix = os.path.join(work, "prefix")
    run(cmake, "--install", build, "--prefix", prefix)
    folder = case_by_make(prefix, case, work)
    only_sources(prefix)
    manual(prefix)
    pages(prefix)
    completion(prefix, folder)
    python(prefix, folder, work)
    reader(cmake, prefix, source, folder, work)
    components(cmake, build, work)


if __name__ == "__main__":
    main(sys.argv[1], *map(os.path.abspath, sys.argv[2:]))
