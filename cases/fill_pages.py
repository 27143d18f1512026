#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Fills the marked cells of the pages, <!-- KEY -->value<!---->, from the tables beside them.

usage: fill_pages.py           writes README.md of all cases and of tests/benchmark, and the project's first page
       fill_pages.py --check   fails if a page differs from its tables

A case's expected/*numbers.tsv hold a key and its value in a line. A KEY that names a table of expected/, NAME.tsv or NAME.csv, stands for
the whole table. budget:PEAK:SOURCE:COLUMN looks into expected/error_budget.csv: PEAK counts the critical speeds from 1, or is "largest" for that
with the largest motion of the tip; SOURCE has "_" for blanks; COLUMN is a key of BUDGET_COLUMNS. A key of another case, and each on the first
page, begins with the name of the case: impeller_quick/largest.rpm.
"""
import csv
import glob
import os
import re
import sys

CASES = os.path.dirname(os.path.abspath(__file__))
FIRST_PAGE = os.path.join(CASES, "..", "README.md")
BENCHMARK_PAGE = os.path.join(CASES, "..", "tests", "benchmark", "README.md")
CELL = re.compile(r"<!-- (\S+) -->(.*?)<!---->", re.S)
HTML = re.compile(r"^<!-- (\S+) -->[^\n]", re.M)  # Markdown takes the line for HTML, and ends the paragraph
SEPARATORS = {".tsv": "\t", ".csv": ","}
BUDGET_COLUMNS = {"rpm": ("speed [rpm]", ",.0f"), "u_mm": ("tip |u| [mm]", ".2f"), "mpa": ("stress [MPa]", ",.0f"),
                  "speed": ("change of speed [%]", "+.1f"), "u": ("change of |u| [%]", "+.0f"), "stress": ("change of stress [%]", "+.0f")}


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.reader(file, delimiter=SEPARATORS[os.path.splitext(path)[1]]))


def rounded(value, form):
    """The value as text. A zero has no sign."""
    text = format(value, form)
    return text if any(digit in "123456789" for digit in text) else text.lstrip("+-")


def numbers_of(folder):
    """{key: value} of a case's tables of numbers."""
    return {key: value for path in sorted(glob.glob(os.path.join(folder, "expected", "*numbers.tsv"))) for key, value in rows_of(path)[1:]}


def table_of(path):
    """A table as Markdown."""
    head, *rows = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows_of(path)]
    return "\n".join(["", head, "|" + "---|" * len(rows_of(path)[0]), *rows, ""])


def in_budget(key, folder):
    """What a source of the error budget changes at a critical speed, rounded; None where there is no such source."""
    _, peak, source, column = key.split(":")
    path = os.path.join(folder, "expected", "error_budget.csv")
    if not os.path.exists(path):
        return None
    head, *lines = rows_of(path)
    rows = [dict(zip(head, line)) for line in lines]
    peaks = [row for row in rows if row["source"] == "as computed"]
    chosen = max(peaks, key=lambda row: float(row["tip |u| [mm]"])) if peak == "largest" else peaks[int(peak) - 1]
    name, form = BUDGET_COLUMNS[column]
    values = [float(row[name]) for row in rows
              if row["critical speed [rpm]"] == chosen["critical speed [rpm]"] and row["source"].replace(" ", "_") == source]
    return rounded(values[0], form) if values else None


def value_of(key, folder, numbers, page):
    if key.startswith("budget:"):
        numbers = {key: value for value in [in_budget(key, folder)] if value}
    if os.path.splitext(key)[1] in SEPARATORS:
        path = os.path.join(folder, "expected", key)
        if os.path.exists(path):
            return table_of(path)
    if key not in numbers:
        sys.exit(f"{page}: the cell {key} stands in no table of {os.path.join(folder, 'expected')}")
    return numbers[key]


def filled(text, page):
    """The text of a page with the values that its tables have now."""
    def cell(match):
        folder, _, key = match[1].rpartition("/")
        folder = os.path.join(CASES, folder) if folder else os.path.dirname(page)
        return f"<!-- {match[1]} -->{value_of(key, folder, numbers_of(folder), os.path.relpath(page, CASES))}<!---->"

    return CELL.sub(cell, text)


def main(check):
    stale = []
    pages = sorted(glob.glob(os.path.join(CASES, "*", "README.md"))) + [FIRST_PAGE, BENCHMARK_PAGE]
    for page in filter(os.path.exists, pages):  # an installation has only those of the cases here
        with open(page, encoding="utf-8") as file:
            text = file.read()
        new = filled(text, page)
        if breaks := HTML.findall(text):
            sys.exit(f"{os.path.relpath(page, CASES)}: the cell {breaks[0]} begins a line; put a word before it")
        if new != text:
            stale.append(os.path.relpath(page, CASES))
            if not check:
                with open(page, "w", encoding="utf-8") as file:
                    file.write(new)
    if check and stale:
        sys.exit(f"{' and '.join(stale)}: differs from the tables of its case; run cases/fill_pages.py")


if __name__ == "__main__":
    main("--check" in sys.argv)
