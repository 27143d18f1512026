#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Who may include whom: rooms stand on file headers, storeys on what is beneath them, and nothing stands on itself.

usage: includes.py ROOT

Reads every #include of the five rooms, follows it to the end, and prints each fault with its chain of includes.
"""
import os
import re
import sys

import source_tree

# From the ground up; "" is the room's own folder, where its main.cc is.
STOREYS = {
    "cases": ["program"],
    "mesh": ["cells", "curves", "blades", "wheels", "sector", "import", ""],
    "reduce": ["model", "sector", "matrices", "operators", "basis", ""],
    "simulate": ["motion", "scene", "response", "march", "orbits", "periodic", "speed", "branches", "sweep", ""],
    "postprocess": ["tables", "waves", "analysis", "fields", "records", "figures", "compare", "explore", "report", ""],
}
# What a room shows of itself to the rooms above it: its file, and nothing of how that is made.
FILE_HEADERS = {"cases": ("cases/program/",), "mesh": ("mesh/cells/",), "reduce": ("reduce/model/",),
                "simulate": ("simulate/response/", "simulate/motion/")}
STANDS_ON = {"cases": [], "mesh": ["cases"], "reduce": ["cases", "mesh"], "simulate": ["cases", "reduce"],
             "postprocess": ["cases", "mesh", "reduce", "simulate"]}
# A header of a file that is split over several .cc: its own folder's .cc files alone may include it.
PRIVATE = {"reduce/model/hdf5_handle.h"}
# What no file header brings to who includes it.
HEAVY = re.compile(r"deal\.II/|gmsh|mpi\.h|H5|hdf5|Epetra|Anasazi|Teuchos|NOX|LOCA")
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)', re.M)


def includes_of(root):
    """file -> (files of the project that it includes, headers of libraries)."""
    paths = [path for path in source_tree.files(root, source_tree.ROOMS) if path.endswith((".h", ".cc"))]
    found = {}
    for path in paths:
        own, library = set(), set()
        for quoted, bracketed in INCLUDE.findall(source_tree.read(root, path)):
            if quoted and os.path.exists(os.path.join(root, quoted)):
                own.add(quoted)
            else:
                library.add(quoted or bracketed)
        found[path] = (sorted(own), sorted(library))
    return found


def place(path):
    """Room and storey of a file."""
    parts = path.split("/")
    return parts[0], parts[1] if len(parts) > 2 else ""


def unknown_places(includes):
    for path in includes:
        room, storey = place(path)
        if storey not in STOREYS[room]:
            yield f"{path}: lies in no known storey of {room}: {', '.join(name or room + '/' for name in STOREYS[room])}"


def steps_upwards(includes):
    """Each include for itself: within a room not upwards, across rooms file headers only."""
    for path, (own, _) in includes.items():
        room, storey = place(path)
        for other in own:
            other_room, other_storey = place(other)
            if other in PRIVATE and (path.endswith(".h") or os.path.dirname(path) != os.path.dirname(other)):
                yield f"{path}: includes another folder's private header: {path} -> {other}"
            elif other_room == room:
                order = STOREYS[room]
                if {storey, other_storey} <= set(order) and order.index(other_storey) > order.index(storey):
                    yield f"{path}: includes upwards: {path} -> {other}"
            elif other_room not in STANDS_ON[room] or not other.startswith(FILE_HEADERS[other_room]):
                yield f"{path}: includes what is no file header of a room beneath {room}: {path} -> {other}"


def closure(start, includes):
    """What a file brings along -> the chain of includes that brings it."""
    chains, waiting = {start: [start]}, [start]
    while waiting:
        path = waiting.pop(0)
        own, library = includes.get(path, ((), ()))
        for other in [*own, *(f"<{name}>" for name in library)]:
            if other not in chains:
                chains[other] = chains[path] + [other]
                waiting.append(other)
    return chains


def file_headers_that_reach_too_far(includes):
    for path in includes:
        room, storey = place(path)
        if not path.endswith(".h") or path in PRIVATE or f"{room}/{storey}/" not in FILE_HEADERS.get(room, ()):
            continue
        allowed = tuple(header for name in [room, *STANDS_ON[room]] for header in FILE_HEADERS[name])
        for reached, chain in closure(path, includes).items():
            far = HEAVY.match(reached[1:]) if reached[0] == "<" else not reached.startswith(allowed)
            if far:
                yield f"{path}: a file header reaches {reached}: {' -> '.join(chain)}"


def circles(includes):
    """Among units: a header and its .cc are one."""
    units = {}
    for path, (own, _) in includes.items():
        unit = path if path in PRIVATE else os.path.splitext(path)[0]
        own = set(own) - PRIVATE
        units.setdefault(unit, set()).update(os.path.splitext(other)[0] for other in own)
    reached_by_itself = {}
    for unit in units:
        chains = closure(unit, {name: (sorted(others - {name}), ()) for name, others in units.items()})
        back = [chain for name, chain in chains.items() if name != unit and unit in units.get(name, ())]
        if back:
            reached_by_itself[unit] = min(back, key=len) + [unit]
    seen = set()
    for chain in sorted(reached_by_itself.values(), key=len):
        if not seen & set(chain):
            yield f"{chain[0]}: a circle of includes: {' -> '.join(chain)}"
        seen |= set(chain)


def circles_of_folders(includes):
    """Folders at any depth: what lies in an inner folder stands beneath the outer one, or on it, but not both."""
    stands_on = {}
    for path, (own, _) in includes.items():
        folders = {os.path.dirname(other) for other in own} - {os.path.dirname(path)}
        stands_on.setdefault(os.path.dirname(path), set()).update(folders)
    for folder in sorted(stands_on):
        for other in sorted(stands_on[folder]):
            if folder < other and folder in stands_on.get(other, ()):
                yield f"folders include each other: {folder} -> {other} -> {folder}"


def main(root):
    includes = includes_of(root)
    faults = [*unknown_places(includes), *steps_upwards(includes), *file_headers_that_reach_too_far(includes),
              *circles(includes), *circles_of_folders(includes)]
    source_tree.report(faults, f"the includes of {len(includes)} files hold to their storeys")


if __name__ == "__main__":
    main(sys.argv[1])
