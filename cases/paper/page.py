#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills the marked cells of README.md and of the project's first page, <!-- KEY -->value<!---->, from expected/numbers.tsv, and writes
checks.md from the tables of the checks.

usage: page.py           writes both pages
       page.py --check   fails if they differ from the tables
"""
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
CELL = re.compile(r"<!-- (\S+) -->(.*?)<!---->", re.S)
FIRST_PAGE = os.path.join("..", "..", "README.md")
WHEELS = {"paper_like": "paper-like wheel", "flying": "flying wheel"}
WORDS = {"holds": "holds", "does not hold on this wheel": "**does not hold**", "by construction": "by construction", "can't be made": "**can't be made**"}


def rows_of(name):
    """Rows of a table as lists; none if it is missing."""
    path = os.path.join(HERE, "expected", name + ".tsv")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return [line.rstrip("\n").split("\t") for line in file][1:]


def checks():
    """{wheel: [[number, place, text, verdict, measured]]}"""
    return {wheel: rows_of(f"checks_{wheel}") for wheel in WHEELS}


def counts(tables):
    """How many checks hold, and what each has measured."""
    holding = {wheel: {int(row[0]) for row in rows if row[3] == "holds"} for wheel, rows in tables.items()}
    either = set.union(*holding.values())
    return {"checks.either": str(len(either)), "checks.neither": ", ".join(map(str, sorted(set(range(1, 82)) - either))),
            **{f"checks.{wheel}": str(len(found)) for wheel, found in holding.items()},
            **{f"check.{row[0]}.{wheel}": row[4] for wheel, rows in tables.items() for row in rows}}


def table_of(name):
    """A table as Markdown."""
    with open(os.path.join(HERE, "expected", name + ".tsv"), encoding="utf-8") as file:
        head, *rows = ["| " + line.rstrip("\n").replace("\t", " | ") + " |" for line in file]
    return "\n".join(["", head, "|" + "---|" * (head.count(" | ") + 1), *rows, ""])


def filled(page, numbers):
    def cell(match):
        if match[1] not in numbers:
            sys.exit(f"a page asks for {match[1]}, which no table has")
        return f"<!-- {match[1]} -->{numbers[match[1]]}<!---->"

    return CELL.sub(cell, page)


def page_of_checks(tables, numbers):
    lines = ["# The 81 checks", "",
             f"`make paper-checks` asks on both wheels of [this page](README.md) what a reproduction of the paper must show. {numbers['checks.paper_like']} "
             f"of the 81 checks hold on the paper-like wheel, {numbers['checks.flying']} on the flying wheel and {numbers['checks.either']} on at least one of them. "
             "`expected/checks_*.tsv` tell what was measured.", "",
             "| | in the paper | check | " + " | ".join(WHEELS.values()) + " |", "|---|---|---|---|---|"]
    bar = "\\|"
    for both in zip(*tables.values()):
        lines.append(f"| {both[0][0]} | {both[0][1]} | {both[0][2].replace('|', bar)} | " + " | ".join(WORDS[row[3]] for row in both) + " |")
    return "\n".join(lines) + "\n"


def main(check):
    tables = checks()
    numbers = {**dict(rows_of("numbers")), **counts(tables), "tried": table_of("tried")}
    stale = []
    pages = {"README.md": lambda text: filled(text, numbers), FIRST_PAGE: lambda text: filled(text, numbers),
             "checks.md": lambda _: page_of_checks(tables, numbers)}
    for name, make in pages.items():
        path = os.path.join(HERE, name)
        if name == FIRST_PAGE and not os.path.exists(path):  # an installation keeps it elsewhere
            continue
        text = open(path, encoding="utf-8").read() if os.path.exists(path) else ""
        if make(text) != text:
            stale.append(name)
            if not check:
                with open(path, "w", encoding="utf-8") as file:
                    file.write(make(text))
    if check and stale:
        sys.exit(f"{' and '.join(stale)}: differs from the tables in cases/paper/expected; run cases/paper/page.py")


if __name__ == "__main__":
    main("--check" in sys.argv)
