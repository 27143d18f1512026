#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The points of a study in one table and on one page.

usage: comparison.py STUDY.toml RUNS_FOLDER REPORT_FOLDER

Reads the tables in the report of each point, and writes three files into the folder: study.csv with a line for each critical speed (the point, its place on
each axis, and all columns of critical_speeds.csv), study.txt with a line for each point, and study.html with links to the reports.
"""
import csv
import html
import json
import os
import subprocess
import sys

import study as studies

SPEED, AMPLITUDE, NOTE = "speed [rpm]", "amplitude [mm]", "no report"
STRESS, GOODMAN = "von Mises, both [MPa]", "Goodman utilisation [1]"


def rows_of(runs, point, table):
    """None if the point has no report."""
    try:
        with open(os.path.join(runs, "points", point, "report", table), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(file))
    except FileNotFoundError:
        return None


def verdict(runs, point):
    """The speeds to avoid, and why the report of the point is not trustworthy; empty if it is."""
    with open(os.path.join(runs, "points", point, "report", "summary.json"), encoding="utf-8") as file:
        said = json.load(file)["verdict"]
    return [said.get(answer, "") for answer in ("Avoid", "Not trustworthy")]


class Results:
    """The points in the study's order, each with its labels, its critical speeds, and its amplitude over speed."""

    def __init__(self, study, runs, report):
        self.study, self.runs, self.report = study, runs, report
        self.axes = [f"{name} [{unit}]" if unit else name for name, (unit, _) in study.axes.items()]
        self.points = [(name, labels, rows_of(runs, name, "critical_speeds.csv"), rows_of(runs, name, "speeds.csv"))
                       for name, (labels, _) in study.points.items()]

    def summary(self):
        """A line for each point: its largest amplitude, the largest stress of its critical speeds, these with their waves (of a mixed
        motion without), and the verdict."""
        yield ["point", *self.axes, "speeds", "failed", "largest amplitude [mm]", "at [rpm]", "stress with spin [MPa]", "Goodman", "critical speeds [rpm]",
               "speeds to avoid", "not trustworthy"]
        for name, labels, critical, speeds in self.points:
            if speeds is None:
                yield [name, *labels, NOTE, *8 * [""]]
                continue
            computed = [row for row in speeds if not row["failure"]]
            top = max(computed, key=lambda row: float(row[AMPLITUDE]), default={})
            yield [name, *labels, str(len(speeds)), str(len(speeds) - len(computed)), top.get(AMPLITUDE, "")[:6], rounded(top.get(SPEED)),
                   largest(critical, STRESS, 0), largest(critical, GOODMAN, 2),
                   ", ".join(f"{rounded(row[SPEED])} ({row['wave'].split(':')[0]})" for row in critical),
                   *verdict(self.runs, name)]

    def joint(self):
        """A line for each critical speed."""
        columns = next((list(rows[0]) for _, _, rows, _ in self.points if rows), [SPEED, AMPLITUDE])
        yield ["point", *self.axes, *columns]
        for name, labels, critical, _ in self.points:
            for row in critical or ():
                yield [name, *labels, *(row[column] for column in columns)]


def largest(rows, column, digits):
    """Of the rows that have a number there; empty if none has."""
    numbers = [float(row[column]) for row in rows if row.get(column)]
    return f"{max(numbers):.{digits}f}" if numbers else ""


def rounded(number):
    return f"{float(number):.0f}" if number else ""


STYLE = """set terminal svg size {width},{height} font "sans,13" background "white"
set grid lc rgb "#dddddd"
set key outside right
set ylabel "{ylabel}"
set xlabel "{xlabel}"
{more}
"""
COLOURS = ("#0060ad", "#dd181f", "#22a884", "#ff9900", "#7030a0", "#888888", "#00a0c0", "#a06000")


def quoted(text):
    """For gnuplot, within double quotes, where it runs what stands in backquotes, and where enhanced texts give a meaning to other signs."""
    harmless = text.replace("\\", "/").replace('"', "'").replace("`", "'")
    return "".join("\\\\" + sign if sign in "_^{}@&~" else sign for sign in harmless)


def draw(path, lines, width=1100, height=520, xlabel="", ylabel="", more=""):
    """Draws lines, each given as (title, style, rows of numbers), and returns the picture as SVG."""
    script = STYLE.format(width=width, height=height, xlabel=quoted(xlabel), ylabel=quoted(ylabel), more=more)
    blocks = "".join(f"$line{i} << EOD\n" + "".join(" ".join(map(str, row)) + "\n" for row in rows) + "EOD\n" for i, (_, _, rows) in enumerate(lines))
    plots = ", ".join(f'$line{i} {style} lc rgb "{COLOURS[i % len(COLOURS)]}" title "{quoted(title)}"' for i, (title, style, _) in enumerate(lines))
    drawn = subprocess.run(["gnuplot"], input=blocks + script + "plot " + plots + "\n", text=True, stdout=subprocess.PIPE, check=True).stdout
    with open(path, "w", encoding="utf-8") as file:
        file.write(drawn)
    return drawn[drawn.index("<svg"):]


def places(labels):
    """Label -> place on an axis: its number if all labels are numbers, its rank if not."""
    try:
        return {label: float(label) for label in labels}
    except ValueError:
        return {label: float(i) for i, label in enumerate(labels)}


def over_axis(results, axis):
    """Critical speeds over one axis: a colour for each combination of the other axes, and a larger dot for a larger amplitude."""
    name, (_, labels) = list(results.study.axes.items())[axis]
    at = places(labels)
    spread = max(at.values()) - min(at.values()) or 1.0
    groups = {}
    for _, own, critical, _ in results.points:
        if own[axis] and critical:
            groups.setdefault(tuple(own[:axis] + own[axis + 1:]), []).extend((at[own[axis]], row) for row in critical)
    largest = max((float(row[AMPLITUDE]) for rows in groups.values() for _, row in rows), default=1.0)
    others = results.axes[:axis] + results.axes[axis + 1:]
    lines = []
    for i, (group, rows) in enumerate(groups.items()):
        aside = 0.04 * spread * (i - (len(groups) - 1) / 2)  # so that equal speeds don't hide each other
        lines.append((", ".join(f"{other} {label}" for other, label in zip(others, group)), "with points pt 7 ps variable",
                      [(x + aside, row[SPEED], 0.4 + 3 * (float(row[AMPLITUDE]) / largest) ** 0.5) for x, row in rows]))
    if not lines:
        return ""
    tics = ", ".join(f'"{quoted(label)}" {place}' for label, place in at.items())
    return draw(os.path.join(results.report, f"critical_speeds_over_{name}.svg"), lines, xlabel=results.axes[axis], ylabel="critical speed [rpm]",
                more=f"set xtics ({tics})\nset xrange [{min(at.values()) - 0.1 * spread}:{max(at.values()) + 0.1 * spread}]\nset format y '%.0f'")


def responses(results):
    lines = [(name, "with lines lw 1.5", [(row[SPEED], row[AMPLITUDE]) for row in speeds if not row["failure"]])
             for name, _, _, speeds in results.points if speeds]
    lines = [line for line in lines if line[2]]
    return draw(os.path.join(results.report, "responses.svg"), lines, xlabel="speed [rpm]", ylabel="tip amplitude [mm]") if lines else ""


PAGE = """<!doctype html>
<html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>{title}</title>
<style>body {{ font: 15px sans-serif; margin: 2em auto; padding: 0 1em; max-width: 1150px }}
td, th {{ padding: .2em .7em; text-align: left; border-bottom: 1px solid #ddd }} td:first-child {{ white-space: nowrap }}
td:nth-last-child(-n+3) {{ min-width: 18em }} table {{ border-collapse: collapse }} .wide, figure {{ margin: 0; overflow-x: auto }}
svg {{ min-width: 640px; max-width: 100%; height: auto }}</style>
<h1>{title}</h1>
<p>{counts} All critical speeds with all their labels: <a href="study.csv">study.csv</a>.</p>
<div class="wide" tabindex="0" role="region" aria-label="The points"><table>{table}</table></div>
{figures}
</html>
"""


def page(results, summary):
    heading, *rows = summary
    table = "<tr>" + "".join(f'<th scope="col">{html.escape(name)}</th>' for name in heading) + "</tr>"
    for row in rows:
        link = os.path.join(os.path.relpath(results.runs, results.report), "points", row[0], "report", "report.html")
        name = html.escape(row[0]) if NOTE in row else f'<a href="{html.escape(link)}">{html.escape(row[0])}</a>'
        table += "<tr>" + "".join(f"<td>{cell}</td>" for cell in [name, *map(html.escape, row[1:])]) + "</tr>"
    figures = [(f"Critical speeds over {axis}", over_axis(results, i)) for i, axis in enumerate(results.axes)]
    figures.append(("Amplitude over speed", responses(results)))
    there = sum(NOTE not in row for row in rows)
    return PAGE.format(title=html.escape(results.study.title), table=table, counts=f"{there} of {len(rows)} points have a report.",
                       figures="\n".join(f'<h2>{html.escape(title)}</h2><figure role="img" aria-label="{html.escape(title)}; its numbers are in the table">{picture}</figure>'
                                         for title, picture in figures if picture))


def main(path, runs, report):
    results = Results(studies.read_study(path), runs, report)
    os.makedirs(report, exist_ok=True)
    summary = list(results.summary())
    widths = [max(map(len, column)) for column in zip(*summary)]
    with open(os.path.join(report, "study.csv"), "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(results.joint())
    with open(os.path.join(report, "study.txt"), "w", encoding="utf-8") as file:
        for row in summary:
            file.write("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() + "\n")
    with open(os.path.join(report, "study.html"), "w", encoding="utf-8") as file:
        file.write(page(results, summary))


if __name__ == "__main__":
    main(*sys.argv[1:])
