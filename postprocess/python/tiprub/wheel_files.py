# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of files in which other programs read a moving wheel: CalculiX's .frd, and NASTRAN's bulk data and punch files.

`place` [m] and `moved` [m] are sector x node x (x, y, z), `cells` those of fields.h5, `at` the speed [rpm]. Each sector has its own
nodes on the cuts; nodes and cells are numbered from 1, sector by sector.
"""
import numpy as np

#: Nodes of a cell -> the node of VTK at each place, in the order that both formats have: the edges along a brick or a wedge before
#: those of its top; of 27 nodes, the first 20.
_HEX20 = [*range(12), *range(16, 20), *range(12, 16)]
_ORDER = {10: list(range(10)), 13: list(range(13)), 15: [*range(9), *range(12, 15), *range(9, 12)], 20: _HEX20, 27: _HEX20}
_FRD_TYPE = {10: 6, 15: 5, 20: 4, 27: 4}
_NASTRAN_CARD = {10: "CTETRA", 13: "CPYRAM", 15: "CPENTA", 20: "CHEXA", 27: "CHEXA"}


def _of_all_sectors(cells, place):
    """(number, count of nodes in VTK, nodes in the order of the formats) of each cell."""
    number = 0
    for first in 1 + place.shape[1] * np.arange(len(place)):
        for cell in cells:
            cell, number = cell[cell >= 0], number + 1
            yield number, len(cell), first + cell[_ORDER[len(cell)]]


def _frd_cells(cells, place):
    for number, count, nodes in _of_all_sectors(cells, place):
        if count not in _FRD_TYPE:
            raise ValueError("a .frd file has no pyramids; write_nastran and fields/contact_wheel.vtu of the report hold them")
        yield f" -1{number:10d}{_FRD_TYPE[count]:5d}{0:5d}{1:5d}\n"
        yield from (f" -2{''.join(f'{node:10d}' for node in nodes[k:k + 10])}\n" for k in range(0, len(nodes), 10))


def _frd_nodes(values):
    return (f" -1{number:10d}{x:12.5E}{y:12.5E}{z:12.5E}\n" for number, (x, y, z) in enumerate(values.reshape(-1, 3), 1))


def frd(place, moved, cells, at):
    """A .frd file with the block DISP."""
    count = place.shape[0] * place.shape[1]
    yield f"    1C\n    2C{'':18}{count:12d}{1:38d}\n"
    yield from _frd_nodes(place)
    yield f" -3\n    3C{'':18}{len(place) * len(cells):12d}{1:38d}\n"
    yield from _frd_cells(cells, place)
    yield f" -3\n  100CL  101{at:12.5E}{count:12d}{'':20}{0:2d}{1:5d}{1:12d}\n -4  DISP        4    1\n"
    yield from (f" -5  D{k}          1    2{k:5d}    0\n" for k in (1, 2, 3))
    yield " -5  ALL         1    2    0    0    1ALL\n"
    yield from _frd_nodes(moved)
    yield " -3\n 9999\n"


def bulk_data(place, moved, cells, at):
    """Nodes and cells as bulk data. Material and properties are not in it: property 1 is for you to define."""
    yield f"$ {len(place)} sectors of a wheel at {at:.6g} rpm, in m; the displacements are in the punch file (.pch)\nBEGIN BULK\n"
    for number, (x, y, z) in enumerate(place.reshape(-1, 3), 1):
        yield f"GRID*   {number:16d}{'':16}{x:16.9E}{y:16.9E}\n*       {z:16.9E}\n"
    for number, count, nodes in _of_all_sectors(cells, place):
        fields = [f"{_NASTRAN_CARD[count]:8}", *(f"{value:8d}" for value in (number, 1, *nodes))]
        rows = ["".join(fields[:9]), *("+       " + "".join(fields[k:k + 8]) for k in range(9, len(fields), 8))]
        yield "+\n".join(rows) + "\n"
    yield "ENDDATA\n"


def punch(place, moved, cells, at):
    """Displacements of the nodes of bulk_data, without rotations."""
    heads = (f"$TITLE   = VIBRATION OF A WHEEL AT {at:.6g} RPM", "$SUBTITLE= WITHOUT THE STATIC SHIFT", "$LABEL   = METRES", "$DISPLACEMENTS",
             "$REAL OUTPUT", f"$SUBCASE ID = {1:11d}")
    line = len(heads)
    yield from (f"{head:72}{number:8d}\n" for number, head in enumerate(heads, 1))
    for number, (x, y, z) in enumerate(moved.reshape(-1, 3), 1):
        yield f"{number:10d}{'G':>8}{x:18.6E}{y:18.6E}{z:18.6E}{line + 1:8d}\n-CONT-{'':12}{0:18.6E}{0:18.6E}{0:18.6E}{line + 2:8d}\n"
        line += 2
