#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders and a Makefile for the points of a study; see README.md.

usage: study.py STUDY.toml PROGRAMS_FOLDER CHAIN.mk RUNS_FOLDER

A point is a folder that includes chain.mk. Meshes and models stand in folders of their own, named by the digest of all that they are made
of, so that points share them. Leaves with 2, and one line, where the study or a value in it is wrong.
"""
import hashlib
import itertools
import json
import os
import re
import shlex
import subprocess
import sys
import tomllib

LABEL = re.compile(r"[A-Za-z0-9_+.][A-Za-z0-9_+.-]*")
KEY = re.compile(r"\w+(\.\w+)+")


class Wrong(Exception):
    """What the study's author can mend."""


def check_keys(table, place, known):
    if not isinstance(table, dict):
        raise Wrong(f"{place}: must be a table")
    for key in table:
        if key not in known:
            raise Wrong(f'{place}: unknown key "{key}"; known: {", ".join(known)}')


def setting(place, key, value):
    """One --set of all programs; JSON writes numbers, texts and lists as TOML does."""
    if not KEY.fullmatch(key):
        raise Wrong(f'{place}: "{key}" must be TABLE.KEY of a case, in quotes')
    if isinstance(value, dict) or "inf" in repr(value) or "nan" in repr(value):
        raise Wrong(f"{place}: {key} = {value!r} must be a number, a text, a truth or a list of these")
    try:
        return f"{key}={json.dumps(value)}"
    except TypeError:
        raise Wrong(f"{place}: {key} = {value!r} must be a number, a text, a truth or a list of these") from None


def axis_values(name, axis):
    """Label -> setting, in the study's order."""
    place = f"[grid.{name}]"
    check_keys(axis, place, ("key", "values", "unit"))
    values = axis.get("values")
    if isinstance(values, list):
        values = {str(value): value for value in values}
    if not values or not isinstance(values, dict) or not isinstance(axis.get("key"), str):
        raise Wrong(f'{place}: needs key = "TABLE.KEY" and values = [...], or values = {{label = value, ...}}')
    for label in values:
        if not LABEL.fullmatch(label):
            raise Wrong(f'{place}: "{label}" names a folder; give its value a label of letters, digits and ._+-: values = {{label = value, ...}}')
    return {label: setting(place, axis["key"], value) for label, value in values.items()}


class Study:
    """What a study file says. points: name -> (label on each axis, settings)."""

    def __init__(self, path):
        self.path, self.folder = path, os.path.dirname(os.path.abspath(path))
        with open(path, "rb") as file:
            text = tomllib.load(file)
        check_keys(text, "the file", ("title", "case", "mesh", "model", "fields", "settings", "grid", "points"))
        if "case" not in text:
            raise Wrong('needs case = "the case that the points vary"')
        self.title = text.get("title", "Study")
        self.files = {name: os.path.join(self.folder, text[name]) for name in ("case", "mesh", "model", "fields") if name in text}
        common = [setting("[settings]", key, value) for key, value in text.get("settings", {}).items()]
        grid = text.get("grid", {})
        axes = {name: axis_values(name, axis) for name, axis in grid.items()}
        self.axes = {name: (grid[name].get("unit", ""), list(values)) for name, values in axes.items()}
        self.points = {}
        for labels in itertools.product(*axes.values()) if axes else ():
            name = "-".join(f"{axis}_{label}" for axis, label in zip(axes, labels))
            self.points[name] = (list(labels), common + [axes[axis][label] for axis, label in zip(axes, labels)])
        for name, point in text.get("points", {}).items():
            if not LABEL.fullmatch(name) or name in self.points or not isinstance(point, dict):
                raise Wrong(f"[points.{name}]: must be a table with a name of its own, of letters, digits and ._+-")
            settings = [setting(f"[points.{name}]", key, value) for key, value in point.items()]
            self.points[name] = ([""] * len(axes), common + settings)
        if not self.points:
            raise Wrong("has no points: give it [grid.NAME] with key and values, or [points.NAME] with keys of their own")


def tables(programs, stage, case, settings):
    """What a stage reads of a point's case."""
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
        lines = [f"{key} := " + value.replace("$", "$$").replace("#", "\\#") for key, value in relative.items()]
        write_if_new(os.path.join(folder, "Makefile"), "\n".join([*lines, f"include {chain}", ""]))

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
                raise Wrong("[postprocess] response_up and response_down lie beside a case, where points have no files; leave them out")
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
    try:
        study = Study(path)
        folders = Folders(study, programs, chain, runs)
        for name, (_, settings) in study.points.items():
            folders.point(name, settings)
    except (Wrong, OSError, tomllib.TOMLDecodeError) as wrong:
        print(f"{path}: {wrong}", file=sys.stderr)
        sys.exit(2)
    waits = folders.waits
    every = {**waits["meshes"], **waits["models"], **waits["points"]}
    write_if_new(os.path.join(runs, "Makefile"), MAKEFILE.format(
        points=" ".join(waits["points"]), folders=" ".join(every), meshes=" ".join(waits["meshes"]) or "no_meshes",
        models=" ".join(waits["models"]) or "no_models", waits="".join(f"{name}: {first}\n" for name, first in every.items() if first)))
    print(f"{path}: {len(study.points)} points, {len(waits['models'])} models, {len(waits['meshes'])} meshes in {runs}")


if __name__ == "__main__":
    main(sys.argv[1], *map(os.path.abspath, sys.argv[2:]))
