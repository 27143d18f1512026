# SPDX-License-Identifier: GPL-3.0-or-later
"""The small wheel's case and model, and models with one thing wrong, for messages.cmake.   inputs_of_messages.py <folder>"""
import os
import sys

from small_wheel import CASE, write_model


def not_finite(file):
    data = file["nodal_diameter/0/K0"][()]
    data.flat[1] = float("nan")
    file["nodal_diameter/0/K0"][...] = data


def other_schema(file):
    file.attrs["schema"] = b"tiprub-response"


def not_hermitian(file):
    mass = file["nodal_diameter/0/M"][()]
    mass.flat[1] = 0.5
    file["nodal_diameter/0/M"][...] = mass


def unstable(file):
    file["nodal_diameter/1/K1"] = -1e3 * file["nodal_diameter/1/M"][()]


def doubtful(file):
    file.create_group("verification").attrs.update(shape_imbalance=0.65, shape_tolerance=1e-4)


def seven(file):
    file.attrs["sector_count"] = 7


def slow(file):
    file.attrs["speed_max"] = 1000.0


folder = sys.argv[1]
os.makedirs(folder, exist_ok=True)
TEXTS = {"case.toml": CASE, "text.h5": "text", "profile.csv": "angle_deg, 0.0, 1.0\n0, 2e-4, 1e-4\n90, -2e-4, wide\n",
         "long.csv": "angle_deg, 0.0\n0, 0.2\n", "damping.csv": "Hz, ratio\n100, 0.001\n2e3, 0.002\n", "overdamped.csv": "100, 0.001\n2e3, 2\n",
         "modes.csv": "ND, family, ratio\n0, 1, 0.001\n2, 1, 0.003\n", "modes_twice.csv": "0, 1, 0.001\n0, 1, 0.002\n",
         "distortion.csv": "deg, m\n0, -1e-4\n30, 0.2\n60, 1e-4\n", "speeds.csv": "9000\n10000\n9500\n",
         "edges.csv": "angle_deg, 0.0, 1.0\n0, 0.0, 2e-4\n90, 0.0, -2e-4\n", "clearance.csv": "fraction, m\n0, 1.5e-4\n1, 0.12\n"}
for name, text in TEXTS.items():
    with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
        file.write(text)
write_model(os.path.join(folder, "model.h5"))
for change in (not_finite, other_schema, not_hermitian, unstable, doubtful, seven, slow):
    write_model(os.path.join(folder, change.__name__ + ".h5"), change)
