#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Inputs with one thing wrong, and the message that each must give: one line with the file and what is wrong, no output, no new file.

    corpus.py STAGE PROGRAMS_FOLDER SCENE_FOLDER WORK_FOLDER

STAGE is case, mesh, matrices, model, fields, response or splitters; corpus_STAGE.py holds its ENTRIES.
"""
import concurrent.futures
import importlib
import os
import re
import shutil
import subprocess
import sys
from typing import Callable, NamedTuple

INPUTS = {"mesh": [], "reduce": ["sector.msh"], "simulate": ["model.h5"], "postprocess": ["model.h5", "response.h5"]}
ERROR_LINE = re.compile(r"tiprub-\w+: error: [^\x00-\x1f\x7f]+\n")


class Entry(NamedTuple):
    name: str         # words of its folder
    program: str      # "reduce"
    file: str         # the one that is changed
    change: Callable  # of its path
    code: int
    phrase: str
    options: tuple = ()


def wrong(entry, programs, scene, work):
    """What is wrong with the answer to an entry; nothing if it is right."""
    folder = os.path.join(work, entry.name)
    os.makedirs(folder)
    for name in os.listdir(scene):
        if name != entry.file:
            os.symlink(os.path.join(scene, name), os.path.join(folder, name))
    shutil.copy(os.path.join(scene, entry.file), folder)
    entry.change(os.path.join(folder, entry.file))
    before = set(os.listdir(folder))
    inputs = [] if "--matrices" in entry.options else INPUTS[entry.program]
    run = subprocess.run([os.path.join(programs, f"tiprub-{entry.program}"), "case.toml", *inputs, *entry.options, "--check"],
                         cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=30, check=False)
    said = run.stderr.decode(errors="backslashreplace")
    faults = [fault for holds, fault in (
        (run.returncode == entry.code, f"exit code {run.returncode}, not {entry.code}"),
        (ERROR_LINE.fullmatch(said), "not one line"), (entry.file in said, f"{entry.file} is not named"),
        (entry.phrase in said, f"without: {entry.phrase}"), (not run.stdout, "writes on stdout"),
        (set(os.listdir(folder)) == before, "leaves files")) if not holds]
    shutil.rmtree(folder)
    return f"{entry.name}: {'; '.join(faults)}: {said.strip()}" if faults else ""


def main(stage, programs, scene, work):
    entries = importlib.import_module(f"corpus_{stage}").ENTRIES
    shutil.rmtree(work, ignore_errors=True)
    names = [entry.name for entry in entries]
    assert len(set(names)) == len(names), "names must differ"
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        faults = [*filter(None, pool.map(lambda entry: wrong(entry, programs, scene, work), entries))]
    print("\n".join(faults))
    print(f"{len(entries) - len(faults)} of {len(entries)} inputs give the message that they must give")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main(sys.argv[1], *map(os.path.abspath, sys.argv[2:]))
