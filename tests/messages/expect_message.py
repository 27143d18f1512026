#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad input in, exact exit code and key phrases out: runs a program in a folder that holds its inputs only.

usage: expect_message.py FOLDER KEYWORD VALUE... KEYWORD VALUE...   (the last one of a keyword counts)

    PROGRAM program...    ARGUMENTS argument...   the command
    INPUTS file[=name]...   what is copied into the folder
    KEY key LINE line       what the line "key = ..." of case.toml becomes
    FILE name OLD text NEW text   what a text of an input (case.toml, if not said) becomes
    EXIT_CODE code          0, if not said
    ERRORS phrase...        what comes on stderr; an error is one line with the program's name
    OUTPUTS phrase...       what comes on stdout, which is for data: it is empty, if not said
    WRITES name...          the new files, all of them: none, if not said
"""
import os
import re
import shutil
import subprocess
import sys

DEFAULTS = {"PROGRAM": [], "ARGUMENTS": [], "INPUTS": [], "KEY": [], "LINE": [], "FILE": ["case.toml"], "OLD": [], "NEW": [],
            "EXIT_CODE": ["0"], "ERRORS": [], "OUTPUTS": [], "WRITES": []}
ERROR_LINE = re.compile(r"tiprub-\w+: error: [^\n]+\n")


def parsed(arguments):
    values, keyword = dict(DEFAULTS), None
    for argument in arguments:
        if argument in DEFAULTS:
            keyword = argument
            values[keyword] = []
        else:
            values[keyword].append(argument)
    assert values["PROGRAM"], "no PROGRAM is named"
    return values


def change(path, pattern, replacement):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    other = re.sub(pattern, lambda match: replacement, text, flags=re.M)
    assert other != text, f"{path} holds nothing like {pattern} to change"
    with open(path, "w", encoding="utf-8") as file:
        file.write(other)


def fill(folder, values):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    for given in values["INPUTS"]:
        path, _, name = given.partition("=")
        shutil.copy(path, os.path.join(folder, name or os.path.basename(path)))
    if values["KEY"]:
        change(os.path.join(folder, "case.toml"), rf"^{re.escape(*values['KEY'])} = .*$", *values["LINE"])
    if values["OLD"]:
        change(os.path.join(folder, *values["FILE"]), re.escape(*values["OLD"]), *values["NEW"])


def main(folder, *arguments):
    values = parsed(arguments)
    fill(folder, values)
    before = set(os.listdir(folder))
    run = subprocess.run(values["PROGRAM"] + values["ARGUMENTS"], cwd=folder, text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.PIPE)
    said = f"\nstdout: {run.stdout}\nstderr: {run.stderr}"
    assert run.returncode == int(*values["EXIT_CODE"]), f"exit code {run.returncode}{said}"
    for keyword, text in (("ERRORS", run.stderr), ("OUTPUTS", run.stdout)):
        for phrase in values[keyword]:
            assert phrase in text, f"{keyword}: \"{phrase}\" does not come out{said}"
    assert values["OUTPUTS"] or not run.stdout, f"stdout is for data, but it holds text{said}"
    assert run.returncode == 0 or ERROR_LINE.fullmatch(run.stderr), f"an error is one line with the program's name{said}"
    new = sorted(set(os.listdir(folder)) - before)
    assert new == sorted(values["WRITES"]), f"new files: {new}, expected: {sorted(values['WRITES'])}{said}"


if __name__ == "__main__":
    main(*sys.argv[1:])
