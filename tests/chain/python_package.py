#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The Python package finds in the files of a small disc what the programs say is in them, and writes what they take.

usage: python_package.py SOURCE_FOLDER PROGRAMS_FOLDER FOLDER_WITH_FILES WORK_FOLDER
"""
import csv
import doctest
import importlib
import itertools
import os
import shutil
import subprocess
import sys
import zipfile

import h5py
import numpy as np
from written_wheels import message_of, wheel_for_calculix, wheel_for_nastran, wheel_of_pyramids

MODULES = ("units", "models", "responses", "sector_matrices", "runs", "plots")


def doctests(tiprub):
    for name in MODULES:
        told = doctest.testmod(importlib.import_module(f"tiprub.{name}"), extraglobs=vars(tiprub), optionflags=doctest.NORMALIZE_WHITESPACE)
        assert told.failed == 0 and told.attempted > 0, (name, told)


def frequencies(tiprub):
    """Those that tiprub-simulate has written."""
    model, marched = tiprub.Model.read("model.h5"), tiprub.open_response("response.h5").frequencies
    assert sorted(marched) == list(range(model.sector_count // 2 + 1))
    for n, data in marched.items():
        for speed, written in zip(data.rpm.values, data.values):
            assert np.allclose(model.frequencies(n, speed), written, rtol=1e-6), (n, speed)


def motion(tiprub):
    """Against the numbers that tiprub-simulate has written of each speed, and sums of waves by hand."""
    response = tiprub.open_response("response.h5")
    with h5py.File("fields.h5") as fields:
        tips = fields["node_set/contact"][:]
    for speed in response.sweep.rpm.values:
        at, normal = response.at(speed), response.normal_motion(speed)
        assert np.isclose(at.speed * 30 / np.pi, speed)
        assert np.isclose((normal.max("angle") - normal.min("angle")).max() / 2, at.amplitude, rtol=1e-12)
        with h5py.File("response.h5") as file:
            snapshot = min(file["speed"].values(), key=lambda group: abs(group.attrs["speed"] - at.speed))["snapshot"]
            sample, force = snapshot.attrs["sample"], snapshot.attrs["contact_force"]
        whole = response.whole_wheel(at)
        assert whole.sizes["sector"] == response.sector_count and np.isclose(whole.contact_force[sample].sum(), force)
        tip = response.field(speed).displacement[:, tips]
        assert np.allclose(tip, whole.displacement[sample], rtol=1e-5, atol=1e-12)


def varied_motion(tiprub):
    """The motions of an error budget, with cycles of their own lengths, are not part of the speed's motion."""
    shutil.copy("response.h5", "varied.h5")
    with h5py.File("varied.h5", "r+") as file:
        group = next(iter(file["speed"].values()))
        speed = group.attrs["speed"] * 30 / np.pi
        for variation, samples in enumerate((120, 480)):
            cycle = group.create_group(f"budget/{variation}/cycle")
            for name, size in (("dof_0", 3), ("cycle_angle", samples)):
                cycle[name] = np.arange(float(size))
                cycle[name].make_scale(name)
            cycle["0"] = np.ones((3, samples))
            for axis, name in enumerate(("dof_0", "cycle_angle")):
                cycle["0"].dims[axis].attach_scale(cycle[name])
    varied, sound = (tiprub.open_response(file).at(speed) for file in ("varied.h5", "response.h5"))
    assert varied.equals(sound), (varied, sound)


def units(tiprub):
    """xarray's own reader of netCDF has the same numbers and units."""
    import xarray
    with xarray.open_dataset("response.h5") as theirs:
        ours = tiprub.open_response("response.h5").sweep
        assert set(theirs.data_vars) == {*ours.data_vars, "provenance"}
        assert all(theirs[name].equals(ours[name].drop_vars("rpm")) for name in ours.data_vars)
        assert theirs.amplitude.units == ours.amplitude.units == "m" and tiprub.mm(ours.amplitude).units == "mm"


def broken_models(tiprub):
    """What Model refuses is refused by tiprub-simulate too, and what it takes is taken."""
    def spoil(n, name, change):
        matrices = {k: dict(group) for k, group in sound.matrices.items()}
        matrices[n][name] = change(matrices[n][name])
        return {"matrices": matrices}

    sound = tiprub.Model.read("model.h5")
    yield {}
    yield {"sector_count": 9}
    yield {"speed_max": 0.0}
    yield {"normal": -sound.normal}
    yield {"normal": 2 * sound.normal}
    yield {"position": sound.position[:1]}
    yield {"arc_length": sound.arc_length[::-1]}
    yield {"matrices": {0: sound.matrices[0]}}
    yield spoil(1, "K0", lambda K: K + np.triu(np.full(K.shape, 1e-6 * np.max(np.abs(K))), 1))
    yield spoil(0, "K0", lambda K: K + 1e-6j * np.max(K) * np.tri(len(K)) - 1e-6j * np.max(K) * np.tri(len(K)).T)
    yield spoil(2, "M", lambda M: -M)
    yield spoil(2, "K1", lambda K: np.nan * K)
    yield {"matrices": {**sound.matrices, 1: {"K0": sound.matrices[1]["K0"], "K4": sound.matrices[1]["K0"], "M": sound.matrices[1]["M"]}}}


def refusals(tiprub, programs):
    simulate = os.path.join(programs, "tiprub-simulate")
    for k, change in enumerate(broken_models(tiprub)):
        model = tiprub.Model.read("model.h5")
        for name, value in change.items():
            setattr(model, name, value)
        try:
            model.write("changed.h5")
            assert not change, f"change {k} is not refused"
        except tiprub.ModelError:
            assert change, "a sound model is refused"
            model.check = lambda: None
            model.write("changed.h5")
        told = subprocess.run([simulate, "case.toml", "changed.h5", "--check"], text=True, stderr=subprocess.PIPE, stdout=subprocess.PIPE)
        assert told.returncode == (2 if change else 0), (k, told.stderr)
    said = message_of(lambda: tiprub.run("case.toml", set={"casing.lobs": 3}, progress=False), tiprub.RunError)
    assert 'unknown key "lobs"' in said and "make:" not in said, said
    said = message_of(lambda: tiprub.plots.budget(tiprub.open_response("response.h5")))
    assert "simulate with" in said, said


TRUSS = """[reduce]
speed_max_rpm = 20000
contact_nodes = 4
fixed_interface_modes = 3
"""


BLADE = np.array([[0.10, -0.01, 0.00], [0.10, 0.01, 0.00], [0.15, 0.004, 0.01], [0.10, -0.01, 0.03],
                  [0.15, 0.005, 0.03], [0.10, 0.01, 0.03], [0.12, -0.01, 0.00], [0.12, 0.01, 0.01],
                  [0.13, -0.01, 0.02], [0.15, -0.005, 0.00], [0.13, 0.01, 0.03], [0.15, -0.004, 0.02]])


def truss(nodes):
    """K [N/m] and M [kg] of bars between all nodes, which nothing holds."""
    K = np.zeros((nodes.size, nodes.size))
    for (a, start), (b, end) in itertools.combinations(enumerate(nodes), 2):
        bar = np.zeros(nodes.size)
        bar[3 * b:3 * b + 3] = (end - start) / np.linalg.norm(end - start)
        bar[3 * a:3 * a + 3] = -bar[3 * b:3 * b + 3]
        K += 1e6 * np.outer(bar, bar)
    return K, 1e-3 * np.kron(np.diag(1 + np.arange(len(nodes))), np.eye(3))


def order_of_contact(tiprub, programs):
    """Symptom: nodes.csv held the contact nodes by their numbers, so that the given order from leading to trailing edge was
    lost: the edges were exchanged, or tiprub-reduce refused a line that turned back. The given order is that of the file."""
    from scipy import io
    nodes = BLADE  # its tip from z = 0 to 0.03 is 9, 2, 11, 4
    K, M = truss(nodes)
    for order in ([9, 2, 11, 4], [4, 11, 2, 9]):
        folder = f"truss_{order[0]}"
        os.makedirs(folder)
        arguments = tiprub.matrices(K, M, nodes, {"clamped": [0, 1, 3, 5], "contact": order}, folder, at={20000: 1.1 * K})
        with open(os.path.join(folder, "nodes.csv"), newline="", encoding="ascii") as file:
            rows = list(csv.DictReader(file))
        places = np.array([[float(row[axis]) for axis in "xyz"] for row in rows])
        node = [int(np.argmin(np.linalg.norm(nodes - place, axis=1))) for place in places]
        assert [node[k] for k, row in enumerate(rows) if row["set"] == "contact"] == order, rows
        assert all(node[k] == k for k in range(12) if k not in order), "the other nodes stay"
        assert [k for k, row in enumerate(rows) if row["set"] == "clamped"] == [0, 1, 3, 5], rows
        dofs = (3 * np.array(node)[:, None] + np.arange(3)).ravel()
        for path, matrix in zip((*arguments[1:3], arguments[-1]), (K, M, 1.1 * K)):
            written = io.mmread(path).toarray()
            assert np.allclose(written, matrix[np.ix_(dofs, dofs)], rtol=1e-14), path
            assert np.allclose(np.linalg.eigvalsh(written), np.linalg.eigvalsh(matrix), rtol=1e-9, atol=1e-6), path
        with open(os.path.join(folder, "case.toml"), "w", encoding="ascii") as file:
            file.write(TRUSS)
        model = os.path.join(folder, "model.h5")
        subprocess.run([os.path.join(programs, "tiprub-reduce"), "-q", os.path.join(folder, "case.toml"), *arguments, "-o", model], check=True)
        assert np.allclose(tiprub.Model.read(model).position[:, 2], nodes[order, 2])


def wrong_matrices(tiprub):
    """They are refused before anything is written, in the caller's own numbers."""
    from scipy import sparse
    (K, M), nodes = truss(BLADE), BLADE
    uneven, endless = K.copy(), K.copy()
    uneven[30, 7] += 100
    uneven[3, 8] += 200
    endless[5, 5] = np.nan
    triangle = "only one triangle is filled: pass "
    for k, (matrices, contact, phrase) in enumerate((
            ({"K": uneven}, [9, 2], "K is not symmetric: K[3, 8] = -189481.3"),
            ({"K": np.tril(K)}, [9, 2], "K: " + triangle + "K + scipy.sparse.tril(K, -1).T"),
            ({"K": sparse.triu(K)}, [9, 2], "K: " + triangle + "K + scipy.sparse.triu(K, 1).T"),
            ({"M": M + np.triu(np.ones(M.shape), 1)}, [9, 2], "M: " + triangle + "M + scipy.sparse.triu(M, 1).T"),
            ({"at": {20000: np.tril(K)}}, [9, 2], "at[20000]: " + triangle + "at[20000] + scipy.sparse.tril(at[20000], -1).T"),
            ({"K": endless}, [9, 2], "K[5, 5] = nan is not finite"),
            ({"M": 1j * M}, [9, 2], "M is complex"),
            ({"M": M[1:, 1:]}, [9, 2], "M has the shape (35, 35); the nodes need 36 rows"),
            ({}, {9, 2}, "sets['contact'] has no order"),
            ({}, [9, 12], "sets['contact']: there is no node 12; the 12 nodes count from 0"))):
        folder = f"wrong_{k}"
        os.makedirs(folder)
        said = message_of(lambda given=matrices, line=contact, to=folder: tiprub.matrices(nodes=nodes, sets={"contact": line}, folder=to, **{"K": K, "M": M, **given}))
        assert phrase in said, (phrase, said)
        assert not os.listdir(folder), phrase
    installed = {name: module for name, module in sys.modules.items() if name.split(".")[0] == "scipy"}
    sys.modules.update({name: None for name in installed})
    said = message_of(lambda: tiprub.matrices(K, M, nodes, {"contact": [9, 2]}, folder), ModuleNotFoundError)
    sys.modules.update(installed)
    assert "python3-scipy" in said and not os.listdir(folder), said
    rounded = K * (1 + 1e-12 * np.triu(np.ones(K.shape), 1))
    tiprub.matrices(rounded, M, nodes, {"contact": [9, 2]})  # as the programs allow


def missing_files(tiprub):
    """What is not there is named together with what makes it. Symptom: "[Errno 2]" of none/summary.json, or an empty table."""
    response, alone = tiprub.open_response("response.h5"), tiprub.open_response("response.h5", report="none")
    for call in (lambda: alone.critical_speeds, lambda: alone.table("speeds"), lambda: tiprub.plots.interaction_map(alone)):
        said = message_of(call, FileNotFoundError)
        assert "none/" in said and "tiprub-postprocess" in said and "report=" in said and "Errno" not in said, said
    said = message_of(lambda: response.field(27000, "no_fields.h5"), FileNotFoundError)
    assert said.startswith("no_fields.h5: ") and "tiprub-reduce --fields" in said and "fields=" in said, said
    said = message_of(lambda: response.normal_motion(27000, "no_model.h5"), FileNotFoundError)
    assert said.startswith("no_model.h5: ") and "model=" in said, said
    for name in ("nonsense", "title", "scope"):
        said = message_of(lambda name=name: response.table(name))
        assert repr(name) in said and "critical_speeds, speeds, exactness" in said and "verdict" not in said, said
    assert len(response.table("speeds")) == 4 and response.table("error_budget").empty


def removed_keys(tiprub):
    """Symptom: None made the setting KEY=null, which is no TOML. It removes the key, so that its default holds: a ratio of 0.005."""
    def damping(response):
        return response.summary["scene"]["Damping"]

    assert damping(tiprub.open_response("response.h5")).startswith("ratio 0.02 of critical")
    files = {"model": "model.h5", "fields": "fields.h5"}
    without = tiprub.run("case.toml", set={"simulate.damping_ratio": None}, folder="without", progress=False, **{key.upper(): file for key, file in files.items()})
    assert damping(without).startswith("ratio 0.005 of critical"), damping(without)
    ratio = {"key": "simulate.damping_ratio", "values": {"default": None, "high": 0.03}}
    tiprub.study({"case": "case.toml", **files, "settings": {"simulate.step_tolerance": None}, "grid": {"ratio": ratio}}, folder="removed", progress=False)
    for label, expected in (("default", "0.005"), ("high", "0.03")):
        point = tiprub.open_response(f"removed/runs/points/ratio_{label}/response.h5")
        assert damping(point).startswith(f"ratio {expected} of critical"), damping(point)
        assert point.file.attrs["step_tolerance"] != 0.1


def example_of_the_page(tiprub, source):
    """The page's example makes a wheel of six from a sector whose cuts meet the clamped bore."""
    with open(os.path.join(source, "reduce", "format.md"), encoding="utf-8") as page:
        example = page.read().split("## A sector by its matrices")[1].split("```python\n")[1].split("```")[0]
    polar = [(radius, side * np.pi / 6, z) for radius in (0.03, 0.06) for side in (-1, 0, 1) for z in (0, 0.02)]
    polar += [(0.1, 0.05, 0.02), (0.1, 0.02, 0), (0.08, 0, 0.005), (0.1, 0.03, 0.01), (0.1, 0.06, 0.03)]
    nodes = np.array([[r * np.cos(angle), r * np.sin(angle), z] for r, angle, z in polar])
    (K, M), tip = truss(nodes), [13, 15, 12, 16]
    os.makedirs("page")
    with open("page/case.toml", "w", encoding="ascii") as file:
        file.write(TRUSS)
    np.savez("page/sector.npz", K=K, M=M, nodes=nodes, tip=tip)
    with open("page/example.py", "w", encoding="ascii") as file:
        file.write('import subprocess, numpy as np, tiprub\nglobals().update(np.load("sector.npz"))\n' + example)
    subprocess.run([sys.executable, "-B", "example.py"], cwd="page", check=True)
    model = tiprub.Model.read("page/model.h5")
    assert model.sector_count == 6 and sorted(model.matrices) == [0, 1, 2, 3]
    assert np.allclose(model.position[:, 2], nodes[tip, 2])


def gallery(scripts):
    """Each script draws its picture; that of a blade compares its frequency with the closed form."""
    names = ("interaction_map", "campbell", "travelling_wave", "own_blade")
    running = [subprocess.Popen([sys.executable, "-B", os.path.join(scripts, name + ".py"), "."], text=True, stdout=subprocess.PIPE) for name in names]
    said = [each.communicate()[0] for each in running]
    assert all(each.returncode == 0 for each in running), said
    assert all(os.path.getsize(name + ".png") > 10_000 for name in names)
    words = said[-1].split()
    reduced, beam = (float(word) for before, word in zip(words[1:], words[2:]) if before in ("frequency", "beam"))
    assert abs(reduced / beam - 1) < 1e-3, said[-1]


def wheel(source):
    """pip makes it by this call."""
    shutil.copytree(os.path.join(source, "postprocess", "python"), "wheel")
    script = "import setuptools.build_meta as build; print(build.build_wheel('.'))"
    made = subprocess.run([sys.executable, "-c", script], cwd="wheel", text=True, stdout=subprocess.PIPE, check=True).stdout.split()[-1]
    with zipfile.ZipFile(os.path.join("wheel", made)) as files:
        assert {f"tiprub/{name}.py" for name in ("__init__", *MODULES)} <= set(files.namelist()), files.namelist()


def main(source, programs, made, work):
    shutil.rmtree(work, ignore_errors=True)
    shutil.copytree(made, work)
    os.chdir(work)
    package = os.path.join(source, "postprocess", "python")
    os.environ.update(PYTHONPATH=package, PATH=programs + os.pathsep + os.environ["PATH"], MPLBACKEND="agg")
    sys.path.insert(0, package)
    import tiprub
    for check in (doctests, frequencies, motion, varied_motion, units, missing_files, removed_keys):
        check(tiprub)
    wheel_for_calculix(tiprub, programs)
    wheel_for_nastran(tiprub)
    wheel_of_pyramids(tiprub)
    refusals(tiprub, programs)
    order_of_contact(tiprub, programs)
    wrong_matrices(tiprub)
    example_of_the_page(tiprub, source)
    gallery(os.path.join(source, "cases", "reading"))
    wheel(source)


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
