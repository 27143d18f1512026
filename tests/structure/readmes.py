#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The READMEs' tables of files match the folders.

usage: readmes.py ROOT

A room's README.md has a heading "### <folder>/" for each folder of sources ("### <room>/" for the room's own), and under it
a table whose first cells name the folder's files in backticks: `stem` of a header and its .cc, or `name.end`.
"""
import os
import re
import sys

import source_tree

HEADING = re.compile(r"^#+ .*$", re.M)
FOLDER_HEADING = re.compile(r"^### `?([\w/]+)/`?$")
ROW = re.compile(r"^\| *(`[^|]*?) *\|", re.M)
NAME = re.compile(r"`([^`]+)`")


def tables_of(text):
    """Folder -> names in the first cells below its heading."""
    tables, marks = {}, [*HEADING.finditer(text)]
    for mark, following in zip(marks, [*marks[1:], None]):
        heading = FOLDER_HEADING.match(mark.group())
        if heading:
            below = text[mark.end():following.start() if following else len(text)]
            tables[heading[1]] = {name for row in ROW.findall(below) for name in NAME.findall(row)}
    return tables


def folders_of(root, room):
    """Folder below the room -> its source files; a case has a README of its own, and no storey."""
    folders = {}
    for path in source_tree.files(root, (room,)):
        folder, name = os.path.split(path)
        if name != "CMakeLists.txt" and not os.path.exists(os.path.join(root, folder, "case.toml")):
            folders.setdefault(os.path.relpath(folder, room) if folder != room else room, []).append(name)
    return folders


def faults_of_room(root, room):
    readme = f"{room}/README.md"
    if not os.path.exists(os.path.join(root, readme)):
        yield f"{readme}: no such file"
        return
    tables, folders = tables_of(source_tree.read(root, readme)), folders_of(root, room)
    for folder, names in folders.items():
        if room == "cases" and os.path.exists(os.path.join(root, room, folder, "README.md")):
            continue
        if folder not in tables:
            yield f'{readme}: has no heading "### {folder}/" with a table of its {len(names)} files'
            continue
        for name in names:
            if not {name, os.path.splitext(name)[0]} & tables[folder]:
                yield f"{readme}: ### {folder}/ does not name {name}"
        known = {*names, *(os.path.splitext(name)[0] for name in names)}
        for name in sorted(tables[folder] - known):
            yield f"{readme}: ### {folder}/ names {name}, which is no file there"
    for folder in sorted(set(tables) - set(folders)):
        yield f"{readme}: ### {folder}/ is no folder with sources"


def main(root):
    faults = [fault for room in source_tree.ROOMS for fault in faults_of_room(root, room)]
    source_tree.report(faults, "the tables of files match the folders")


if __name__ == "__main__":
    main(sys.argv[1])
