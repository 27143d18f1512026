# SPDX-License-Identifier: GPL-3.0-or-later
"""A small wheel as model.h5 and a scene as case.toml, for the tests of the executable."""
import os
import subprocess
import sys

try:
    import h5py
    import numpy as np
except ImportError:
    print("SKIPPED: needs python3-h5py")
    sys.exit(77)

SECTORS, NODES, GENERALIZED = 6, 3, 9

CASE = """
[casing]
shape = "cosine"
lobes = 2
amplitude = 2.0e-4
clearance = [[0.0, 1.5e-4], [1.0, 1.2e-4]]
[simulate]
speed_min_rpm = 9000
speed_max_rpm = 12000
speed_count = 40
damping_ratio = 0.005
min_revolutions = 40
max_revolutions = 70
speeds = "given"
"""


def write_model(path, change=lambda file: None):
    random = np.random.default_rng(3)
    size = 3 * NODES + GENERALIZED
    spread, tie = random.standard_normal((2, size, size))
    own = 1e6 * (np.eye(size) + spread @ spread.T)
    with h5py.File(path, "w") as file:
        file.attrs["schema"] = np.bytes_("tiprub-model")
        file.attrs["schema_version"] = 1
        file.attrs["generator"] = np.bytes_("small_wheel.py")
        file.attrs["sector_count"] = SECTORS
        file.attrs["speed_max"] = 2000.0
        tilt = np.linspace(0, 1.4, NODES)
        radius, height = 0.1 + 0.01 * tilt, 0.01 * tilt
        file["contact/position"] = np.c_[radius, 0.05 * tilt, height]
        file["contact/normal"] = np.c_[np.cos(tilt), 0 * tilt, np.sin(tilt)]
        steps = np.hypot(np.diff(radius), np.diff(height))
        file["contact/arc_length"] = np.append(0, np.cumsum(steps))
        file["contact/static_shift_1"] = np.tile([2e-10, 0.0, 0.0], (NODES, 1))
        for n in range(SECTORS // 2 + 1):
            wave = 2e4 * tie * np.exp(2j * np.pi * n / SECTORS)
            K = own + wave + wave.conj().T
            standing = n == 0 or 2 * n == SECTORS
            file[f"nodal_diameter/{n}/K0"] = K.real if standing else K
            file[f"nodal_diameter/{n}/M"] = 1e-2 * np.eye(size)
        change(file)


class Bench:
    """A folder with a case and a model, and the executable."""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder
        subprocess.run(["rm", "-rf", folder], check=True)
        os.makedirs(folder)
        self.write("case.toml", CASE)
        write_model(self.path("model.h5"))

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w") as file:
            file.write(text)

    def command(self, *arguments, case="case.toml", model="model.h5", output="response.h5"):
        return [self.program, self.path(case), self.path(model), "-o", self.path(output), *arguments]

    def run(self, *arguments, **names):
        return subprocess.run(self.command(*arguments, **names), stderr=subprocess.PIPE, text=True)

    def read(self, name="response.h5"):
        with open(self.path(name), "rb") as file:
            return file.read()


def require(holds, what):
    print(("ok: " if holds else "WRONG: ") + what, flush=True)
    if not holds:
        sys.exit(1)
