#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What make does with files, names and tables that are not as it left them, on a small disc.

usage: small_chain.py STEP PROGRAMS_FOLDER CASES_FOLDER SMALL_CASE WORK_FOLDER

`make_it` makes WORK_FOLDER/made; each other step takes a copy of that and checks one thing.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import time

MODEL_FILES = ("sector.msh", "model.h5", "fields.h5")
PROGRAMS = ("mesh", "reduce", "simulate", "postprocess")


class Folder:
    """A case's folder, and make in it."""

    def __init__(self, path, bench, makefile=""):
        self.path, self.bench = path, bench
        if bench.made and not os.path.exists(path):
            shutil.copytree(bench.made, path, symlinks=True)
        os.makedirs(path, exist_ok=True)
        self.write("Makefile", makefile + f"include {bench.cases}/chain.mk\n")
        if not os.path.exists(self.file("case.toml")):
            self.write("case.toml", bench.case)

    def file(self, name):
        return os.path.join(self.path, name)

    def write(self, name, text):
        with open(self.file(name), "w", encoding="utf-8") as file:
            file.write(text)

    def read(self, name):
        with open(self.file(name), "rb") as file:
            return file.read()

    def files(self):
        """Name and age of all there is."""
        return {os.path.join(folder, name): os.lstat(os.path.join(folder, name)).st_mtime_ns
                for folder, _, names in os.walk(self.path) for name in names}

    def command(self, *arguments):
        return ["make", "-C", self.path, f"BIN={self.bench.programs}", *arguments]

    def make(self, *arguments):
        return subprocess.run(self.command(*arguments), env=self.bench.environment, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)

    def up_to_date(self, goal="report/report.html"):
        code = self.make("-q", goal).returncode
        assert code in (0, 1)
        return code == 0

    def must_make(self, *arguments):
        made = self.make(*arguments)
        assert made.returncode == 0, made.stdout
        return made.stdout

    def must_refuse(self, *phrases, goal="all"):
        before = self.files()
        made = self.make(goal)
        assert made.returncode != 0 and all(phrase in made.stdout for phrase in phrases), made.stdout
        return before, self.files(), made.stdout

    def would_run(self, *arguments):
        """The stages that make -n names."""
        said = self.must_make("-n", *arguments)
        return [name for name in PROGRAMS if f"tiprub-{name} case.toml" in said.replace(f"tiprub-{name} case.toml --tables", "")]


class Bench:
    def __init__(self, programs, cases, case, work):
        self.programs, self.cases, self.work = programs, cases, work
        with open(case, encoding="utf-8") as file:
            self.case = file.read()
        self.made = None
        self.environment = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}

    def folder(self, name, makefile=""):
        return Folder(os.path.join(self.work, name), self, makefile)

    def empty(self, name, makefile="", case=None):
        made, self.made = self.made, None
        folder = self.folder(name, makefile)
        self.made = made
        folder.write("case.toml", case or self.case)
        return folder

    def without(self, *tables):
        """The case without these tables."""
        parts = self.case.split("\n[")
        return "\n[".join(part for part in parts if part.split("]")[0] not in tables)


def make_it(bench):
    shutil.rmtree(bench.work, ignore_errors=True)
    made = bench.empty("made")
    print(made.must_make("-j2"))
    for name in MODEL_FILES + ("response.h5", "report/report.html"):
        assert os.path.getsize(made.file(name)) > 0, name
    with open(made.file("report/report.html"), encoding="utf-8") as page:
        told = page.read().split('<div id="run">')[1]
    for stage in ("sector: tiprub-mesh", "model: tiprub-reduce", "response: tiprub-simulate"):
        assert re.search(stage + r" \d[\d.]*, \d[\d.]* s, \d[\d.]* s of processor time on \d+ processor", told), (stage, told[:2000])


def values_not_spelling(bench):
    """A stage is made again where a value changes, and only there; comments and spelling are nothing."""
    folder = bench.folder("spelling")
    assert folder.up_to_date(), "a copy is up to date"
    same = bench.case.replace("[casing]", "  [ casing ]  # a remark").replace(
        "clearance = [[0.0, 0.13e-3], [1.0, 0.12e-3]]", "clearance=[\n[0.0, 13e-5],\n[1.0, 12e-5]]").replace("[simulate]", "\t[simulate]").replace("lobes = 2", '"lobes"=2')
    folder.write("case.toml", same)
    assert folder.would_run() == [] and folder.up_to_date(), "another spelling of the same"
    folder.write("case.toml", same.replace("12e-5", "11e-5"))
    assert folder.would_run() == ["simulate", "postprocess"], folder.would_run()
    folder.write("case.toml", same.replace("density = 4430.0", "density=4431"))
    assert folder.would_run() == ["reduce", "simulate", "postprocess"], folder.would_run()
    folder.write("case.toml", same.replace("engine_order_max = 6", "engine_order_max = 4"))
    assert folder.would_run() == ["postprocess"], folder.would_run()
    folder.write("case.toml", same)
    assert folder.would_run("SIMULATE_FLAGS=--set casing.lobes=3") == [
        "simulate", "postprocess"], "flags of the Makefile count too"


def dry_run_touches_nothing(bench):
    folder = bench.folder("dry")
    folder.write("case.toml", bench.case.replace("density = 4430.0", "density = 4431.0"))
    before = folder.files()
    assert folder.would_run() == ["reduce", "simulate", "postprocess"]
    assert not folder.up_to_date()
    assert folder.files() == before, "make -n and -q leave all as it was"
    empty = bench.empty("dry_empty")
    assert empty.would_run() == list(PROGRAMS)
    assert sorted(os.listdir(empty.path)) == ["Makefile", "case.toml"]


def sweeps(bench):
    """Swept responses are found however the key is written, and computed as swept."""
    folder = bench.folder("sweeps")
    for line in ('response_up = "response_up.h5"', "response_up='response_up.h5'", ' "response_up"="response_\\u0075p.h5" # so'):
        folder.write("case.toml", bench.case.rstrip() + "\n" + line + "\n")
        said = folder.must_make("-n")
        assert "-o response_up.h5 --set 'simulate.sweep=\"up\"'" in said and "response_down" not in said, said
    folder.must_make("-j2")
    assert b"response_up" not in folder.read("case.toml") or os.path.exists(folder.file("response_up.h5"))
    with open(folder.file("report/report.html"), encoding="utf-8") as page:
        assert "sweep" in page.read()
    assert folder.up_to_date()
    elsewhere = bench.empty("sweeps_elsewhere", "CASE := ../sweeps/case.toml\nMODEL_OF := ../rotor\nSETTINGS := --set casing.lobes=3\n")
    bench.folder("rotor")
    elsewhere.must_make()  # symptom: its report read the sweep beside that case, which is of another casing
    os.rename(folder.file("response_up.h5"), folder.file("mine.h5"))
    folder.write("case.toml", bench.case + 'response_up = "mine.h5"\n')
    said = folder.must_make()
    assert "names a file of your own" in said and "tiprub-simulate case.toml" not in said, said


def clock_set_back(bench):
    """What has changed is made again even if all files are dated ahead of the clock, and once only."""
    ahead = 2 * (time.time() + 3600,)
    folder = bench.folder("ahead")
    for name in folder.files():
        os.utime(name, ahead)
    old = folder.read("response.h5")
    folder.write("case.toml", bench.case.replace("lobes = 2", "lobes = 3"))
    assert folder.would_run() == ["simulate", "postprocess"], folder.would_run()
    folder.must_make()
    assert folder.read("response.h5") != old and b"lobes = 3" in folder.read("report/case.toml")
    assert folder.up_to_date()
    folder = bench.folder("ahead_and_stopped")
    folder.write("case.toml", bench.case.replace("density = 4430.0", "density = 4431.0"))
    for name in folder.files():
        os.utime(name, ahead)
    folder.must_make("model.h5")
    assert folder.would_run() == ["simulate", "postprocess"], folder.would_run()


def hostile_names(bench):
    """No text of a case is run, by a shell or by make."""
    folder = bench.folder("hostile")
    orders = ["response.h5 ; touch P", "`touch P`", "$(touch P)", "$(shell touch P)", "${shell touch P}", "$$(touch P)", "' ; touch P ; '",
              '\\" ; touch P ; \\"', "response_up.h5\\ntouch P", "|touch P", "x.h5: ; touch P", "response_up.h5\\\"\\nresponse_down = \\\"; touch P",
              "$(eval $(shell touch P))", "&& touch P", "> P", "-o P", "response_$(shell touch P).h5", "response_`touch${IFS}P`.h5"]
    for up, down in zip(orders, orders[1:] + orders[:1]):
        folder.write("case.toml", bench.case + f'response_up = "{up}"\nresponse_down = "{down}"\n')
        folder.make()
        folder.make("clean", "all", "-n")
        assert not os.path.exists(folder.file("P")), f"response_up = {up}, response_down = {down}"
    for order in orders:
        folder.write("case.toml", bench.case.replace('title = "Small disc"', f'title = "{order}"').replace(
            'shape = "cosine"', f'shape = "{order}"'))
        folder.make()
        assert not os.path.exists(folder.file("P")), order


def own_mesh(bench):
    """MESH: neither made, nor cleaned; [mesh] is not asked for. A blank in its name does no harm."""
    for name in ("sector.msh", "../my wheel's.msh"):
        folder = bench.empty("own_mesh", f"MESH := {name}\n", bench.without("mesh"))
        shutil.copy(os.path.join(bench.made, "sector.msh"), folder.file(name))
        mesh = folder.read(name)
        said = folder.must_make("model.h5")
        assert "tiprub-mesh" not in said and "tiprub-reduce case.toml" in said, said
        assert folder.up_to_date("model.h5")
        os.utime(folder.file(name))
        assert folder.would_run("model.h5") == ["reduce"]
        folder.must_make("model.h5")
        os.utime(folder.file(name), (0, 0))
        assert folder.would_run("model.h5") == ["reduce"], "symptom: a mesh that an older one had replaced went unnoticed"
        folder.must_make("clean")
        assert folder.read(name) == mesh and not os.path.exists(folder.file("model.h5"))
        os.remove(folder.file(name))


def own_model(bench):
    """MODEL: likewise, without fields if there are none."""
    for name in ("model.h5", "mine.h5"):
        folder = bench.empty("own_model", f"MODEL := {name}\n", bench.without("mesh", "reduce"))
        shutil.copy(os.path.join(bench.made, "model.h5"), folder.file(name))
        said = folder.must_make()
        assert "tiprub-reduce" not in said and "--fields" not in said, said
        os.utime(folder.file(name), (0, 0))
        assert folder.would_run() == ["simulate", "postprocess"]
        folder.must_make("clean")
        assert sorted(os.listdir(folder.path)) == sorted(["Makefile", "case.toml", name])
        os.remove(folder.file(name))
    folder = bench.empty("own_fields", "MODEL := mine.h5\nFIELDS := mine_fields.h5\n", bench.without("mesh", "reduce"))
    for name in ("model.h5", "fields.h5"):
        shutil.copy(os.path.join(bench.made, name), folder.file(name.replace("model", "mine").replace("fields", "mine_fields")))
    assert "--fields 'mine_fields.h5'" in folder.must_make("-n")


def never_overwrites(bench):
    """A file that make did not make is told at once, and stays; so it does where make's own was replaced."""
    folder = bench.empty("others", case=bench.without("mesh"))
    folder.write("sector.msh", "mine")
    before, after, said = folder.must_refuse("sector.msh: make did not make it", "MESH")
    assert before == after and "[mesh]" not in said
    folder.must_make("clean")
    assert folder.read("sector.msh") == b"mine"

    for name, stale in (("sector.msh", "thickness_tip = [[0.0, 0.0009]]"), ("response.h5", "lobes = 3")):
        folder = bench.folder("replaced_" + name)
        shutil.copy(folder.file("fields.h5"), folder.file(name))
        key = stale.split(" = ")[0]
        folder.write("case.toml", "\n".join(stale if line.startswith(key + " =") else line for line in bench.case.split("\n")))
        mine = folder.read(name)
        folder.must_refuse(f"{name}: make did not make it")
        assert folder.read(name) == mine
        assert f"{name}: kept" in folder.must_make("clean")
        assert folder.read(name) == mine


def clean(bench):
    """Everything that make made, and nothing else."""
    folder = bench.folder("clean")
    for name in ("notes.h5", "response_old.h5", "report/notes.txt", "my.part.msh"):
        folder.write(name, "mine")
    folder.must_make("clean")
    left = sorted(os.path.relpath(name, folder.path) for name in folder.files())
    assert left == ["Makefile", "case.toml", "my.part.msh", "notes.h5", "report/notes.txt", "response_old.h5"], left


def tables_first(bench):
    """A key that is wrong, or a table that is missing, in whatever stage, is told before anything is computed."""
    for name, case, phrase in (("postprocess", bench.without("postprocess"), "has no [postprocess] table; add it"),
                               ("simulate", bench.case.replace("lobes = 2", "lobs = 2"), "unknown key \"lobs\""),
                               ("reduce", bench.case.replace("density = 4430.0", "density = -1"), "density = -1 must be"),
                               ("text", bench.case + "= 3\n", "not TOML")):
        folder = bench.empty("wrong_" + name, case=case)
        _, after, said = folder.must_refuse(phrase)
        assert [os.path.basename(file) for file in after if not "/.chain" in file] == ["Makefile", "case.toml"] or len(
            [file for file in after if "/.chain" not in file]) == 2, after
        assert said.count("error:") == 1, said


def other_case(bench):
    """MODEL_OF: links to another case's model, remade with it; -n and -q know of it."""
    rotor = bench.folder("rotor")
    folder = bench.empty("other", "MODEL_OF := ../rotor\n", bench.without("mesh", "reduce"))
    folder.must_make("-j2")
    assert os.readlink(folder.file("model.h5")) == "../rotor/model.h5" and folder.up_to_date()
    rotor.write("case.toml", bench.case.replace("density = 4430.0", "density = 4431.0"))
    assert folder.would_run() == ["reduce", "simulate", "postprocess"], folder.would_run()
    assert not folder.up_to_date()
    folder.must_make("-j2")
    assert folder.up_to_date()
    folder.must_make("clean")
    assert sorted(os.listdir(folder.path)) == ["Makefile", "case.toml"]
    assert os.path.exists(rotor.file("model.h5"))
    folder.write("model.h5", "mine")
    folder.must_refuse("model.h5: make did not make it")
    assert folder.read("model.h5") == b"mine"


def moved(bench):
    """A source and its cases in a path with blanks and umlauts; a copied case that is told where the source is."""
    source = os.path.join(bench.work, "Räder und Gehäuse's", "tiprub")
    shutil.rmtree(source, ignore_errors=True)
    os.makedirs(os.path.join(source, "build"))
    os.symlink(bench.programs, os.path.join(source, "build", "bin"))
    shutil.copytree(bench.made, os.path.join(source, "cases", "small"))
    for name in ("chain.mk", "chain.sh"):
        shutil.copy(os.path.join(bench.cases, name), os.path.join(source, "cases"))
    shutil.copy(os.path.join(bench.cases, "impeller_quick", "Makefile"), os.path.join(source, "cases", "small"))
    os.remove(os.path.join(source, "cases", "small", "response.h5"))

    def make(folder, *arguments):
        return subprocess.run(["make", *arguments], cwd=folder, env=bench.environment, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
    there = make(os.path.join(source, "cases", "small"))
    assert there.returncode == 0 and "tiprub-mesh case.toml" not in there.stdout, there.stdout
    alone = os.path.join(bench.work, "ein ander Ort")
    shutil.rmtree(alone, ignore_errors=True)
    shutil.copytree(os.path.join(source, "cases", "small"), alone)
    reached = os.path.join(bench.work, "tiprub")
    if not os.path.islink(reached):
        os.symlink(source, reached)  # make takes no blank in what it includes
    lost = make(alone)
    assert lost.returncode != 0 and "There is no ../../cases/chain.mk: make TIPRUB=FOLDER" in lost.stdout, lost.stdout
    there = make(alone, f"TIPRUB={reached}", "-B", "sector.msh")
    assert there.returncode == 0 and "tiprub-mesh case.toml" in there.stdout, there.stdout


def decimal_commas(bench):
    """A locale that writes 0,13 gives the same bytes."""
    locales = os.path.join(bench.work, "locales")
    os.makedirs(locales, exist_ok=True)
    subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", os.path.join(locales, "de_DE.UTF-8")], check=False)
    said = subprocess.run(["locale", "decimal_point"], env={"LOCPATH": locales, "LC_ALL": "de_DE.UTF-8", "PATH": os.environ["PATH"]}, text=True,
                          stdout=subprocess.PIPE, check=True).stdout
    assert said.strip() == ",", "no locale with decimal commas could be made"
    folder = bench.empty("commas")
    bench.environment.update(LOCPATH=locales, LC_ALL="de_DE.UTF-8")
    folder.must_make()
    made = Folder(bench.made, bench)
    for name in MODEL_FILES + ("response.h5", "report/critical_speeds.csv", "report/critical_speeds.txt"):
        assert folder.read(name) == made.read(name), name


def settings_reach_the_report(bench):
    """Symptom: a report read the damping from the case's text, where --set is a comment, so that every report of a damping
    study named the wrong one; and it said that blades never differ, of a scene in which they do."""
    folder = bench.folder("settings")

    def run(program, *arguments):
        return subprocess.run([os.path.join(bench.programs, f"tiprub-{program}"), "case.toml", "model.h5", *arguments],
                              cwd=folder.path, check=True, stderr=subprocess.PIPE, text=True).stderr

    blades = ("--set", "casing.blade_clearance=[0, 0, 1e-5, 0, 0, 0]")
    run("simulate", "-o", "told.h5", *blades, "--set", "simulate.damping_ratio=0.002", "--set", 'simulate.nodal_diameters="all"',
        "--set", "simulate.speeds_rpm=[20000, 24000]")
    run("postprocess", "told.h5", "-o", "told", *blades)
    summary = json.loads(folder.read("told/summary.json"))
    told = "ratio 0.002 of critical"
    assert summary["scene"]["Damping"].startswith(told), summary["scene"]
    needs = {row["effect"]: row for row in summary["scene_needs"]}
    assert needs["damping of the modes"]["estimated by, or how to"].startswith(told), needs
    between = needs["differences of the clearance between the blades: largest of them [mm]"]
    assert between["treatment"] == "modelled" and abs(between["size"] - 0.01) < 1e-12, between
    assert needs["nodal diameters: growth a revolution of those left out [1]"]["treatment"] == "modelled", needs
    for name in ("told/report.html", "told/scene_needs.csv"):
        text = folder.read(name).decode()
        assert told in text and "ratio 0.02 of critical" not in text, name
    for setting, is_told in (("simulate.damping_ratio=0.002", False), ("reduce.density=7850.0", True)):  # symptom: steel swept titanium
        assert ("model.h5 was made with reduce.density = " in run("simulate", "--check", "--set", setting)) == is_told, setting


STEPS = (make_it, values_not_spelling, dry_run_touches_nothing, sweeps, clock_set_back, hostile_names, own_mesh, own_model, never_overwrites, clean,
         tables_first, other_case, moved, decimal_commas, settings_reach_the_report)


def main(step, programs, cases, case, work):
    bench = Bench(*map(os.path.abspath, (programs, cases, case, work)))
    if step != "make_it":
        bench.made = os.path.join(bench.work, "made")
        bench.work = os.path.join(bench.work, step)
        shutil.rmtree(bench.work, ignore_errors=True)
        os.makedirs(bench.work)
    {function.__name__: function for function in STEPS}[step](bench)


if __name__ == "__main__":
    main(*sys.argv[1:])
