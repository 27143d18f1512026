# SPDX-License-Identifier: GPL-3.0-or-later
"""What the checks look at: a sector's mesh, a reduced model, one simulated case with its report, and the project's own tests."""
import csv
import functools
import os
import re
import subprocess
import sys

import h5py
import numpy

from registry import CannotBeMade

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "chain"))
from vtu import read_vtu

RPM = 30 / numpy.pi           # rev/min in a rad/s
HIGHEST_ORDER = 30            # engine orders held of each spectrum


def read_table(path):
    if not os.path.exists(path):
        raise CannotBeMade(f"no {path}")
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file, delimiter="\t" if path.endswith(".tsv") else ","))


def signed(order, sectors):
    """k mod N in (-N/2, N/2]."""
    n = order % sectors
    return n - sectors if 2 * n > sectors else n


class Mesh:
    """A gmsh 4.1 text file: node places, volume cells, and the nodes of each named group."""

    def __init__(self, path):
        if not os.path.exists(path):
            raise CannotBeMade(f"no {path}")
        self.path = path
        with open(path, encoding="utf-8", errors="replace") as file:
            lines = file.read().split("\n")
        at = {line[1:]: i for i, line in enumerate(lines) if line.startswith("$") and not line.startswith("$End")}
        names = {}
        for line in lines[at["PhysicalNames"] + 2:at["PhysicalNames"] + 2 + int(lines[at["PhysicalNames"] + 1])]:
            dimension, tag, name = line.split(maxsplit=2)
            names[int(dimension), int(tag)] = name.strip('"')
        groups_of = self._entities(lines, at["Entities"], names)
        self._read_nodes(lines, at["Nodes"])
        self._read_cells(lines, at["Elements"], groups_of)

    @staticmethod
    def _entities(lines, at, names):
        counts = [int(word) for word in lines[at + 1].split()]
        groups, row = {}, at + 2
        for dimension, count in enumerate(counts):
            for _ in range(count):
                words = lines[row].split()
                row += 1
                first = 4 if dimension == 0 else 7
                tags = [int(word) for word in words[first + 1:first + 1 + int(words[first])]]
                groups[dimension, int(words[0])] = [names[dimension, tag] for tag in tags]
        return groups

    def _read_nodes(self, lines, at):
        blocks, count = (int(word) for word in lines[at + 1].split()[:2])
        self.place, self.index, row = numpy.empty((count, 3)), {}, at + 2
        for _ in range(blocks):
            size = int(lines[row].split()[3])
            for k in range(size):
                self.index[int(lines[row + 1 + k])] = len(self.index)
                self.place[len(self.index) - 1] = [float(word) for word in lines[row + 1 + size + k].split()]
            row += 1 + 2 * size

    def _read_cells(self, lines, at, groups_of):
        self.cells, self.types, row = {}, set(), at + 2
        for _ in range(int(lines[at + 1].split()[0])):
            dimension, entity, kind, size = (int(word) for word in lines[row].split())
            nodes = [[self.index[int(word)] for word in line.split()[1:]] for line in lines[row + 1:row + 1 + size]]
            row += 1 + size
            if dimension == 3:
                self.types.add(kind)
            for name in groups_of[dimension, entity]:
                self.cells.setdefault(name, []).extend(nodes)

    def nodes(self, group):
        """Sorted node indices of a named group."""
        if group not in self.cells:
            raise CannotBeMade(f"{self.path} has no group {group}")
        return numpy.unique(numpy.concatenate([numpy.asarray(cell) for cell in self.cells[group]]))


class Model:
    """model.h5: the matrices of each nodal diameter."""

    def __init__(self, path):
        if not os.path.exists(path):
            raise CannotBeMade(f"no {path}")
        with h5py.File(path) as file:
            self.sectors, self.speed_max = int(file.attrs["sector_count"]), float(file.attrs["speed_max"])
            self.modes_at_speed = int(file.attrs["modes_at_speed"])
            self.prestress = file.attrs["prestress"].decode()
            self.normal, self.position = file["contact/normal"][:], file["contact/position"][:]
            self.arc_length = file["contact/arc_length"][:]
            count = self.sectors // 2 + 1
            self.matrices = []
            for n in range(count):
                self.matrices.append({name: dataset[:] for name, dataset in file[f"nodal_diameter/{n}"].items()})
            self.verified = []
            if "verification" in file:
                self.verified_speeds = file["verification/speed"][:]
                self.verified = [(file[f"verification/nodal_diameter/{n}/unreduced"][:],
                                  file[f"verification/nodal_diameter/{n}/reduced"][:]) for n in range(count)]

    def times(self, n):
        """A travelling wave and its mirror image, or one standing wave."""
        return 1 if n == 0 or 2 * n == self.sectors else 2

    def stiffness(self, n, speed):
        return sum(speed ** (2 * int(name[1:])) * matrix for name, matrix in self.matrices[n].items() if name != "M")

    def frequencies(self, n, speed):
        """[Hz], ascending."""
        factor = numpy.linalg.inv(numpy.linalg.cholesky(self.matrices[n]["M"]))
        squares = numpy.linalg.eigvalsh(factor @ self.stiffness(n, speed) @ factor.conj().T)
        return numpy.sqrt(numpy.maximum(squares, 0)) / (2 * numpy.pi)

    @functools.cached_property
    def families(self):
        """[Hz] the first ten, nodal diameters x families, at rest, half and full speed."""
        return {share: numpy.array([self.frequencies(n, share * self.speed_max)[:10] for n in range(len(self.matrices))])
                for share in (0.0, 0.5, 1.0)}

    def reduction_error(self, count, rows=None):
        """By verified speed: largest relative error of the first `count` frequencies of the wheel."""
        if not self.verified:
            raise CannotBeMade("the model was not verified")
        errors = {}
        for row in rows if rows is not None else range(len(self.verified_speeds)):
            pairs = sorted((exact, reduced) for n, table in enumerate(self.verified)
                           for exact, reduced in zip(table[0][row], table[1][row]) for _ in range(self.times(n)))
            errors[round(self.verified_speeds[row] / self.speed_max, 6)] = \
                max(abs(reduced / exact - 1) for exact, reduced in pairs[:count])
        return errors

    def padded(self, n, name, size):
        """A matrix of a nodal diameter, which may have fewer generalized dofs than another; those that it doesn't have get
        unit mass and a stiffness beyond all others."""
        given = self.matrices[n][name]
        filler = {"M": 1.0, "K0": 1e3 * self.largest_square}.get(name, 0.0)
        matrix = numpy.diag(numpy.full(size, filler)).astype(complex)
        matrix[:len(given), :len(given)] = given
        return matrix

    @functools.cached_property
    def largest_square(self):
        """[rad^2/s^2] the largest omega^2 at rest."""
        return max((2 * numpy.pi * self.frequencies(n, 0)[-1]) ** 2 for n in range(len(self.matrices)))

    @property
    def size(self):
        """Dofs of a sector of the ring: those of the nodal diameter that has most."""
        return max(len(m["M"]) for m in self.matrices)

    def ring(self, name):
        """A matrix of all N sectors in real sector coordinates, from the blocks of the nodal diameters (eq. 11)."""
        size = self.size
        full = numpy.zeros((self.sectors * size, self.sectors * size))
        for shift in range(self.sectors):
            block = sum((self.times(n) * (self.padded(n, name, size) * numpy.exp(2j * numpy.pi * n * shift / self.sectors)).real
                         for n in range(len(self.matrices))), numpy.zeros((size, size))) / self.sectors
            for j in range(self.sectors):
                i = (j + shift) % self.sectors
                full[i * size:(i + 1) * size, j * size:(j + 1) * size] = block
        return full


def first_speeds(rpm):
    """Of ascending speeds those that are evenly spaced, by the widest gap: an adaptive sweep's first ones. All, if some of those are missing."""
    if len(rpm) < 2:
        return rpm
    gap = numpy.diff(rpm).max()
    grid = numpy.linspace(rpm[0], rpm[-1], 1 + round((rpm[-1] - rpm[0]) / gap))
    nearest = rpm[abs(rpm - grid[:, None]).argmin(axis=1)]
    return nearest if abs(nearest - grid).max() < 1e-6 * gap else rpm


class Speed:
    """One settled speed of a response: its numbers, and spectra of motion and force at both edges."""

    def __init__(self, group, normal, sectors):
        a = group.attrs
        self.attributes = {name: a[name] for name in a}
        self.rpm, self.omega = a["speed"] * RPM, float(a["speed"])
        self.motion = a["motion"].decode()
        self.repeats = self.motion in ("periodic", "subharmonic")
        held = group["contact_force"].shape[1]
        everyone = numpy.arange(sectors) % held
        motion = numpy.einsum("sjkc,kc->sjk", group["displacement"][:], normal)
        force = group["contact_force"][:]
        self.samples, self.revolutions = int(a["samples_per_revolution"]), int(a["recorded_revolutions"])
        self.whole = len(motion) == self.samples * self.revolutions
        self.amplitude = 0.5 * (motion.max(axis=0) - motion.min(axis=0)).max()
        self.count = group["contact_count"][:]
        self.pushed_samples = (force > 0).sum(axis=0)
        self.smallest_force = force.min()
        self.edge_motion = [motion[:, everyone, node] for node in (0, -1)]
        self.edge_force = [force[:, everyone, node] for node in (0, -1)]
        self.waves = [self._spectrum(signal)[0] for signal in self.edge_motion]
        self.force_waves, self.force_off_orders = zip(*(self._spectrum(signal) for signal in self.edge_force))
        self.shift_residual = self._shift_residual(self.edge_motion[0])
        self.edge_motion = self.edge_force = None  # only needed at few speeds: see Case.signals()

    def _spectrum(self, signal):
        """Amplitudes (engine orders 0 .. HIGHEST_ORDER) x (n mod N), and the share of the mean square off whole orders."""
        lines = numpy.fft.rfft(signal, axis=0) / len(signal)
        waves = numpy.fft.fft(lines, axis=1) / signal.shape[1]
        weight = numpy.full(len(waves), 2.0)
        weight[0] = 1
        if len(signal) % 2 == 0:
            weight[-1] = 1
        amplitude = weight[:, None] * abs(waves)
        power = (amplitude[1:] ** 2).sum(axis=1)
        whole = power[self.revolutions - 1::self.revolutions].sum()
        total = power.sum()
        return amplitude[::self.revolutions][:HIGHEST_ORDER + 1], 0.0 if total == 0 else 1 - whole / total

    def _shift_residual(self, signal):
        """How far each sector is from its neighbour's signal a sector later, over the motion."""
        step = self.samples // signal.shape[1]
        swing = signal - signal.mean()
        neighbour = numpy.roll(numpy.roll(swing, 1, axis=1), -step, axis=0)
        return float(numpy.sqrt(((swing - neighbour) ** 2).sum() / max((swing ** 2).sum(), 1e-300)))


class Case:
    """A case's folder after `make`."""

    def __init__(self, folder):
        self.folder, self.name = folder, os.path.basename(os.path.normpath(folder))
        path = self.path("response.h5")
        if not os.path.exists(path):
            raise CannotBeMade(f"no {path}; make -C {folder}")
        self.model = Model(self.path("model.h5"))
        with h5py.File(path) as file:
            self.sectors, self.lobes = int(file.attrs["sector_count"]), int(file["casing"].attrs["lobes"])
            self.moving = file["nodal_diameters"][:]
            self.angle, self.distortion = file["casing/angle"][:], file["casing/distortion"][:]
            self.clearance = file["casing/clearance"][:]
            self.clearance_state = file["casing"].attrs["clearance_state"].decode()
            self.first_speeds = first_speeds(numpy.array([group.attrs["speed"] for group in file["speed"].values()]) * RPM)
            self.names = [name for name, group in file["speed"].items() if not group.attrs["failure"]]
            self.failed = len(file["speed"]) - len(self.names)
            self.speeds = [Speed(file["speed"][name], self.model.normal, self.sectors) for name in self.names]
        self.rpm = numpy.array([at.rpm for at in self.speeds])
        self.amplitude = numpy.array([at.amplitude for at in self.speeds])
        self.waves = numpy.array([at.waves[0] for at in self.speeds])  # [m] speeds x engine orders x (n mod N)
        self.periodic = numpy.array([at.motion == "periodic" for at in self.speeds])
        # What is counted or summed over speeds is over these: an adaptive sweep has many more where the response peaks.
        self.even = numpy.isin(self.rpm, self.first_speeds)
        self.steady = self.even & self.periodic

    def path(self, *names):
        return os.path.join(self.folder, *names)

    @functools.cached_property
    def written(self):
        """The text of its case, from the report, because the file itself may lie in another folder."""
        with open(self.path("report", "case.toml"), encoding="utf-8") as file:
            return file.read()

    @property
    def settings(self):
        """What --set changed; a report tells it in comments."""
        return re.findall(r"^# --set (.*)$", self.written, flags=re.M)

    @property
    def arguments(self):
        """The case and its settings, for a program."""
        return [self.path("report", "case.toml"), *(word for setting in self.settings for word in ("--set", setting))]

    def report(self, name):
        return read_table(self.path("report", name))

    def figure(self, name):
        """A figure's table; needs the picture too."""
        if not os.path.exists(self.path("report", "figures", name + ".svg")):
            raise CannotBeMade(f"no {self.path('report', 'figures', name + '.svg')}")
        return read_table(self.path("report", "figures", name + ".csv"))

    def attribute(self, name):
        return numpy.array([at.attributes[name] for at in self.speeds if name in at.attributes], dtype=float)

    def signals(self, index):
        """Normal motion and force of the leading edge, samples x N sectors."""
        with h5py.File(self.path("response.h5")) as file:
            group = file["speed"][self.names[index]]
            everyone = numpy.arange(self.sectors) % group["contact_force"].shape[1]
            motion = numpy.einsum("sjc,c->sj", group["displacement"][:, :, 0], self.model.normal[0])
            return motion[:, everyone], group["contact_force"][:, :, 0][:, everyone]

    @functools.cached_property
    def example(self):
        """Index of the periodic speed with the largest amplitude."""
        if not self.periodic.any():
            raise CannotBeMade(f"no speed of {self.name} is periodic")
        return int(numpy.where(self.periodic, self.amplitude, -1).argmax())

    def strongest_diameters(self, orders):
        """Engine order -> the nodal diameter that holds most of its power over the periodic speeds, and its share."""
        if not self.steady.any():
            raise CannotBeMade(f"no speed of {self.name} is periodic")
        power = (self.by_diameter()[self.steady] ** 2).sum(axis=0)
        return {k: (int(power[k].argmax()), power[k].max() / power[k].sum()) for k in orders}

    def by_diameter(self):
        """[m] both directions added: speeds x engine orders x nodal diameters 0 .. N/2."""
        half = self.sectors // 2
        parts = [self.waves[:, :, 0]]
        for n in range(1, half + 1):
            parts.append(self.waves[:, :, n] + (0 if 2 * n == self.sectors else self.waves[:, :, self.sectors - n]))
        return numpy.stack(parts, axis=2)

    def contact_map(self, edge):
        """Contrast, number of places, and shares (speeds x areas)."""
        rows = self.figure(f"contact_map_{edge}_edge")
        shares = [key for key in rows[0] if key.startswith("share at")]
        return (numpy.array([float(row["contrast [1]"]) for row in rows]),
                numpy.array([int(row["clusters"]) for row in rows]),
                numpy.array([[float(row[key]) for key in shares] for row in rows]))

    @functools.cached_property
    def critical(self):
        return self.report("critical_speeds.csv")


class Tests:
    """The project's tests in a built tree."""

    def __init__(self, build):
        self.build = build

    def run(self, *filters):
        """Runs `program filter` with gtest; returns (all passed, text)."""
        words, good = [], True
        for program, pattern in filters:
            path = os.path.join(self.build, "bin", program)
            if not os.path.exists(path):
                raise CannotBeMade(f"{path} is not built")
            done = subprocess.run([path, f"--gtest_filter={pattern}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            passed = re.search(r"\[  PASSED  \] (\d+) test", done.stdout)
            count = int(passed.group(1)) if passed else 0
            good = good and done.returncode == 0 and count > 0
            words.append(f"{pattern.replace('*', '')} of {program}: {count} passed" + ("" if done.returncode == 0 else ", some failed"))
        return good, "by test " + "; ".join(words)
