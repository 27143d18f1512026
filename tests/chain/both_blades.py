#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact on splitters: a wheel whose splitters equal its main blades is a wheel of twice as many sectors without.

usage: both_blades.py PROGRAMS_FOLDER TESTS_FOLDER SMALL_CASE WORK_FOLDER

Two sectors of a wheel of 12 are put together to one of 6, whose second blade is the splitter. Both are reduced: their
frequencies, static compliance at the contact nodes and shift under spin must be the same. Then the model of 12 is
written in the coordinates of 6: both are marched, and must move alike. Imported from CalculiX's deck, the wheel of 6
has the same contact nodes.
"""
import os
import re
import shutil
import subprocess
import sys

import h5py
import numpy as np

SECTORS = 12
TURN = 2 * np.pi / SECTORS
FACES, VOLUMES, LINES = (16,), (17,), (1,)
SETTINGS = ["--set", "mesh.blade_count=12", "--set", "mesh.elements_along_chord=3", "--set", "reduce.contact_nodes=3",
            "--set", "reduce.modes_at_speed=0"]
# A sector of two blades has twice the modes.
TWICE = ["--set", "reduce.fixed_interface_modes=12", "--set", "reduce.verification_modes=4"]
# Settled far below the limit of the comparison: the models judge by other blades, and may stop a revolution apart.
MARCH = ["--set", "simulate.step_tolerance=0.02", "--set", "simulate.settle_tolerance=1e-9", "--set", "simulate.max_revolutions=200"]


class Mesh:
    """msh 2.2: places by node, and for each group its elements (type, nodes)."""

    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            lines = iter(file.read().splitlines())
        self.places, self.groups, names = {}, {}, {}
        for line in lines:
            if line == "$PhysicalNames":
                for _ in range(int(next(lines))):
                    dimension, tag, name = next(lines).split()
                    names[int(dimension), tag] = name.strip('"')
            if line == "$Nodes":
                for _ in range(int(next(lines))):
                    tag, *place = next(lines).split()
                    self.places[int(tag)] = np.array([*map(float, place)])
            if line == "$Elements":
                for _ in range(int(next(lines))):
                    _, kind, count, group, *rest = next(lines).split()
                    dimension = 3 if int(kind) in VOLUMES else 2 if int(kind) in FACES else 1
                    nodes = [*map(int, rest[int(count) - 1:])]
                    self.groups.setdefault(names[dimension, group], []).append((int(kind), nodes))

    def nodes(self, group):
        return sorted({node for _, nodes in self.groups[group] for node in nodes})

    def write(self, path):
        names = [*self.groups]
        elements = [(kind, k + 1, nodes) for k, name in enumerate(names) for kind, nodes in self.groups[name]]
        dimension = {name: 3 if kind in VOLUMES else 2 if kind in FACES else 1
                     for name in names for kind, _ in self.groups[name]}
        with open(path, "w", encoding="ascii") as file:
            print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames", len(names), sep="\n", file=file)
            for k, name in enumerate(names):
                print(dimension[name], k + 1, f'"{name}"', file=file)
            print("$EndPhysicalNames\n$Nodes", len(self.places), sep="\n", file=file)
            for node, place in self.places.items():
                print(node, *map(repr, map(float, place)), file=file)
            print("$EndNodes\n$Elements", len(elements), sep="\n", file=file)
            for number, (kind, group, nodes) in enumerate(elements):
                print(number + 1, kind, 2, group, group, *nodes, file=file)
            print("$EndElements", file=file)


def doubled(mesh):
    """Two sectors as one; the second one's blade is the splitter."""
    c, s = np.cos(TURN), np.sin(TURN)
    turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
    first = max(mesh.places)
    number = {node: node + first for node in mesh.places}
    high = mesh.nodes("cyclic_high")
    there = np.array([mesh.places[node] for node in high])
    for node in mesh.nodes("cyclic_low"):
        distance = np.linalg.norm(there - turn @ mesh.places[node], axis=1)
        assert distance.min() < 1e-12
        number[node] = high[distance.argmin()]
    for node, place in [*mesh.places.items()]:
        mesh.places.setdefault(number[node], turn @ place)
    second = {name: [(kind, [number[node] for node in nodes]) for kind, nodes in elements]
              for name, elements in mesh.groups.items()}
    for name in ("sector", "clamped"):
        mesh.groups[name] += second[name]
    mesh.groups = {name: mesh.groups[name] for name in ("sector", "cyclic_low", "clamped", "blade_tip", "contact")}
    mesh.groups |= {"cyclic_high": second["cyclic_high"], "splitter_tip": second["blade_tip"],
                    "contact_splitter": second["contact"]}
    return mesh


def matrix(file, n, name):
    found = file[f"nodal_diameter/{n}/{name}"][:]
    return found["r"] + 1j * found["i"] if found.dtype.names else found.astype(complex)


def compliance(path, blades):
    """[m/N] static, of all contact dofs of the wheel, blade by blade as they follow each other."""
    with h5py.File(path) as file:
        sectors, dofs = int(file.attrs["sector_count"]), 3 * len(file["contact/arc_length"])
        total = np.zeros((sectors, dofs, sectors, dofs))
        for n in range(sectors // 2 + 1):
            K = matrix(file, n, "K0")
            rest = K[dofs:, dofs:]
            flexible = np.linalg.inv(K[:dofs, :dofs] - K[:dofs, dofs:] @ np.linalg.solve(rest, K[dofs:, :dofs]))
            share = (1 if n in (0, sectors / 2) else 2) / sectors
            for j in range(sectors):
                for k in range(sectors):
                    total[j, :, k] += share * (flexible * np.exp(2j * np.pi * n * (j - k) / sectors)).real
        return total.reshape(sectors * dofs, sectors * dofs), dofs // blades


def folded(path, made):
    """Waves n' = n and 6 - n (conjugated) of 12 sectors, as one wave n of 6 with two blades each: with u and v their
    amplitudes, the main blade moves by u + v, the splitter by e^{i n alpha'} (u - v), alpha' = 2 pi / 12."""
    half = SECTORS // 2
    shutil.copy(path, made)
    with h5py.File(path) as old, h5py.File(made, "r+") as new:
        del new.attrs["digest"], new["nodal_diameter"], new["verification"], new["mesh_error"], new["contact"]
        new.attrs["sector_count"] = half
        position = old["contact/position"][:]
        nodes, dofs = len(position), 3 * len(position)
        new["contact/position"] = np.vstack([position, position + [0, TURN, 0]])
        new["contact/blade"] = np.repeat([0, 1], nodes)
        for name in ("normal", "arc_length", "static_shift_1", "static_shift_2"):
            new["contact/" + name] = np.concatenate([old["contact/" + name][:]] * 2)
        for n in range(half // 2 + 1):
            for name in ("K0", "K1", "K2", "M"):
                if n == SECTORS / 4:  # u = x + i y of one travelling wave: the main blade moves by x, the splitter by -y
                    A = matrix(old, n, name)
                    both = np.block([[A.real, -A.imag], [A.imag, A.real]])
                    size = len(A)
                    order = [*range(dofs), *range(size, size + dofs), *range(dofs, size), *range(size + dofs, 2 * size)]
                    change = np.eye(2 * size)[:, order]
                    change[size:size + dofs] *= -1
                    value = change.T @ both @ change
                else:
                    A, B = matrix(old, n, name), matrix(old, half - n, name).conj()
                    size, other = len(A), len(B)
                    both = np.block([[2 * A, np.zeros((size, other))], [np.zeros((other, size)), 2 * B]])
                    change = np.zeros((size + other, size + other), complex)
                    turn, one = np.exp(-1j * n * TURN), np.eye(dofs)
                    change[:dofs, :2 * dofs] = np.hstack([one, turn * one]) / 2
                    change[size:size + dofs, :2 * dofs] = np.hstack([one, -turn * one]) / 2
                    change[dofs:size, 2 * dofs:dofs + size] = np.eye(size - dofs)
                    change[size + dofs:, dofs + size:] = np.eye(other - dofs)
                    value = change.conj().T @ both @ change
                value = (value + value.conj().T) / 2
                new[f"nodal_diameter/{n}/{name}"] = value.real if n in (0, half / 2) else value


def motion(path, blades):
    """Per speed: displacement and force, samples x blades of the wheel x nodes x ..., and the amplitude."""
    found = []
    with h5py.File(path) as file:
        sectors, held = int(file.attrs["sector_count"]), int(file.attrs["independent_sectors"])
        for name in sorted(file["speed"]):
            speed = file["speed/" + name]
            assert not speed.attrs["failure"], speed.attrs["failure"]
            all_sectors = np.arange(sectors) % held
            u, f = speed["displacement"][:][:, all_sectors], speed["contact_force"][:][:, all_sectors]
            nodes = u.shape[2] // blades
            found.append((u.reshape(len(u), sectors * blades, nodes, 3), f.reshape(len(f), sectors * blades, nodes),
                          float(speed.attrs["amplitude"])))
    return found


def difference(one, other):
    return np.abs(one - other).max() / np.abs(one).max()


def compare_models(one, two):
    with h5py.File(one) as twelve, h5py.File(two) as six:
        assert list(six["contact/blade"][:]) == [0, 0, 0, 1, 1, 1]
        for n in range(SECTORS // 4 + 1):
            waves = [twelve[f"verification/nodal_diameter/{k}/unreduced"][:] for k in (n, SECTORS // 2 - n)]
            expected = np.sort(np.hstack(waves), axis=1)
            got = six[f"verification/nodal_diameter/{n}/unreduced"][:]
            count = min(waves[0].shape[1], got.shape[1])
            print(f"ND {n}: frequencies differ by", difference(expected[:, :count], got[:, :count]))
            assert difference(expected[:, :count], got[:, :count]) < 1e-6
        for name in ("arc_length", "normal", "static_shift_1"):
            both = np.concatenate([twelve["contact/" + name][:]] * 2)
            assert difference(both, six["contact/" + name][:]) < 1e-8, name
        turned = six["contact/position"][3:, 1] - six["contact/position"][:3, 1]
        assert np.abs(turned - TURN).max() < 1e-12, turned
    expected, _ = compliance(one, 1)
    got, _ = compliance(two, 2)
    print("static compliance differs by", difference(expected, got))
    assert difference(expected, got) < 1e-8


def compare_motions(one, two, limit):
    for (u, f, amplitude), (v, g, other) in zip(motion(one, 1), motion(two, 2), strict=True):
        worst = max(difference(u, v), difference(f, g), abs(amplitude / other - 1))
        print(f"amplitude {amplitude:.6g} m, touched by {np.count_nonzero(f.any(axis=(0, 2)))} blades; differ by {worst}")
        assert f.any(), "nothing touches"
        assert worst < limit


IMPORT = """
[mesh]
mesh_file = "wheel.inp"
length_unit = "mm"
clamped = "clamped"
contact = "contact"
contact_splitter = "contact_splitter"
"""


def main(programs, tests, case, work):
    sys.path.insert(0, os.path.join(tests, "mesh"))
    import foreign_formats
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    os.chdir(work)

    def run(program, *arguments):
        subprocess.run([os.path.join(programs, program), *arguments], check=True)

    for kind in ("points", "segments"):
        settings = [*SETTINGS, "--set", f'reduce.contact="{kind}"']
        run("tiprub-mesh", "-q", case, "-o", "12.msh", *SETTINGS)
        run("convert_sector", "12.msh", "2.2", "text", "12_22.msh")
        doubled(Mesh("12_22.msh")).write("6.msh")
        run("tiprub-reduce", "-q", case, "12.msh", "-o", "12.h5", *settings)
        run("tiprub-reduce", "-q", case, "6.msh", "-o", "6.h5", "--fields", "6_fields.h5", *settings, *TWICE)
        compare_models("12.h5", "6.h5")
        folded("12.h5", "folded.h5")
        for name in ("12", "folded", "6"):
            run("tiprub-simulate", "-q", case, name + ".h5", "-o", name + "_response.h5", *MARCH)
        compare_motions("12_response.h5", "folded_response.h5", 1e-8)
        compare_motions("12_response.h5", "6_response.h5", 0.02)  # two bases of as many modes
        run("tiprub-postprocess", "-q", case, "6.h5", "6_response.h5", "--fields", "6_fields.h5", "-o", "report")
        with open("report/report.html", encoding="utf-8") as page:
            assert "on a main blade and its splitter" in page.read()
    foreign_formats.write("6.msh", "inp", "z", "wheel.inp")
    with open(case, encoding="utf-8") as given, open("case.toml", "w", encoding="utf-8") as made:
        made.write(re.sub(r"(?s)\[mesh\].*?(?=\n\[)", "", given.read()) + IMPORT)
    run("tiprub-mesh", "case.toml", "-o", "imported.msh")
    run("tiprub-reduce", "-q", "case.toml", "imported.msh", "-o", "imported.h5", *SETTINGS[4:])
    run("tiprub-reduce", "-q", "case.toml", "6.msh", "-o", "6.h5", *SETTINGS[4:])
    with h5py.File("imported.h5") as imported, h5py.File("6.h5") as own:
        for name in ("position", "blade", "arc_length"):
            assert np.allclose(imported["contact/" + name], own["contact/" + name], rtol=0, atol=1e-9), name


if __name__ == "__main__":
    main(*map(os.path.abspath, sys.argv[1:]))
