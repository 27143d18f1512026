#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders and a Makefile for the points of a study; see README.md.

usage: study.py STUDY.toml PROGRAMS_FOLDER CHAIN.mk RUNS_FOLDER

Each point is a folder with a Makefile that includes chain.mk. Meshes and models have folders of their own, which are named by the digest
of everything that they depend on, so that points share them. If the study or a value in it is wrong, the exit code is 2, and one line on
stderr says what to change.

A study may come from a stranger. Its names become folders and targets of make, so their letters are limited here, and everything else that
is written into a Makefile is escaped.
"""
import hashlib
import itertools
import json
import math
import os
import re
import reprlib
import shlex
import subprocess
import sys
import tomllib

NAME = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_+.-]*")
LABEL = re.compile(r"[A-Za-z0-9_+.-]+")  # stands behind the name of its grid
FILE = re.compile(r"[\w ./+,@'-]+")      # make takes other signs for its own
KEY = re.compile(r"[A-Za-z0-9_]+(\.[A-Za-z0-9_]+)+")
MOST_POINTS = 10_000
LONGEST_NAME = 200  # file systems take 255 bytes


class Wrong(Exception):
    """Something in the study that its author can put right."""


def require_table(table, place):
    if not isinstance(table, dict):
        raise Wrong(f"{place}: must be a table")
    return table


def check_keys(table, place, known):
    for key in require_table(table, place):
        if key not in known:
            raise Wrong(f"{place}: unknown key {key!r}; known: {', '.join(known)}")


def text_of(table, key, default=""):
    text = table.get(key, default)
    if not isinstance(text, str) or not text.isprintable():
        raise Wrong(f"{key} = {reprlib.repr(text)} must be a text of one line")
    return text


def setting(place, key, value):
    """One --set of all programs; JSON writes numbers, texts and lists as TOML does. An empty table removes the key."""
    if not KEY.fullmatch(key):
        raise Wrong(f"{place}: {key!r} must be TABLE.KEY of a case, in quotes")
    if value == {}:
        return f"{key}="
    try:
        text = f"{key}={json.dumps(value, ensure_ascii=False, allow_nan=False)}"
        if not isinstance(value, dict) and text.isprintable():
            return text
    except (TypeError, ValueError):
        pass
    raise Wrong(f"{place}: {key} = {reprlib.repr(value)} must be a number, a text of one line, a truth, a list of these, or {{}}, which removes the key")


def axis_values(name, axis):
    """Label -> setting, in the study's order."""
    place = f"[grid.{name}]"
    if not NAME.fullmatch(name):
        raise Wrong(f"[grid]: {name!r} names a folder; use letters, digits and ._+-, and begin with a letter, a digit or _")
    check_keys(axis, place, ("key", "values", "unit"))
    values = axis.get("values")
    if isinstance(values, list):
        values = {str(value): value for value in values}
    if not values or not isinstance(values, dict) or not isinstance(axis.get("key"), str):
        raise Wrong(f'{place}: needs key = "TABLE.KEY" and values = [...], or values = {{label = value, ...}}')
    for label in values:
        if not LABEL.fullmatch(label):
            raise Wrong(f"{place}: {label!r} names a folder; give its value a label of letters, digits and ._+-: values = {{label = value, ...}}")
    return {label: setting(place, axis["key"], value) for label, value in values.items()}


def file_of(folder, text, key):
    name = text_of(text, key)
    if not FILE.fullmatch(name):
        raise Wrong(f"{key} = {name!r} must name a file by letters, digits, blanks and ._+-,@'/")
    return os.path.join(folder, name)


class Study:
    """What a study file says. points: name -> (label on each axis, settings). axes: name -> (unit, labels). Raises Wrong."""

    def __init__(self, path):
        self.path, self.folder, self.points = path, os.path.dirname(os.path.abspath(path)), {}
        try:
            with open(path, "rb") as file:
                text = tomllib.load(file)
        except (OSError, ValueError, RecursionError) as error:
            raise Wrong(error) from None
        check_keys(text, "the file", ("title", "case", "mesh", "model", "fields", "settings", "grid", "points"))
        if "case" not in text:
            raise Wrong('needs case = "the case that the points vary"')
        self.title = text_of(text, "title", "Study")
        self.files = {name: file_of(self.folder, text, name) for name in ("case", "mesh", "model", "fields") if name in text}
        common = [setting("[settings]", key, value) for key, value in require_table(text.get("settings", {}), "[settings]").items()]
        self.add_grid(require_table(text.get("grid", {}), "[grid]"), common)
        self.add_points(require_table(text.get("points", {}), "[points]"), common)
        if not self.points:
            raise Wrong("has no points: give it [grid.NAME] with key and values, or [points.NAME] with keys of their own")

    def add(self, name, labels, settings):
        if name in self.points:
            raise Wrong(f"two points have the name {name}")
        if len(name) > LONGEST_NAME:
            raise Wrong(f"the point {name[:40]}... has a name of {len(name)} letters; that of a folder may have {LONGEST_NAME}")
        self.points[name] = (labels, settings)

    def add_grid(self, grid, common):
        axes = {name: axis_values(name, axis) for name, axis in grid.items()}
        self.axes = {name: (text_of(grid[name], "unit"), list(values)) for name, values in axes.items()}
        varied = {}
        for name, axis in grid.items():
            if varied.setdefault(axis["key"], name) != name:
                raise Wrong(f"[grid.{name}]: varies {axis['key']}, as [grid.{varied[axis['key']]}] does; a point can have one value of it only")
        count = math.prod(map(len, axes.values()))
        if count > MOST_POINTS:
            raise Wrong(f"[grid]: gives {count} points; a study may have {MOST_POINTS}")
        for labels in itertools.product(*axes.values()) if axes else ():
            self.add("-".join(f"{axis}_{label}" for axis, label in zip(axes, labels)), list(labels),
                     common + [axes[axis][label] for axis, label in zip(axes, labels)])

    def add_points(self, points, common):
        for name, point in points.items():
            place = f"[points.{name}]"
            if not NAME.fullmatch(name):
                raise Wrong(f"[points]: {name!r} names a folder; use letters, digits and ._+-, and begin with a letter, a digit or _")
            settings = [setting(place, key, value) for key, value in require_table(point, place).items()]
            self.add(name, [""] * len(self.axes), common + settings)


def read_study(path):
    """Ends the program with 2, and one line, if the study is wrong."""
    try:
        return Study(path)
    except Wrong as wrong:
        refuse(path, wrong)


def refuse(path, wrong):
    print(f"{path}: {wrong}", file=sys.stderr)
    sys.exit(2)


def tables(programs, stage, case, settings):
    """What a stage reads of the case of a point."""
    told = subprocess.run([os.path.join(programs, f"tiprub-{stage}"), case, "--tables", *(word for text in settings for word in ("--set", text))],
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    if told.returncode != 0:
        raise Wrong(told.stderr.strip())
    return told.stdout


def of_table(settings, table):
    return [text for text in settings if text.startswith(table + ".")]


def digest(*texts):
    return hashlib.sha256("\0".join(texts).encode()).hexdigest()[:12]


class Folders:
    """The Makefiles of a study's folders, and on which others each waits."""

    def __init__(self, study, programs, chain, runs):
        self.study, self.programs, self.chain, self.runs = study, programs, chain, runs
        self.waits = {"meshes": {}, "models": {}, "points": {}}

    def write(self, kind, name, settings, waits_on, **variables):
        folder = os.path.join(self.runs, kind, name)
        self.waits[kind][f"{kind}/{name}"] = waits_on
        relative = {key: os.path.relpath(path, folder) for key, path in variables.items()}
        relative["CASE"] = os.path.relpath(self.study.files["case"], folder)
        relative["SETTINGS"] = " ".join(f"--set {shlex.quote(text)}" for text in settings)
        chain = os.path.relpath(self.chain, folder)
        if re.search(r"\s", chain):
            raise Wrong(f"{chain}: make takes no blanks in what it includes; reach it by a link without")
        lines = [f"{key} := " + value.replace("$", "$$").replace("#", "$(HASH)") for key, value in relative.items()]
        write_if_new(os.path.join(folder, "Makefile"), "\n".join(["HASH := \\#", *lines, f"include {chain}", ""]))

    def model(self, settings):
        """MODEL and FIELDS of a point, and what must be made before it."""
        files = self.study.files
        if "model" in files:
            return {"MODEL": files["model"], **({"FIELDS": files["fields"]} if "fields" in files else {})}, ""
        mesh, waits_on, meshed = files.get("mesh"), "", files.get("mesh", "")
        if mesh is None:
            meshed = tables(self.programs, "mesh", files["case"], settings)
            waits_on = f"meshes/{digest(meshed)}"
            mesh = os.path.join(self.runs, waits_on, "sector.msh")
            self.write("meshes", digest(meshed), of_table(settings, "mesh"), "")
        name = digest(meshed, tables(self.programs, "reduce", files["case"], settings))
        self.write("models", name, of_table(settings, "reduce"), waits_on, MESH=mesh)
        return {key: os.path.join(self.runs, "models", name, file) for key, file in (("MODEL", "model.h5"), ("FIELDS", "fields.h5"))}, f"models/{name}"

    def point(self, name, settings):
        try:
            tables(self.programs, "simulate", self.study.files["case"], settings)
            if re.search(r'^response_(up|down) = "[^"]', tables(self.programs, "postprocess", self.study.files["case"], settings), re.M):
                raise Wrong("[postprocess] response_up and response_down are responses that a study does not compute; leave them out")
            files, waits_on = self.model(settings)
        except Wrong as wrong:
            raise Wrong(f"point {name}: {wrong}") from None
        self.write("points", name, settings, waits_on, **files)


def write_if_new(path, text):
    os.makedirs(os.path.dirname(path), exist_ok=True)
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            if file.read() == text:
                return
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


MAKEFILE = """# Made by study.py: what the points of a study wait for. `make -j 4`, or one of them: `make point INDEX=1`.
POINTS := {points}
THREADS ?= 1
.PHONY: all point {folders}
all: $(POINTS)
point: $(word $(or $(INDEX),1),$(POINTS))
{waits}
# Points that are made elsewhere at the same time wait for a mesh and a model, too.
{meshes}:
	+@flock $@ $(MAKE) --no-print-directory -C $@ sector.msh
{models}:
	+@flock $@ $(MAKE) --no-print-directory -C $@ model.h5 fields.h5
$(POINTS):
	+@$(MAKE) --no-print-directory -C $@ report/report.html SIMULATE_FLAGS='--threads $(THREADS)'
"""


def main(path, programs, chain, runs):
    study = read_study(path)
    folders = Folders(study, programs, chain, runs)
    try:
        for name, (_, settings) in study.points.items():
            folders.point(name, settings)
    except (Wrong, OSError) as wrong:
        refuse(path, wrong)
    waits = folders.waits
    every = {**waits["meshes"], **waits["models"], **waits["points"]}
    write_if_new(os.path.join(runs, "Makefile"), MAKEFILE.format(
        points=" ".join(waits["points"]), folders=" ".join(every), meshes=" ".join(waits["meshes"]) or "no_meshes",
        models=" ".join(waits["models"]) or "no_models", waits="".join(f"{name}: {first}\n" for name, first in every.items() if first)))
    print(f"{path}: {len(study.points)} points, {len(waits['models'])} models, {len(waits['meshes'])} meshes in {runs}")


if __name__ == "__main__":
    main(sys.argv[1], *map(os.path.abspath, sys.argv[2:]))
