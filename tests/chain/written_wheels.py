# SPDX-License-Identifier: GPL-3.0-or-later
"""The whole wheel in the files of other programs, as the Python package writes it of a small disc (see python_package.py)."""
import itertools
import os
import re
import shutil
import subprocess

import h5py
import numpy as np


def message_of(call, kind=ValueError):
    """What an error of this kind says."""
    try:
        call()
    except kind as error:
        return str(error)
    raise AssertionError("nothing is refused")


def frd(path):
    """(nodes, lines of the cells, displacement) of a .frd file, by its columns."""
    with open(path, encoding="ascii") as file:
        blocks = file.read().split(" -3\n")

    def rows(block):
        return np.array([[float(line[k:k + 12]) for k in (13, 25, 37)] for line in block.splitlines() if line.startswith(" -1")])

    return rows(blocks[0]), [line.rstrip() for line in blocks[1].splitlines()[1:]], rows(blocks[2])


def wheel_for_calculix(tiprub, programs):
    """The whole wheel as .frd: as the report has it for ParaView, whole across the cuts, and with CalculiX's order of nodes."""
    from vtu import numbers_of, read_vtu
    picture = os.path.join("report", "fields", "contact_wheel.vtu")
    speed, vtu = numbers_of(picture)["speed"] * 30 / np.pi, read_vtu(picture)
    response = tiprub.open_response("response.h5")
    response.write_frd("wheel.frd", speed)
    nodes, cells, moved = frd("wheel.frd")
    assert np.allclose(nodes, vtu["Points"], rtol=1e-5, atol=1e-6)
    assert np.allclose(moved, vtu["displacement_vibration"], rtol=1e-4, atol=1e-4 * np.abs(moved).max())
    with h5py.File("fields.h5") as file:
        low, high, count = file["node_set/cyclic_low"][:], file["node_set/cyclic_high"][:], len(file["cells"])
    by_sector = moved.reshape(response.sector_count, -1, 3)
    assert np.allclose(by_sector[:, high], np.roll(by_sector, -1, axis=0)[:, low], atol=1e-4 * np.abs(moved).max())
    assert sum(line.startswith(" -1") for line in cells) == count * response.sector_count
    if shutil.which("ccx") is None:
        print("SKIPPED: no ccx, whose order of nodes is compared")
        return
    subprocess.run([os.path.join(programs, "tiprub-reduce"), "-q", "case.toml", "sector.msh", "--export-ccx", "decks", "--set", "reduce.verification_speeds=[0.0]"], check=True)
    with open("decks/mesh.inp", encoding="ascii") as deck, open("decks/free.inp", "w", encoding="ascii") as free:
        free.write(re.sub(r"(?s)\*NSET, NSET=(clamped|low).*?(?=\*MATERIAL)", "", deck.read()).replace("*BOUNDARY\nclamped, 1, 3\n", "") +
                   "*BOUNDARY\n1, 1, 3\n*STEP\n*STATIC\n*NODE FILE\nU\n*END STEP\n")
    subprocess.run(["ccx", "free"], cwd="decks", stdout=subprocess.DEVNULL, env=dict(os.environ, OMP_NUM_THREADS="1"), check=True)
    assert cells[:3 * count] == frd("decks/free.frd")[1]


def fields_of(line, widths):
    """Of a line with columns of these widths."""
    ends = list(itertools.accumulate(widths))
    return [line[end - width:end] for end, width in zip(ends, widths)]


def read_by_gmsh(nodes, cards):
    """wheel.bdf, with bricks of 20 nodes."""
    if shutil.which("gmsh") is None:
        print("SKIPPED: no gmsh, which reads the bulk data")
        return
    said = subprocess.run(["gmsh", "wheel.bdf", "-o", "wheel_again.msh", "-format", "msh22", "-save_all", "-save"], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=True).stdout
    with open("wheel_again.msh", encoding="ascii") as file:
        again = file.read().split("$Elements\n")
    points = np.array([line.split()[1:] for line in again[0].split("$Nodes\n")[1].splitlines()[1:-1]], dtype=float)
    bricks = [[int(word) for word in line.split()] for line in again[1].splitlines()[1:-1]]
    assert np.allclose(points, nodes, rtol=1e-5, atol=1e-6), said
    assert len(bricks) == len(cards) and all(brick[1] == 17 for brick in bricks), said
    edges = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7), (5, 6), (6, 7)]  # in gmsh's order
    for brick, card in zip(bricks, cards):
        corners, middles = points[np.array(brick[-20:-12]) - 1], points[np.array(brick[-12:]) - 1]
        ends = np.array([(corners[a], corners[b]) for a, b in edges])
        assert brick[-20:-12] == card[:8] and sorted(brick[-20:]) == sorted(card), said
        assert np.all(np.linalg.norm(middles - ends.mean(1), axis=1) < 0.2 * np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)), said


def wheel_for_nastran(tiprub):
    """Bulk data and a punch file, by their columns, beside the .frd file; and as gmsh reads the bulk data."""
    response = tiprub.open_response("response.h5")
    speed = response.sweep.rpm.values[-1]
    response.write_frd("wheel.frd", speed)
    response.write_nastran("wheel.bdf", speed)
    nodes, cells, moved = frd("wheel.frd")
    with open("wheel.bdf", encoding="ascii") as file:
        lines = [line.rstrip("\n") for line in file]
    assert lines[1] == "BEGIN BULK" and lines[-1] == "ENDDATA" and max(map(len, lines[1:])) == 73, lines[:3]
    grids = [fields_of(first, [8, 16, 16, 16, 16]) + fields_of(second, [8, 16]) for first, second in zip(lines, lines[1:]) if first.startswith("GRID*")]
    assert [int(grid[1]) for grid in grids] == list(range(1, len(nodes) + 1))
    assert np.allclose([[float(grid[k]) for k in (3, 4, 6)] for grid in grids], nodes, rtol=1e-5, atol=1e-6)
    text = "\n".join(line for line in lines if line[0] in "C+").replace("+\n+       ", "")
    written = [[int(card[k:k + 8]) for k in range(24, len(card), 8)] for card in text.splitlines()]
    theirs = " ".join(line[3:] for line in cells).split()  # a cell of 20 nodes: its number, type, group, material, and nodes
    assert [node for card in written for node in card] == [int(theirs[k]) for k in range(len(theirs)) if k % 24 > 3], text[:200]
    with open("wheel.pch", encoding="ascii") as file:
        rows = [line for line in file if line[0] != "$"]
    widths = [10, 8, 18, 18, 18, 8]
    points = [fields_of(line, widths) for line in rows[::2]]
    assert np.allclose([[float(value) for value in point[2:5]] for point in points], moved, rtol=1e-5, atol=1e-6 * np.abs(moved).max())
    assert all(point[1].strip() == "G" and int(point[0]) == k for k, point in enumerate(points, 1))
    assert all(line.startswith("-CONT-") and len(line) == 81 for line in rows[1::2])
    assert "must end in .bdf" in message_of(lambda: response.write_nastran("wheel.dat", speed))
    read_by_gmsh(nodes, written)


def wheel_of_pyramids(tiprub):
    """A .frd file has none; what is refused leaves the old file."""
    shutil.copy("fields.h5", "pyramids.h5")
    with h5py.File("pyramids.h5", "r+") as file:
        file["cells"][:, 13:] = -1
    response = tiprub.open_response("response.h5")
    speed = response.sweep.rpm.values[-1]
    with open("wheel.frd", encoding="ascii") as file:
        before = file.read()
    assert "has no pyramids" in message_of(lambda: response.write_frd("wheel.frd", speed, "pyramids.h5"))
    with open("wheel.frd", encoding="ascii") as file:
        assert file.read() == before
    response.write_nastran("pyramids.bdf", speed, "pyramids.h5")
    with open("pyramids.bdf", encoding="ascii") as file:
        assert file.read().count("CPYRAM") == before.split(" -3\n")[1].count("\n -1")
