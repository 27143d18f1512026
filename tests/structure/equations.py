#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""cases/equations.md leads from each of the paper's equations 1 to 21 to the function that computes it, and to its test.

usage: equations.py ROOT

A row is | N | what it says | `symbol` in `room/folder/stem` | `Suite.Test` or `function` in `tests/room/file` |. The symbol
must stand in the stem's header or .cc, and the test in its file, and both files must hold "eq. N" in a comment.
"""
import os
import re
import sys

import source_tree

EQUATIONS = range(1, 22)
INDEX = "cases/equations.md"
ROW = re.compile(r"^\| *(\d+) *\|[^|]*\| *`([^`]+)` in `([^`]+)`[^|]*\| *`([^`]+)` in `([^`]+)`[^|]*\|$", re.M)


def texts_of(root, stem):
    """The files that a stem or a path names, as one text."""
    paths = [stem, stem + ".h", stem + ".cc", stem + ".py"]
    return "\n".join(source_tree.read(root, path) for path in paths if os.path.isfile(os.path.join(root, path)))


def holds_test(text, name):
    if "." in name:
        return re.search(r"\bTEST(?:_[FP])?\(\s*" + r"\s*,\s*".join(map(re.escape, name.split("."))) + r"\s*\)", text)
    return re.search(rf"\bdef {re.escape(name)}\b", text)


def faults_of_row(root, number, symbol, place, test, test_place):
    cites = re.compile(rf"\beq\. {number}\b")
    text, test_text = texts_of(root, place), texts_of(root, test_place)
    if not text:
        yield f"{place}: no such file"
    elif not re.search(rf"\b{re.escape(symbol.split('::')[-1])}\b", text):
        yield f"{place}: holds no {symbol}"
    elif not cites.search(text):
        yield f'{place}: no comment says "eq. {number}"'
    if not test_text:
        yield f"{test_place}: no such file"
    elif not holds_test(test_text, test):
        yield f"{test_place}: holds no test {test}"
    elif not cites.search(test_text):
        yield f'{test_place}: no comment says "eq. {number}"'


def main(root):
    faults, rows = [], {}
    for number, *columns in ROW.findall(source_tree.read(root, INDEX)):
        rows[int(number)] = columns
    for number in EQUATIONS:
        if number not in rows:
            faults.append(f"{INDEX}: has no row for eq. {number}")
        else:
            faults += [f"{INDEX}: eq. {number}: {fault}" for fault in faults_of_row(root, number, *rows[number])]
    source_tree.report(faults, f"{len(rows)} equations lead to their functions and tests")


if __name__ == "__main__":
    main(sys.argv[1])
