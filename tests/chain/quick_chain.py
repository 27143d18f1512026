#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The quick impeller from its case to its report, as a user runs it, and what the result must show.

usage: quick_chain.py STEP PROGRAMS_FOLDER CASES_FOLDER WORK_FOLDER

`run` makes a copy of the case with fewer speeds; each other step checks one thing about what was made.
"""
import csv
import os
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import h5py
import numpy

from vtu import numbers_of, read_vtu

SPEED_COUNT = 12
REDUCTION_TOLERANCE = 0.001  # of the first 50 frequencies of the wheel
EDGE_TOLERANCE = 0.03        # of the largest displacement of a corner
ODD_SHARE = 0.01             # of the two-lobe response on odd nodal diameters
SINGLE_PRECISION = 3e-6      # of the largest value
ODD_ORDER_SPEEDS = 0.25      # of the speeds may have their highest peak off the even engine orders


def make(work, programs, *arguments):
    environment = {name: value for name, value in os.environ.items() if not name.startswith("MAKE")}
    return subprocess.run(["make", "-C", work, f"BIN={programs}", *arguments], env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)


def run(programs, cases, work):
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    shutil.copy(os.path.join(cases, "impeller_quick", "case.toml"), work)
    # At points, because the displacement of a segment is that of no node of fields.h5.
    with open(os.path.join(work, "Makefile"), "w", encoding="utf-8") as file:
        file.write("SETTINGS := --set 'reduce.contact=\"points\"'\n")
        file.write(f"SIMULATE_FLAGS := --set simulate.speed_count={SPEED_COUNT} --set 'simulate.speeds=\"given\"' "
                   f"--set 'simulate.budget=\"largest\"'\ninclude {cases}/chain.mk\n")
    made = make(work, programs)
    print(made.stdout)
    assert made.returncode == 0
    for name in ("sector.msh", "model.h5", "response.h5", "report/report.html", "report/critical_speeds.csv"):
        assert os.path.getsize(os.path.join(work, name)) > 0, name


def reduction(programs, cases, work):
    """First 50 frequencies of the wheel, model against unreduced sector, at every verification speed."""
    with h5py.File(os.path.join(work, "model.h5")) as model:
        sectors = int(model.attrs["sector_count"])
        speeds = model["verification/speed"][:]
        top = model.attrs["speed_max"]
        worst = 0.0
        for row in range(len(speeds)):
            pairs = []
            for n in range(sectors // 2 + 1):
                table = model[f"verification/nodal_diameter/{n}"]
                times = 1 if n == 0 or 2 * n == sectors else 2  # a travelling wave and its mirror image
                pairs += list(zip(table["unreduced"][row], table["reduced"][row])) * times
            pairs.sort()
            worst = max(worst, max(abs(reduced / exact - 1) for exact, reduced in pairs[:50]))
    print(f"largest error {100 * worst:.3f} % at {speeds / top} of the top speed")
    unseen = set(numpy.round(speeds / top, 12)) - {0.0, 0.25, 0.5, 0.75, 1.0}  # the basis knows these
    assert speeds[0] == 0 and len(unseen) >= 5
    assert worst < REDUCTION_TOLERANCE


def nodal_diameters(programs, cases, work):
    """A run with all nodal diameters: the two-lobe casing moves the even ones only."""
    response = os.path.join(work, "all.h5")
    subprocess.run([os.path.join(programs, "tiprub-simulate"), "-q", os.path.join(work, "case.toml"),
                    os.path.join(work, "model.h5"), "-o", response, "--set", 'simulate.nodal_diameters="all"',
                    "--set", "simulate.speed_count=3", "--set", 'simulate.speeds="given"', "--set", 'simulate.budget="none"'], check=True)
    with h5py.File(response) as file:
        sectors = int(file.attrs["sector_count"])
        assert int(file.attrs["independent_sectors"]) == sectors
        for group in file["speed"].values():
            motion = numpy.fft.fft(group["displacement"][:], axis=1)
            energy = (abs(motion) ** 2).sum(axis=(0, 2, 3))
            share = numpy.sqrt(energy[1::2].sum() / energy.sum())
            print(f"{group.attrs['speed']:.0f} rad/s: odd nodal diameters hold {share:.1e} of the motion")
            assert energy.sum() > 0 and share < ODD_SHARE


def engine_orders(programs, cases, work):
    """The highest peak of a speed's spectrum lies on an even engine order."""
    off = total = 0
    with h5py.File(os.path.join(work, "response.h5")) as file:
        for group in file["speed"].values():
            revolutions = int(group.attrs["recorded_revolutions"])
            spectrum = (abs(numpy.fft.rfft(group["displacement"][:], axis=0)) ** 2).sum(axis=(1, 2, 3))
            spectrum[0] = 0.0
            order = spectrum.argmax() / revolutions
            total += 1
            off += order % 2 != 0
            print(f"{group.attrs['speed']:.0f} rad/s: highest on engine order {order:g}")
    assert total == SPEED_COUNT and off <= ODD_ORDER_SPEEDS * total


def critical_speeds(programs, cases, work):
    """The table names family, nodal diameter, engine order and wave direction of each peak, and obeys eq. 17."""
    with open(os.path.join(work, "report", "critical_speeds.csv"), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert rows, "no critical speed"
    for row in rows:
        print(row)
        assert int(row["nodal diameter"]) in (0, 2, 4)
        order = float(row["engine order"])
        if order % 2 == 0:
            folded = int(order) % 10
            assert int(row["nodal diameter"]) == min(folded, 10 - folded)
        assert int(row["family"]) >= 1 and row["direction"] in ("forward", "backward", "standing")


def turned_about_z(vectors, angles):
    turned = vectors.copy()
    turned[..., 0] = numpy.cos(angles) * vectors[..., 0] - numpy.sin(angles) * vectors[..., 1]
    turned[..., 1] = numpy.sin(angles) * vectors[..., 0] + numpy.cos(angles) * vectors[..., 1]
    return turned


def snapshot_at(group, fields, sectors, contact):
    """Displacement of the contact nodes of all sectors, r, theta, z, from the snapshot and the basis."""
    wheel = numpy.zeros((sectors, len(contact), 3))
    for n, state in group["snapshot"].items():
        shape = numpy.tensordot(state[:, 0], fields[f"nodal_diameter/{n}/basis"][:][:, contact], 1)
        phases = numpy.exp(2j * numpy.pi * int(n) * numpy.arange(sectors) / sectors)
        wheel += (phases[:, None, None] * shape).real
    return wheel


def expect_same_displacement(fields, response, wheel, worst):
    """Snapshot and basis give the recorded contact nodes at every speed, and the drawn ones at the worst."""
    sectors, held = (int(response.attrs[name]) for name in ("sector_count", "independent_sectors"))
    contact, nodes = fields["node_set/contact"][:], fields["nodes"][:]
    compared = 0
    for group in response["speed"].values():
        sample = int(group["snapshot"].attrs["sample"])
        forces = group["contact_force"][:].sum(axis=(1, 2))
        assert forces[sample] == forces.max()
        moved = snapshot_at(group, fields, sectors, contact)
        recorded = group["displacement"][sample][numpy.arange(sectors) % held]
        error = abs(moved - recorded).max() / abs(recorded).max()
        assert error < SINGLE_PRECISION, f"{group.name}: snapshot and response differ by {error:.1e}"
        if abs(group.attrs["speed"] * 30 / numpy.pi / float(worst["speed [rpm]"]) - 1) < 1e-4:
            angles = (2 * numpy.pi * numpy.arange(sectors)[:, None] / sectors +
                      numpy.arctan2(nodes[contact, 1], nodes[contact, 0]))
            drawn = wheel["displacement_vibration"].reshape(sectors, -1, 3)[:, contact]
            error = abs(turned_about_z(recorded, angles) - drawn).max() / abs(recorded).max()
            print(f"contact nodes in the VTU differ from the response by {error:.1e}")
            assert error < SINGLE_PRECISION
            compared += 1
    assert compared == 1


def expect_same_stress(wheel, sectors):
    """After half a turn, and as von Mises stress of what is drawn."""
    stress = wheel["stress_vibration"].reshape(sectors, -1, 6)
    half = stress * numpy.array([1, 1, 1, 1, -1, -1])  # R sigma R' of half a turn
    error = abs(numpy.roll(stress, sectors // 2, axis=0) - half).max() / abs(stress).max()
    print(f"stress after half a turn differs by {error:.1e}")
    assert error < SINGLE_PRECISION
    whole = wheel["stress_vibration"] + wheel["stress_spin"].astype(float)
    xx, yy, zz, xy, yz, zx = whole.T
    mises = numpy.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3 * (xy ** 2 + yz ** 2 + zx ** 2))
    assert abs(mises - wheel["von_mises"]).max() < SINGLE_PRECISION * mises.max()


def expect_phases(folder, response):
    """The mode a quarter of a period later is the sector's sine, reversed; frequencies are those of the response's table."""
    wheel, sector, numbers = (read(os.path.join(folder, name)) for read, name in
                              ((read_vtu, "modes_wheel.vtu"), (read_vtu, "modes_sector.vtu"), (numbers_of, "modes_wheel.vtu")))
    frequencies = [name for name in numbers if name.endswith("_frequency")]
    assert frequencies and "speed" in numbers
    for name in frequencies:
        mode = name.removesuffix("_frequency")
        later = wheel[mode + "_quarter"][:len(sector[mode + "_sine"])]
        assert abs(later + sector[mode + "_sine"]).max() < SINGLE_PRECISION and wheel[mode].shape == wheel[mode + "_quarter"].shape
        n, family = (int(word.strip("ndfamily")) for word in mode.split("_"))
        table = response[f"frequencies/nodal_diameter/{n}"][:, family - 1]
        expected = numpy.interp(numbers["speed"], response["frequencies/speed"][:], table)
        assert abs(numbers[name] / expected - 1) < 1e-3, (name, numbers[name], expected)


def expect_motion(folder, fields, response):
    """The animation's contact nodes are where the response has them, but for the waves that are left out."""
    frames = [(float(frame.get("timestep")), os.path.join(folder, frame.get("file")))
              for frame in xml.etree.ElementTree.parse(os.path.join(folder, "motion_sector.pvd")).iter("DataSet")]
    speed = numbers_of(frames[0][1])["speed"]
    group = next(group for group in response["speed"].values() if abs(group.attrs["speed"] / speed - 1) < 1e-9)
    sectors, held, contact = int(response.attrs["sector_count"]), int(response.attrs["independent_sectors"]), fields["node_set/contact"][:]
    points = read_vtu(frames[0][1])["Points"][contact]
    angles = numpy.arctan2(points[:, 1], points[:, 0])
    at_rest = numpy.arctan2(fields["nodes"][contact[0], 1], fields["nodes"][contact[0], 0])
    sector = round((angles[0] - at_rest) * sectors / (2 * numpy.pi)) % sectors
    drawn, recorded = [], []
    for time, path in frames:
        angle = numbers_of(path)["rotor_angle"]
        assert abs(angle - time * speed) < 1e-9
        sample = angle * int(group.attrs["samples_per_revolution"]) / (2 * numpy.pi)
        assert abs(sample - round(sample)) < 1e-6
        drawn.append(read_vtu(path)["displacement"][contact])
        recorded.append(turned_about_z(group["displacement"][round(sample) % len(group["displacement"]), sector % held], angles))
    # Small waves are left out, so that the largest one is compared: its engine order over the instants.
    drawn, recorded = (numpy.fft.rfft(motion, axis=0) for motion in (drawn, recorded))
    order = 1 + numpy.argmax(numpy.linalg.norm(recorded[1:], axis=(1, 2)))
    error = numpy.linalg.norm(drawn[order] - recorded[order]) / numpy.linalg.norm(recorded[order])
    print(f"{len(frames)} instants of sector {sector}: engine order {order} of the contact nodes differs by {error:.1e}")
    assert len(frames) == 24 and error < 0.05


def full_fields(programs, cases, work):
    """Snapshot, basis, response and VTU tell the same displacement; stress is the same after half a turn."""
    with open(os.path.join(work, "report", "critical_speeds.csv"), encoding="utf-8", newline="") as file:
        worst = max(csv.DictReader(file), key=lambda row: float(row["amplitude [mm]"]))
    wheel = read_vtu(os.path.join(work, "report", "fields", "contact_wheel.vtu"))
    with h5py.File(os.path.join(work, "fields.h5")) as fields, h5py.File(os.path.join(work, "response.h5")) as response:
        expect_same_displacement(fields, response, wheel, worst)
        expect_same_stress(wheel, int(response.attrs["sector_count"]))
        expect_phases(os.path.join(work, "report", "fields"), response)
        expect_motion(os.path.join(work, "report", "fields"), fields, response)
    assert wheel["connectivity"].max() < len(wheel["Points"]) and set(wheel["types"]) == {25}


def tip_edges(programs, cases, work):
    """The displacement that |u| takes at the edge of a blade on segments is that of its corner; the outermost segment has less."""
    files = {name: os.path.join(work, f"segments_{name}.h5") for name in ("model", "fields", "response")}
    case = os.path.join(work, "case.toml")
    subprocess.run([os.path.join(programs, "tiprub-reduce"), "-q", case, os.path.join(work, "sector.msh"), "-o", files["model"],
                    "--fields", files["fields"]], check=True)
    subprocess.run([os.path.join(programs, "tiprub-simulate"), "-q", case, files["model"], "-o", files["response"], *(word for setting in (
        'simulate.speeds="given"', "simulate.speed_min_rpm=14000", "simulate.speed_max_rpm=19800", "simulate.speed_count=2",
        'simulate.examine="none"', 'simulate.budget="none"') for word in ("--set", setting))], check=True)
    with h5py.File(files["fields"]) as fields, h5py.File(files["response"]) as response:
        corner = fields["node_set/contact_line"][:1]
        for group in response["speed"].values():
            moved = snapshot_at(group, fields, int(response.attrs["sector_count"]), corner)[:, 0]
            segments = group["displacement"][int(group["snapshot"].attrs["sample"])]
            edge = numpy.tensordot(segments[:, :3], numpy.array([33, -19, 4]) / 18, (1, 0))
            difference, of_mean = (abs(there - moved[:len(there)]).max() / abs(moved).max() for there in (edge, segments[:, 0]))
            print(f"{group.attrs['speed']:.0f} rad/s: the corner differs by {difference:.2%} from the edge, by {of_mean:.1%} from the outermost segment")
            assert difference < EDGE_TOLERANCE and of_mean > 3 * EDGE_TOLERANCE


def up_to_date(programs, cases, work):
    """Nothing is made twice, and a change of one stage's table remakes that stage and what follows."""
    assert make(work, programs, "-q", "report/report.html").returncode == 0
    before = os.path.getmtime(os.path.join(work, "response.h5"))
    with open(os.path.join(work, "case.toml"), "a", encoding="utf-8") as file:
        file.write("# a remark\n")
    assert make(work, programs, "-q", "report/report.html").returncode == 0
    with open(os.path.join(work, "case.toml"), "a", encoding="utf-8") as file:
        file.write("families = 4\n")
    made = make(work, programs)
    assert made.returncode == 0 and "tiprub-postprocess case.toml" in made.stdout, made.stdout
    assert "tiprub-simulate case.toml" not in made.stdout
    assert os.path.getmtime(os.path.join(work, "response.h5")) == before


STEPS = {step.__name__: step for step in (run, reduction, nodal_diameters, engine_orders, critical_speeds, full_fields, tip_edges,
                                         up_to_date)}

if __name__ == "__main__":
    STEPS[sys.argv[1]](*map(os.path.abspath, sys.argv[2:]))
