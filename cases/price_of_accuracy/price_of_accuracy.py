#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What accuracy costs over the whole chain, from the mesh to the stress at a critical speed.

usage: price_of_accuracy.py PROGRAMS_FOLDER CASES_FOLDER knobs|mesh|wheels|peaks

Takes the wheel and the casing of impeller_quick through all four programs in a window of speeds around its largest peak, and reads
off there: the located critical speed, how far the leading corner of the tip moves (half of the peak-to-peak of its largest
component; a place that every mesh has, whatever carries contact), and the largest alternating stress outside the tip patch.

knobs   on the case's mesh, one knob at a time off the finest reduction and march: knobs.tsv
mesh    the finest on finer and finer meshes, the first of which is the reference, and whole settings that a user might choose, the
        case as it is among them: mesh.tsv
wheels  what `accuracy` comes to on two wheels, beside the finest reduction and march on the same mesh: CASE.tsv
peaks   whole sweeps with the settings of `mesh`, and the errors at three critical speeds: peaks.tsv

A line a run: group, name, dofs a sector, processor time [s] of the four programs and in all, speed [rpm], corner [mm],
stress [MPa], what the report says was reached, and the errors of the three against the table's reference, its first line.
What was computed stays in runs/ and is not computed again.
"""
import csv
import hashlib
import os
import resource
import subprocess
import sys

import h5py
import numpy

MESH_KEYS = ["elements_along_chord", "elements_along_bore", "elements_along_span", "elements_through_blade",
             "elements_through_splitter", "elements_through_disc", "elements_between_blades"]
MESHES = {"8": (8, 3, 4, 2, 2, 2, 2), "12": (12, 5, 6, 3, 2, 3, 2), "16": (16, 6, 8, 4, 2, 4, 2), "24": (24, 10, 12, 6, 3, 5, 4)}  # by elements along the chord, all others in proportion
# What the wheel is studied with, whatever its case says.
BASES = {"impeller_quick": {"mesh.fillet_radius": 0, "reduce.contact": '"points"', "reduce.contact_nodes": 10, "reduce.speed_max_rpm": 22000,
                            "simulate.gap": '"linear"', "simulate.budget": '"none"'}}
WINDOW = {"simulate.speed_min_rpm": 18500, "simulate.speed_max_rpm": 20500, "simulate.speed_count": 9}  # 250 rpm, as in the case
FINEST_MODEL = {"reduce.contact": '"segments"', "reduce.prestress": '"nonlinear"',
                "reduce.fixed_interface_modes": 80, "reduce.modes_at_speed": 0, "reduce.frequency_tolerance": 1e-4}
FINEST_MARCH = {"simulate.step_tolerance": 2e-3, "simulate.settle_tolerance": 2e-5, "simulate.max_revolutions": 400}


def mesh(name, **further):
    return {**{f"mesh.{key}": count for key, count in zip(MESH_KEYS, MESHES[name])}, **{f"mesh.{k}": v for k, v in further.items()}}


ON_FIRST_PAGE = [("mesh.tsv", "the case, by default: segments", "on 10 segments of the tip, the default"),
                 ("knobs.tsv", "14 segments", "on 14 segments, as in impeller_quick, with the finest reduction and march"),
                 ("mesh.tsv", "the case: points, accuracy 0.02", "at 10 nodes, as in the paper")]
FINEST = {**WINDOW, **FINEST_MODEL, **FINEST_MARCH}  # on the case's mesh: knobs that don't hang on it are turned here
MESHED = {name: {**FINEST, **mesh(name), "reduce.contact_nodes": int(name)} for name in reversed(MESHES)}
KNOBS = {  # group: name: what differs from the base
    "contact": {"points": {"reduce.contact": '"points"'}, "14 segments": {"reduce.contact_nodes": 14}, "7 segments": {"reduce.contact_nodes": 7}},
    "prestress": {"linear": {"reduce.prestress": '"linear"'}, "stress only": {"reduce.prestress": '"stress_only"'}},
    "modes": {"40 and 60 at a speed": {"reduce.fixed_interface_modes": 40, "reduce.modes_at_speed": 60, "reduce.frequency_tolerance": 5e-4},
              "20 and 20 at a speed": {"reduce.fixed_interface_modes": 20, "reduce.modes_at_speed": 20, "reduce.frequency_tolerance": 5e-4}},
    "step": {"5e-3": {"simulate.step_tolerance": 5e-3}, "2e-2": {"simulate.step_tolerance": 2e-2}, "1e-1": {"simulate.step_tolerance": 1e-1}},
    "settling": {"1e-4": {"simulate.settle_tolerance": 1e-4, "simulate.max_revolutions": 200},
                 "1e-2": {"simulate.settle_tolerance": 1e-2, "simulate.max_revolutions": 200}},
    "speeds": {"a grid of 250 rpm": {"simulate.speeds": '"given"'}, "a grid of 100 rpm": {"simulate.speeds": '"given"', "simulate.speed_count": 21}},
    "scheme": {"central differences": {"simulate.scheme": '"central_differences"'},
               "Moreau-Jean": {"simulate.scheme": '"moreau_jean"'}},
    "symmetry": {"not used": {"simulate.nodal_diameters": '"all"'}},
    "steady state": {"orbits": {"simulate.steady_state": '"orbit"'}},
}


SEGMENTS = {"reduce.contact": '"segments"'}  # the default


def asked(accuracy):
    return {"reduce.accuracy": accuracy, "simulate.accuracy": accuracy}


def meshed(name):
    """A mesh with contact by as many segments as it has elements along the chord."""
    return {**mesh(name), **SEGMENTS, "reduce.contact_nodes": int(name)}


COMBINATIONS = {  # beside the reference of mesh.tsv; the first two have the mesh of the case
    "the case: points, accuracy 0.02": {}, "the case, by default: segments": SEGMENTS,
    "8 along the chord, accuracy 0.1": {**meshed("8"), **asked(0.1)}, "8, accuracy 0.02": meshed("8"),
    "12, accuracy 0.1": {**meshed("12"), **asked(0.1)}, "12, accuracy 0.02": meshed("12"),
    "16, accuracy 0.1": {**meshed("16"), **asked(0.1)}, "16, accuracy 0.02": meshed("16"), "16, accuracy 0.005": {**meshed("16"), **asked(0.005)},
    "16, graded, accuracy 0.02": {**meshed("16"), **mesh("16", grading_along_chord=4)},
    "24, accuracy 0.02": meshed("24")}
SWEEP = {"simulate.speed_min_rpm": 9000, "simulate.speed_max_rpm": 22000, "simulate.speed_count": 53}
SWEPT = ["the case: points, accuracy 0.02", "the case, by default: segments", "8 along the chord, accuracy 0.1", "12, accuracy 0.02",
         "16, accuracy 0.02", "16, accuracy 0.005", "24, accuracy 0.02"]
PEAKS, LEAST_SHARE = 3, 0.4  # a critical speed whose wave holds less of the motion has another name on another mesh
SAME_PEAK = 0.05  # of the speed: the same wave farther away is another critical speed
WHEELS = {"impeller_quick": WINDOW,
          "fast_impeller": {"simulate.speed_min_rpm": 41000, "simulate.speed_max_rpm": 45000, "simulate.speed_count": 9}}


class Chain:
    """Runs of the four programs; a file that is there is taken as it is, with the time that it took."""

    def __init__(self, programs, cases, case):
        self.programs, self.name, self.case = programs, case, os.path.join(cases, case, "case.toml")
        os.makedirs("runs", exist_ok=True)

    def stage(self, program, inputs, output, settings):
        """[s] of processor time. The output's name stands for its settings."""
        noted = output + ".seconds"
        if not os.path.exists(noted):
            words = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run([os.path.join(self.programs, program), "-q", self.case, *inputs, "-o", output, *words], check=True,
                           stdout=subprocess.DEVNULL)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            with open(noted, "w", encoding="utf-8") as file:
                file.write(f"{after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime:.2f}")
        with open(noted, encoding="utf-8") as file:
            return float(file.read())

    def path(self, kind, suffix, settings, tables):
        """A file's name by the values that it hangs on."""
        values = sorted((key, str(value)) for key, value in settings.items() if key.split(".")[0] in tables)
        return os.path.join("runs", f"{kind}_{self.name}_{hashlib.sha256(repr(values).encode()).hexdigest()[:12]}{suffix}")

    def run(self, settings):
        """Dofs a sector, seconds of the four programs, and the critical speeds, as `read_off` tells them."""
        settings = {**BASES.get(self.name, {}), **settings}
        sector = self.path("sector", ".msh", settings, ["mesh"])
        model = self.path("model", ".h5", settings, ["mesh", "reduce"])
        fields = model.replace("model", "fields", 1)
        response = self.path("response", ".h5", settings, ["mesh", "reduce", "simulate"])
        report = response.replace("response", "report", 1).removesuffix(".h5")
        seconds = [self.stage("tiprub-mesh", [], sector, settings),
                   self.stage("tiprub-reduce", [sector, "--fields", fields], model,
                              {"reduce.verification_speeds": [0.0], "reduce.threads": 1, **settings}),
                   self.stage("tiprub-simulate", [model, "--threads", "1"], response, settings),
                   self.stage("tiprub-postprocess", [model, response, "--fields", fields], report, settings)]
        with h5py.File(fields) as file:
            return 3 * len(file["nodes"]), seconds, read_off(response, fields, report)


def read_off(response, fields, report):
    """Speed [rpm], corner [mm], stress [MPa], wave and its share [1] of each critical speed, the largest amplitude first."""
    with open(os.path.join(report, "critical_speeds.csv"), encoding="utf-8") as file:
        rows = sorted(csv.DictReader(file), key=lambda row: -float(row["amplitude [mm]"]))
    if not rows:
        raise LookupError(f"{report}: no critical speed")
    return [(float(row["speed [rpm]"]), corner_motion(response, fields, float(row["speed [rpm]"])), float(row["alternating [MPa]"] or "nan"),
             f"EO {row['engine order']} ND {int(row['signed nodal diameter']):+d}".replace("+0", "0"), float(row["wave share [1]"])) for row in rows]


def corner_motion(response, fields, rpm):
    """[mm] of the first node of the contact line, the leading corner of the tip, over the cycle that the response keeps."""
    with h5py.File(response) as motion, h5py.File(fields) as shapes:
        sectors = motion.attrs["sector_count"]
        group = min(motion["speed"].values(), key=lambda group: abs(group.attrs["speed"] * 30 / numpy.pi - rpm))
        if "cycle" not in group:
            return float("nan")
        corner = shapes["node_set/contact_line"][0]
        largest = 0.0
        for sector in range(motion.attrs["independent_sectors"]):
            moved = sum(numpy.real(numpy.tensordot(states[:].T, shapes[f"nodal_diameter/{n}/basis"][:, corner], 1)
                                   * numpy.exp(2j * numpy.pi * int(n) * sector / sectors)) for n, states in group["cycle"].items())
            largest = max(largest, 0.5e3 * numpy.ptp(moved, axis=0).max())
        return largest


def table(name, chain, rows):
    """Writes a line a run as soon as it is there; the first row is the reference."""
    reference = None
    with open(name + ".part", "w", encoding="utf-8") as file:
        file.write("\t".join(["group", "name", "dofs a sector", "mesh [s]", "reduce [s]", "simulate [s]", "postprocess [s]", "in all [s]",
                              "speed [rpm]", "corner [mm]", "stress [MPa]", "wave", "error of the speed", "of the corner", "of the stress"]) + "\n")
        for group, title, settings in rows:
            try:
                dofs, seconds, ((*values, wave, _), *_) = chain.run(settings)
            except (subprocess.CalledProcessError, LookupError) as error:
                print(f"price_of_accuracy: {group}, {title}: {error}", file=sys.stderr)
                file.write(f"{group}\t{title}\tfailed\n")
                continue
            reference = reference or values
            errors = [abs(value / exact - 1.0) for value, exact in zip(values, reference)]
            file.write("\t".join([group, title, str(dofs), *(f"{value:.1f}" for value in [*seconds, sum(seconds)]),
                                  *(f"{value:.6g}" for value in values), wave, *(f"{value:.2e}" for value in errors)]) + "\n")
            file.flush()
    os.replace(name + ".part", name)  # make goes by this table
    page_table(name)
    first_page()


def peaks_table(name, chain, rows):
    """Writes a line a run and critical speed. The first run, the reference, chooses the speeds: those of the largest corners among
    those whose wave holds LEAST_SHARE of the motion. Elsewhere the nearest critical speed of the same wave is taken."""
    exact = None
    with open(name + ".part", "w", encoding="utf-8") as file:
        file.write("\t".join(["group", "name", "dofs a sector", "in all [s]", "peak", "speed [rpm]", "corner [mm]", "stress [MPa]", "wave",
                              "error of the speed", "of the corner", "of the stress"]) + "\n")
        for group, title, settings in rows:
            dofs, seconds, found = chain.run(settings)
            exact = exact or sorted((peak for peak in found if peak[4] >= LEAST_SHARE), key=lambda peak: -peak[1])[:PEAKS]
            for number, (*values, wave, _) in enumerate(exact, 1):
                near = [peak for peak in found if peak[3] == wave and abs(peak[0] / values[0] - 1) < SAME_PEAK]
                line = [group, title, str(dofs), f"{sum(seconds):.1f}", str(number)]
                if near:
                    here = min(near, key=lambda peak: abs(peak[0] - values[0]))[:3]
                    line += [*(f"{value:.6g}" for value in here), wave, *(f"{abs(a / b - 1):.2e}" for a, b in zip(here, values))]
                else:
                    line += ["no such peak", "", "", wave, "", "", ""]
                file.write("\t".join(line) + "\n")
            file.flush()
    os.replace(name + ".part", name)
    page_peaks(name)


def page_peaks(name):
    """page_NAME: a line a run, with the errors of speed, corner and stress in percent in one column for each critical speed."""
    with open(name, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file, delimiter="\t"))
    peaks = [row for row in rows if row["name"] == rows[0]["name"]]
    with open(f"page_{name}", "w", encoding="utf-8") as file:
        file.write("\t".join(["", "s", *(f"{row['wave']}, {float(row['speed [rpm]']):,.0f} rpm" for row in peaks)]) + "\n")
        for first in range(0, len(rows), len(peaks)):
            cells = [", ".join(f"{100 * float(row[column]):.2g}" for column in ("error of the speed", "of the corner", "of the stress"))
                     if row["error of the speed"] else row["speed [rpm]"] for row in rows[first:first + len(peaks)]]
            file.write("\t".join([rows[first]["name"], format(float(rows[first]["in all [s]"]), ".0f"), *cells]) + "\n")


def rows_by_name(table):
    """The rows of a table by their names, those of failed runs left out; nothing if there is no table."""
    if not os.path.exists(table):
        return {}
    with open(table, newline="", encoding="utf-8") as file:
        return {row["name"]: row for row in csv.DictReader(file, delimiter="\t") if row["in all [s]"]}


def first_page():
    """The errors of contact models relative to the finest mesh, and how uncertain that is, for the project's first page."""
    tables = {table: rows_by_name(table) for table, _, _ in ON_FIRST_PAGE}
    finest, coarser = (tables["mesh.tsv"].get(f"{count} along the chord") for count in ("24", "16"))
    if not finest or not coarser or any(name not in tables[table] for table, name, _ in ON_FIRST_PAGE):
        return  # until both tables are complete

    def errors(row):
        # Rounded as in the tables before, so that both pages show the same.
        return [f"{100 * float(format(abs(float(row[column]) / float(finest[column]) - 1), '.2e')):.2g} %"
                for column in ("speed [rpm]", "corner [mm]", "stress [MPa]")]

    with open("first_page.tsv", "w", encoding="utf-8") as file:
        file.write("\t".join(["contact", "critical speed", "tip motion", "stress"]) + "\n")
        for table, name, title in ON_FIRST_PAGE:
            file.write("\t".join([title, *errors(tables[table][name])]) + "\n")
    with open("uncertainty_numbers.tsv", "w", encoding="utf-8") as file:
        file.write("key\tvalue\n")
        for key, error in zip(("speed", "motion", "stress"), errors(coarser)):
            file.write(f"uncertainty.{key}\t{error}\n")


def page_table(name):
    """page_NAME: seconds and errors in percent, as the page shows them; a run that failed is left out."""
    with open(f"page_{name}", "w", encoding="utf-8") as file:
        file.write("\t".join(["", "", "s", "critical speed [%]", "motion [%]", "stress [%]"]) + "\n")
        for row in rows_by_name(name).values():
            errors = [100 * float(row[column]) for column in ("error of the speed", "of the corner", "of the stress")]
            file.write("\t".join([row["group"], row["name"], format(float(row["in all [s]"]), ".0f"), *(f"{error:.2g}" for error in errors)]) + "\n")


def main(programs, cases, what):
    def chain(case):
        return Chain(os.path.abspath(programs), os.path.abspath(cases), case)

    if what == "knobs":
        table("knobs.tsv", chain("impeller_quick"),
              [("reference", "the finest on the case's mesh", FINEST),
               *((group, name, {**FINEST, **change}) for group, names in KNOBS.items() for name, change in names.items())])
    elif what == "mesh":
        table("mesh.tsv", chain("impeller_quick"),
              [*(("finest", f"{name} along the chord", settings) for name, settings in MESHED.items()),
               *(("combination", name, {**WINDOW, **change}) for name, change in COMBINATIONS.items())])
    elif what == "peaks":
        peaks_table("peaks.tsv", chain("impeller_quick"),
                    [*(("finest", f"{name} along the chord", {**SWEEP, **FINEST_MODEL, **FINEST_MARCH, **mesh(name), "reduce.contact_nodes": int(name)})
                       for name in ("24", "16")),
                     *(("combination", name, {**SWEEP, **COMBINATIONS[name]}) for name in SWEPT)])
    else:
        # Prestress and contact are the case's: what they leave out is no matter of accuracy.
        finest = {key: value for key, value in {**FINEST_MODEL, **FINEST_MARCH}.items() if key not in ("reduce.prestress", "reduce.contact")}
        for case, window in WHEELS.items():
            table(f"{case}.tsv", chain(case), [("reference", "the finest on the case's mesh", {**window, **finest}),
                                               *(("accuracy", str(value), {**window, **asked(value)}) for value in (0.1, 0.02, 0.005))])


if __name__ == "__main__":
    main(*sys.argv[1:4])
