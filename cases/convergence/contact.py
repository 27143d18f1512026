#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Contact at points beside contact by segments, over the mesh.

usage: contact.py PROGRAMS_FOLDER CASES_FOLDER CASE [MESH ...]

Meshes the wheel of a case finer and finer, by the same factor along the chord, the span and through the main blade, and
reduces each with both kinds of contact. Writes contact_CASE.tsv, a line a mesh and kind: how far the first and the last contact
unknown give way along the casing's normal to a force on themselves alone, on one blade of a wheel at rest; and where the first
family meets two engine orders, the tallest peak of each edge's normal motion, as an adaptive sweep locates it.
"""
import os
import sys

import h5py
import numpy

from convergence import Bench, sector_dofs, written

KEYS = ["elements_along_chord", "elements_along_bore", "elements_along_span", "elements_through_blade",
        "elements_through_splitter", "elements_through_disc", "elements_between_blades"]
MESHES = {"8": (8, 3, 4, 2, 2, 2, 2), "12": (12, 5, 6, 3, 2, 3, 2), "16": (16, 6, 8, 4, 2, 4, 2), "24": (24, 10, 12, 6, 3, 5, 4),
          "32": (32, 13, 16, 8, 3, 6, 4), "40": (40, 16, 20, 10, 4, 8, 4)}  # by elements along the chord
ENGINE_ORDERS = [8, 6]
WINDOW = 0.97, 1.13  # of the linear crossing: contact stiffens the blade
EDGES = {"leading": 0, "trailing": -1}


def complex_matrix(dataset):
    values = dataset[:]
    return values["r"] + 1j * values["i"] if values.dtype.names else values


def compliances(model):
    """[m/N] of the first and the last contact unknown: a force on one blade is that of all nodal diameters."""
    normal, sectors = model["contact/normal"][:], int(model.attrs["sector_count"])
    found = []
    for edge in EDGES.values():
        at = 3 * (edge % len(normal))
        total = 0.0
        for n in range(sectors // 2 + 1):
            K = complex_matrix(model[f"nodal_diameter/{n}/K0"])
            force = numpy.zeros(len(K))
            force[at:at + 3] = normal[edge]
            total += (1 if n in (0, sectors / 2) else 2) * (force @ numpy.linalg.solve(K, force)).real / sectors
        found.append(total)
    return found


def crossing_rpm(model, order):
    """Where the first family of its nodal diameter meets an engine order."""
    sectors = int(model.attrs["sector_count"])
    n = min(order % sectors, -order % sectors)
    matrices = {name: complex_matrix(dataset) for name, dataset in model[f"nodal_diameter/{n}"].items()}
    half = numpy.linalg.inv(numpy.linalg.cholesky(matrices.pop("M")))
    low, high = 0.0, float(model.attrs["speed_max"])
    for _ in range(40):
        speed = 0.5 * (low + high)
        K = sum(speed ** (2 * int(name[1:])) * term for name, term in matrices.items())
        square = numpy.linalg.eigvalsh(half @ K @ half.conj().T)[0]
        low, high = (speed, high) if square > (order * speed) ** 2 else (low, speed)
    return low * 30 / numpy.pi


def tallest(response, normal):
    """Of each edge: rpm and amplitude [mm] of its normal motion where that is largest."""
    rows = []
    for group in response["speed"].values():
        if not len(group.get("displacement", ())):
            continue
        along = numpy.einsum("tjkc,kc->tjk", group["displacement"][:], normal)
        amplitude = 0.5e3 * (along.max(0) - along.min(0)).max(0)
        rows.append((group.attrs["speed"] * 30 / numpy.pi, *(amplitude[edge] for edge in EDGES.values())))
    for edge in range(len(EDGES)):
        top = max(rows, key=lambda row: row[1 + edge])
        yield from (top[0], top[1 + edge])


def peaks(bench, name, model):
    """For each engine order what tallest() tells."""
    with h5py.File(model) as file:
        crossings, normal = [crossing_rpm(file, order) for order in ENGINE_ORDERS], file["contact/normal"][:]
    for order, crossing in zip(ENGINE_ORDERS, crossings):
        response = os.path.join(bench.folder, f"{name}_{order}_response.h5")
        low, high = (round(share * crossing, -1) for share in WINDOW)
        bench.run("tiprub-simulate", [model], response, "simulate",
                  {"speed_min_rpm": low, "speed_max_rpm": high, "speed_count": 9, "speeds": '"adaptive"', "examine": '"none"'})
        with h5py.File(response) as file:
            yield from tallest(file, normal)


def main(programs, cases, case, names):
    bench = Bench(os.path.abspath(programs), os.path.abspath(cases), f"contact_runs_{case}", case)
    columns = [f"compliance, {edge} edge [nm/N]" for edge in EDGES]
    for order in ENGINE_ORDERS:
        columns += [f"EO {order}, {edge} edge [{unit}]" for edge in EDGES for unit in ("rpm", "mm")]
    with written(f"contact_{case}.tsv") as file:
        file.write("\t".join(["contact", "elements along the chord", "dofs a sector", *columns]) + "\n")
        for name in names or MESHES:
            sector = bench.mesh(name, dict(zip(KEYS, MESHES[name])))
            for kind in ("points", "segments"):
                model = bench.model(f"{name}_{kind}", sector, {"contact": f'"{kind}"', "verification_speeds": [0.0]})
                with h5py.File(model) as opened:
                    values = [1e9 * value for value in compliances(opened)]
                values += peaks(bench, f"{name}_{kind}", model)
                file.write("\t".join([kind, name, str(sector_dofs(sector)), *(f"{value:.6g}" for value in values)]) + "\n")
                file.flush()


if __name__ == "__main__":
    main(*sys.argv[1:4], sys.argv[4:])
