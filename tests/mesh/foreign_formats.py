# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh in msh 2.2 as other codes write it: CalculiX or Abaqus, Nastran, Ansys, I-deas, gmsh in millimetres."""
import random
import re

# gmsh's types of solids: nodes in VTK's order, which is CalculiX's.
SOLIDS = {11: (0, 1, 2, 3, 4, 5, 6, 7, 9, 8), 19: (0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12),
          18: (0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11),
          17: (0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15)}


class Mesh:
    """nodes: number -> (x, y, z) [mm], about `axis`; cells: (number, nodes); sets: name -> nodes."""

    def __init__(self, path, axis):
        with open(path, encoding="ascii") as file:
            self.text = file.read()
        lines = iter(self.text.splitlines())
        self.nodes, self.cells, self.sets, names = {}, [], {}, {}
        for line in lines:
            if line == "$PhysicalNames":
                for _ in range(int(next(lines))):
                    _, tag, name = next(lines).split()
                    names[tag] = name.strip('"')
            if line == "$Nodes":
                for _ in range(int(next(lines))):
                    tag, *place = next(lines).split()
                    x, y, z = (1e3 * float(value) for value in place)
                    self.nodes[int(tag)] = {"x": (z, x, y), "y": (y, z, x), "z": (x, y, z)}[axis]
            if line == "$Elements":
                for _ in range(int(next(lines))):
                    number, kind, count, group, *rest = next(lines).split()
                    nodes = [*map(int, rest[int(count) - 1:])]
                    if int(kind) in SOLIDS:
                        self.cells.append((int(number), [nodes[k] for k in SOLIDS[int(kind)]]))
                    else:
                        members = self.sets.setdefault(names[group], [])
                        members.extend(node for node in nodes if node not in members)
        random.Random(1).shuffle(self.sets["contact"])


def rows(values, width):
    return [values[k:k + width] for k in range(0, len(values), width)]


def inp(mesh):
    yield "** made by a test\n*HEADING\na sector\n*Node, nset=all"
    for number, place in mesh.nodes.items():
        yield f"{number}, " + ", ".join(map(repr, place))
    for count in sorted({len(nodes) for _, nodes in mesh.cells}):
        yield f"*ELEMENT, type=C3D{count}{'R' if count == 20 else ''}, ELSET=solid"
        for number, nodes in mesh.cells:
            if len(nodes) == count:
                yield ",\n".join(", ".join(map(str, row)) for row in rows([number, *nodes], 12))
    for name, members in mesh.sets.items():
        yield f"*NSET, NSET={name}"
        for row in rows(members, 10):
            yield ", ".join(map(str, row)) + ","
    yield "*MATERIAL, NAME=metal\n*ELASTIC\n1e11, 0.3"


def large(number):
    return f"{number:16.9E}"


def bdf(mesh):
    yield "SOL 103\nCEND\nSET 7 = " + ",\n".join(", ".join(map(str, row)) for row in rows(sorted(mesh.sets["contact"]), 8))
    yield "BEGIN BULK\n$ made by a test"
    for number, (x, y, z) in mesh.nodes.items():
        yield f"{'GRID*':8}{number:16}{0:16}{large(x)}{large(y)}\n{'*':8}{large(z)}"
    names = {10: "CTETRA", 13: "CPYRAM", 15: "CPENTA", 20: "CHEXA"}
    for number, nodes in mesh.cells:
        if len(nodes) == 20:
            nodes = nodes[:12] + nodes[16:] + nodes[12:16]
        if len(nodes) == 15:
            nodes = nodes[:9] + nodes[12:] + nodes[9:12]
        fields = [f"{names[len(nodes)]:8}", f"{number:8}", f"{3:8}", *(f"{node:8}" for node in nodes)]
        yield "\n".join("".join(row) for row in [fields[:9], *(["+       ", *row] for row in rows(fields[9:], 8))])
    for row in rows(sorted(mesh.sets["clamped"]), 5):
        yield ",".join(["SPC1", "1", "123", *map(str, row)])
    yield "ENDDATA"


def cdb(mesh):
    yield "/PREP7\nET,1,186\nET,2,SOLID187"
    yield f"NBLOCK,6,SOLID,{max(mesh.nodes)},{len(mesh.nodes)}\n(3i9,6e21.13e3)"
    for number, place in mesh.nodes.items():
        yield f"{number:9}{0:9}{0:9}" + "".join(f"{value:21.13E}" for value in place)
    yield f"N,R5.3,LOC,       -1,\nEBLOCK,19,SOLID,{len(mesh.cells)},{len(mesh.cells)}\n(19i9)"
    for number, nodes in mesh.cells:
        count, kind = len(nodes), 1
        if count == 10:
            kind = 2
        elif count == 13:
            i, j, k, l, m, q, r, s, t, y, z, a, b = nodes
            nodes = [i, j, k, l, m, m, m, m, q, r, s, t, m, m, m, m, y, z, a, b]
        elif count == 15:
            i, j, k, m, n, o, q, r, t, u, v, x, y, z, a = nodes
            nodes = [i, j, k, k, m, n, o, o, q, r, k, t, u, v, o, x, y, z, a, a]
        head = [1, kind, 1, 1, 0, 0, 0, 0, len(nodes), 0, number]
        yield "\n".join("".join(f"{value:9}" for value in row) for row in (head + nodes[:8], nodes[8:]))
    yield f"{-1:9}"
    for name, members in mesh.sets.items():
        numbers = []
        for node in sorted(members):
            if numbers and abs(numbers[-1]) + 1 == node:
                numbers[-1:] = [-node] if numbers[-1] < 0 else [numbers[-1], -node]
            else:
                numbers.append(node)
        yield f"CMBLOCK,{name.upper()},NODE,{len(numbers):8}  ! users node component definition\n(8i10)"
        yield "\n".join("".join(f"{value:10}" for value in row) for row in rows(numbers, 8))
    yield "FINISH"


def unv(mesh):
    yield f"{-1:6}\n{2411:6}"
    for number, place in mesh.nodes.items():
        yield f"{number:10}{1:10}{1:10}{11:10}\n" + "".join(f"{value:25.16E}".replace("E", "D") for value in place)
    yield f"{-1:6}\n{-1:6}\n{2412:6}"
    order = {10: (118, (0, 4, 1, 5, 2, 6, 7, 8, 9, 3)), 15: (113, (0, 6, 1, 7, 2, 8, 12, 13, 14, 3, 9, 4, 10, 5, 11)),
             20: (116, (0, 8, 1, 9, 2, 10, 3, 11, 16, 17, 18, 19, 4, 12, 5, 13, 6, 14, 7, 15))}
    for number, nodes in mesh.cells:
        kind, places = order[len(nodes)]
        yield f"{number:10}{kind:10}{1:10}{1:10}{7:10}{len(nodes):10}"
        yield "\n".join("".join(f"{nodes[place]:10}" for place in row) for row in rows(places, 8))
    yield f"{-1:6}\n{-1:6}\n{2467:6}"
    for group, (name, members) in enumerate(mesh.sets.items()):
        yield f"{group + 1:10}" + f"{0:10}" * 6 + f"{len(members):10}\n{name}"
        yield "\n".join("".join(f"{7:10}{node:10}{0:10}{0:10}" for node in row) for row in rows(members, 2))
    yield f"{-1:6}"


def msh(mesh):
    """The file itself, with other places."""
    head, tail = re.fullmatch(r"(?s)(.*\$Nodes\n\d+\n).*?(\$EndNodes.*)\n", mesh.text).groups()
    yield head + "\n".join(f"{number} {x!r} {y!r} {z!r}" for number, (x, y, z) in mesh.nodes.items())
    yield tail


WRITERS = {"inp": inp, "bdf": bdf, "cdb": cdb, "unv": unv, "msh": msh}


def write(source, kind, axis, path):
    """Writes the mesh of a file in msh 2.2 in another format [mm], about another axis."""
    with open(path, "w", encoding="ascii") as file:
        file.writelines(line + "\n" for line in WRITERS[kind](Mesh(source, axis)))
