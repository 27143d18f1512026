#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""make after an interruption. usage: interrupted.py PROGRAMS_FOLDER CASES_FOLDER SMALL_CASE WORK_FOLDER (made by small_chain.py)

Each program, and sha256sum, is replaced by a script that sends a signal at one moment of one make.
"""
import os
import shutil
import signal
import subprocess
import sys
import time

import small_chain

SCRIPT = """#!/bin/sh
stop() {{
  test "$1 {name}" = "$MOMENT" || return
  if test "$WHOM" = make; then kill -s "$SIGNAL" "$(ps -o pgid= -p $$ | tr -d ' ')"; else kill -s "$SIGNAL" 0; fi
}}
case " $* " in
  *" $FILE "*) ;;
  *) MOMENT=never ;;
esac
stop before
'{program}' "$@"
code=$?
stop after
exit $code
"""


def write_programs(bench, real):
    bench.programs = os.path.join(bench.work, "bin")
    os.makedirs(bench.programs)
    for name in (*(f"tiprub-{program}" for program in small_chain.PROGRAMS), "sha256sum"):
        path = os.path.join(bench.programs, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(SCRIPT.format(name=name, program=shutil.which(name, path=real + ":" + os.environ["PATH"])))
        os.chmod(path, 0o755)


def stop(bench, folder, signal_name, moment, file, whom="all"):
    """make, stopped "before PROGRAM" or after it has run with the file among its arguments; whom: make alone, or all its processes."""
    stopping = {"SIGNAL": signal_name, "MOMENT": moment, "FILE": file, "WHOM": whom}
    process = subprocess.Popen(folder.command(), env={**bench.environment, **stopping}, start_new_session=True, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    said = process.communicate()[0]  # which all its processes write to
    assert process.returncode != 0, said


def killed(bench):
    """Symptom: a file that was finished when all processes were killed was nobody's: make refused to go on, and kept it."""
    folder = bench.empty("killed")
    left = list(small_chain.PROGRAMS)
    for program, file in (("mesh", "sector.msh"), ("reduce", "model.h5"), ("simulate", "response.h5")):
        stop(bench, folder, "KILL", "after tiprub-" + program, file)
        left.remove(program)
        assert folder.would_run() == left, (file, folder.would_run())
    folder.must_make("clean")
    assert sorted(os.listdir(folder.path)) == ["Makefile", "case.toml"]
    stop(bench, folder, "KILL", "before sha256sum", "sector.msh")
    folder.must_make("clean")
    assert sorted(os.listdir(folder.path)) == ["Makefile", "case.toml"]


def ended(bench):
    """Symptom: Ctrl-C while make noted the digest of a finished sweep removed the sweep."""
    for file, lines, left in (("fields.h5", ("density = 4430.0", "density = 4431.0"), ["simulate", "postprocess"]),
                              ("response.h5", ("lobes = 2", "lobes = 3"), ["postprocess"])):
        folder = bench.folder("ended_" + file)
        folder.write("case.toml", bench.case.replace(*lines))
        stop(bench, folder, "INT", "before sha256sum", file)
        assert folder.would_run() == left, folder.would_run()


def make_alone(bench):
    """What a program finishes after make was killed is make's own."""
    folder = bench.folder("make_alone")
    folder.write("case.toml", bench.case.replace("lobes = 2", "lobes = 3"))
    stop(bench, folder, "KILL", "before tiprub-simulate", "response.h5", "make")
    assert folder.would_run() == ["postprocess"], folder.would_run()


def own_file(bench):
    """A file that the user puts in after Ctrl-C stays."""
    folder = bench.empty("own_file")
    folder.must_make("sector.msh")
    stop(bench, folder, "INT", "before tiprub-reduce", "model.h5")
    folder.write("model.h5", "mine")
    folder.must_refuse("model.h5: make did not make it")
    folder.must_make("clean")
    assert folder.read("model.h5") == b"mine"


def no_half_file(bench):
    """No half file, and no note of one."""
    folder = bench.empty("interrupted")
    for wait in (0.05, 0.2, 0.4, 0.8):
        process = subprocess.Popen(folder.command(), env=bench.environment, start_new_session=True, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.DEVNULL)
        time.sleep(wait)
        os.killpg(process.pid, signal.SIGINT)
        process.wait()
    folder.must_make()
    for name in small_chain.MODEL_FILES:
        assert folder.read(name) == open(os.path.join(bench.made, name), "rb").read(), name
    assert not [name for name in folder.files() if ".part" in name or ".speeds" in name]


def interrupted(bench):
    no_half_file(bench)
    write_programs(bench, bench.programs)
    for step in (killed, ended, make_alone, own_file):
        step(bench)


if __name__ == "__main__":
    small_chain.STEPS += (interrupted,)
    small_chain.main("interrupted", *sys.argv[1:])
