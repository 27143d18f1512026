#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes checks.md and expected/check_numbers.tsv from the tables of the checks: how many hold, and what each has measured.

usage: tell_checks.py           writes both
       tell_checks.py --check   fails if they differ from the tables
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
WHEELS = {"paper_like": "paper-like wheel", "flying": "flying wheel"}
WORDS = {"holds": "holds", "does not hold on this wheel": "**does not hold**", "by construction": "by construction", "can't be made": "**can't be made**"}
CHECKS = 81


def rows_of(wheel):
    """[[number, place, text, verdict, measured]]; none if the table is missing."""
    path = os.path.join(HERE, "expected", f"checks_{wheel}.tsv")
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as file:
        return [line.rstrip("\n").split("\t") for line in file][1:]


def counts(tables):
    """How many checks hold, and what each has measured."""
    holding = {wheel: {int(row[0]) for row in rows if row[3] == "holds"} for wheel, rows in tables.items()}
    either = set.union(*holding.values())
    return {"checks.either": str(len(either)), "checks.neither": ", ".join(map(str, sorted(set(range(1, CHECKS + 1)) - either))),
            **{f"checks.{wheel}": str(len(found)) for wheel, found in holding.items()},
            **{f"check.{row[0]}.{wheel}": row[4] for wheel, rows in tables.items() for row in rows}}


def page_of_checks(tables, numbers):
    lines = ["# The 81 checks", "",
             "`make paper-checks` checks on both wheels of [this page](README.md) what a reproduction of the",
             f"paper must show. {numbers['checks.paper_like']} checks hold on the paper-like wheel, {numbers['checks.flying']} on the flying wheel and "
             f"{numbers['checks.either']} on at least", "one of them. `expected/checks_*.tsv` has the measured values.", "",
             "| | in the paper | check | " + " | ".join(WHEELS.values()) + " |", "|---|---|---|---|---|"]
    bar = "\\|"
    for both in zip(*tables.values()):
        lines.append(f"| {both[0][0]} | {both[0][1]} | {both[0][2].replace('|', bar)} | " + " | ".join(WORDS[row[3]] for row in both) + " |")
    return "\n".join(lines) + "\n"


def main(check):
    tables = {wheel: rows_of(wheel) for wheel in WHEELS}
    numbers = counts(tables)
    pages = {"checks.md": page_of_checks(tables, numbers),
             os.path.join("expected", "check_numbers.tsv"): "key\tvalue\n" + "".join(f"{key}\t{value}\n" for key, value in numbers.items())}
    stale = []
    for name, text in pages.items():
        path = os.path.join(HERE, name)
        before = open(path, encoding="utf-8").read() if os.path.exists(path) else ""
        if text != before:
            stale.append(name)
            if not check:
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
    if check and stale:
        sys.exit(f"{' and '.join(stale)}: differs from the tables in cases/paper/expected; run cases/paper/tell_checks.py")


if __name__ == "__main__":
    main("--check" in sys.argv)
