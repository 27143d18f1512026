#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Damaged studies: each must be refused with one line, or become folders and Makefiles inside of the folder of the runs.

usage: study_reader.py CASES_FOLDER WORK_FOLDER

FUZZ_SEED and FUZZ_INPUTS as for tiprub_fuzz. A study on which the reader fails is kept in WORK_FOLDER.
"""
import os
import random
import re
import shutil
import signal
import sys

HOSTILE = ["", ".", "..", "../../x", "/tmp/x", "a/b", "$(shell touch ran)", "${x}", "`x`", "a b", "#", "\\", "\\n", "'", '"', "\x00", "\n", "\t",
           "\u202e", "\u2028", "<img src=x>", "=1+1", "-o", ":", "%", "x" * 5000, "[" * 2000, "1e999", "nan", "-inf", "9" * 400, "true", "{}", "[]",
           "[1, 2]", "1979-05-27", "{a = 1, b = 2}", "grid", "points", "settings", "values", "key", "[grid.x]", "[points.x]", "[[points]]", "= 1"]
FOLDERS = re.compile(r"(meshes|models|points)/[A-Za-z0-9_][A-Za-z0-9_+.-]*")
RICH = """title = "All"
case = "case.toml"
model = "model.h5"
fields = "fields.h5"
settings = {"simulate.damping_ratio" = 0.01, "postprocess.engine_order_max" = 6}
[grid.lobes]
key = "casing.lobes"
values = [2, 3]
unit = "1"
[grid.clearance]
key = "casing.clearance"
values = {"0.13" = [[0.0, 0.13e-3]], "0.12" = [[0.0, 0.12e-3]]}
[points.heavy]
"reduce.density" = 8000
"simulate.scheme" = "trigonometric"
"""


def damaged(text, chance):
    pieces = re.findall(r"\w+|\s+|.", text)
    for _ in range(chance.choice((1, 1, 2, 5))):
        at = chance.randrange(len(pieces))
        chance.choice((
            lambda: pieces.insert(at, chance.choice(HOSTILE)), lambda: pieces.__setitem__(at, chance.choice(HOSTILE)),
            lambda: pieces.__setitem__(at, ""), lambda: pieces.insert(at, pieces[chance.randrange(len(pieces))]),
            lambda: pieces.__setitem__(slice(at, at + chance.randrange(20)), [""]),
            lambda: pieces.__setitem__(at, pieces[at][:-1] + chr(chance.choice((0, 9, 34, 36, 127, 255, 0x202e, 0x1f600))))))()
    data = "".join(pieces).encode()
    if chance.random() < 0.1:
        data = data[:chance.randrange(len(data) + 1)]
    if chance.random() < 0.1:
        data += bytes([chance.randrange(256)])
    return data


def fault_of(study, path, runs):
    """"accepted" or "refused", and what is wrong with it."""
    try:
        read = study.Study(path)
        folders = study.Folders(read, "programs", "/chain.mk", runs)
        for name, (_, settings) in read.points.items():
            folders.point(name, settings)
    except study.Wrong as wrong:
        return "refused", "" if str(wrong) and str(wrong).isprintable() else "is no line: " + repr(str(wrong))
    made = {os.path.relpath(os.path.join(root, file), runs) for root, _, files in os.walk(runs) for file in files}
    wanted = {f"{name}/Makefile" for kind in folders.waits.values() for name in kind}
    if made != wanted or not all(FOLDERS.fullmatch(os.path.dirname(name)) for name in made):
        return "accepted", f"has the folders {sorted(made ^ wanted)}"
    for name in made:
        with open(os.path.join(runs, name), encoding="utf-8") as file:
            lines = file.read().replace("$(HASH)", "").replace("$$", "").split("\n")
        if "$" in "".join(lines) or not all(line.isprintable() for line in lines) or not lines[-2].startswith("include "):
            return "accepted", f"{name} holds more than its variables"
    return "accepted", ""


def main(cases, work):
    sys.path.insert(0, os.path.join(cases, "study"))
    import study  # pylint: disable=import-outside-toplevel
    study.tables = lambda programs, stage, case, settings: stage + "\0".join(settings)  # what the programs would say
    shutil.rmtree(work, ignore_errors=True)
    path, runs = os.path.join(work, "study.toml"), os.path.join(work, "runs")
    os.makedirs(work)
    with open(os.path.join(cases, "study", "study.toml"), encoding="utf-8") as file:
        bases = [file.read(), RICH, RICH.replace('model = "model.h5"\nfields = "fields.h5"', 'mesh = "sector.msh"')]
    seed, count = int(os.environ.get("FUZZ_SEED", 12)), int(os.environ.get("FUZZ_INPUTS", 300))
    chance, tally = random.Random(seed), {"accepted": 0, "refused": 0, "wrong": 0}
    for index in range(count):
        with open(path, "wb") as file:
            file.write(damaged(chance.choice(bases), chance))
        shutil.rmtree(runs, ignore_errors=True)
        signal.alarm(60)
        try:
            verdict, fault = fault_of(study, path, runs)
        except Exception as error:  # pylint: disable=broad-except
            verdict, fault = "refused", f"{type(error).__name__}: {error}"
        signal.alarm(0)
        tally["wrong" if fault else verdict] += 1
        if fault:
            kept = shutil.copy(path, os.path.join(work, f"study-{seed}-{index}.toml"))
            print(f"{kept}: {fault[:300]}", file=sys.stderr)
    print(f"study: seed {seed}, {count} inputs: " + ", ".join(f"{number} {word}" for word, number in tally.items()))
    sys.exit(tally["wrong"] > 0)


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
