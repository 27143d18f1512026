# SPDX-License-Identifier: GPL-3.0-or-later
"""sector.msh; more of it is in tests/reduce/bad_meshes.cmake."""
import re

from corpus import Entry
from corpus_case import edit

GROUPS = {"sector": "has no volume group", "cyclic_low": "has no surface group", "cyclic_high": "has no surface group",
          "clamped": "has no surface group", "contact": "has no curve or points named"}


def entry(name, change, phrase, options=()):
    return Entry(name, "reduce", "sector.msh", edit(change), 2, phrase, options)


def without_section(name):
    return lambda text: re.sub(rf"(?s)\${name}\n.*?\$End{name}\n", "", text)


def node(number, change):
    """Node 1 to 149 of the file, by its place in it."""
    def changed(text):
        places = re.findall(r"(?m)^-?\d\.\d+(?:e-\d+)? -?\d\.\d+(?:e-\d+)? -?\d\.\d+(?:e-\d+)?$", text)
        place = places[number]
        return text.replace(place, change(*map(float, place.split())), 1)
    return changed


def of_sections():
    unread, unnamed = "gmsh can't read it: ", "has no volume group \"sector\" with cells; name it in the mesher"
    reasons = {"PhysicalNames": "it is cut off or damaged", "Entities": "Could not read entities", "Nodes": "Could not read nodes",
               "Elements": "Could not read elements"}
    for name, reason in reasons.items():
        begin, end = f"${name}\n", f"$End{name}\n"
        yield entry(f"{name}.absent", without_section(name), "Unknown node 131 in element 37" if name == "Nodes" else unnamed)
        yield entry(f"{name}.begins_nowhere", lambda text, begin=begin: text.replace(begin, ""), unnamed)
        if name != "Elements":  # the last section: all of it has been read
            yield entry(f"{name}.ends_nowhere", lambda text, end=end: text.replace(end, ""), unnamed)
        yield entry(f"{name}.cut_off", lambda text, end=end: text[:text.index(end) - 20], unread + reason)
        yield entry(f"{name}.words", lambda text, begin=begin: text.replace(begin, begin + "many words\n"), unread + reason)
        yield entry(f"{name}.negative", lambda text, name=name: re.sub(rf"(\${name}\n)\d+", r"\1-5", text),
                    unnamed if name == "PhysicalNames" else unread + reason)
        yield entry(f"{name}.huge", lambda text, name=name: re.sub(rf"(\${name}\n)\d+", r"\g<1>2000000000", text), unread + reason)


def of_format():
    yield entry("empty", lambda text: "", "is no mesh in gmsh's format: its first line must be $MeshFormat")
    yield entry("blank_line_first", lambda text: "\n" + text, "is no mesh in gmsh's format")
    yield entry("only_the_first_line", lambda text: "$MeshFormat\n", "gmsh can't read it: it is cut off or damaged")
    yield entry("stl", lambda text: "solid sector\nendsolid\n", "is no mesh in gmsh's format")
    yield entry("format_99", lambda text: text.replace("4.1 0 8", "99 0 8"), "gmsh can't read it: Unknown MSH file version 99")
    yield entry("format_binary", lambda text: text.replace("4.1 0 8", "4.1 1 8"), "has no volume group \"sector\" with cells")
    yield entry("format_of_4_bytes", lambda text: text.replace("4.1 0 8", "4.1 1 4"), "gmsh can't read it: Binary file has sizeof(size_t) = 4")
    yield entry("format_word", lambda text: text.replace("4.1 0 8", "four"), "gmsh can't read it: it is cut off or damaged")


def of_groups():
    for name, phrase in GROUPS.items():
        yield entry(f"{name}.unnamed", lambda text, name=name: re.sub(rf'\n\d \d+ "{name}"', "", text).replace("\n9\n", "\n8\n", 1), phrase)
        yield entry(f"{name}.capital", lambda text, name=name: text.replace(f'"{name}"', f'"{name.upper()}"'), phrase)
        yield entry(f"{name}.blank", lambda text, name=name: text.replace(f'"{name}"', f'"{name} "'), phrase)


def of_parts():
    """Symptom: a disc that held the blade's cells passed three stages, and killed the fourth."""
    def exchanged(text):
        return text.replace('"disc"', '"held"').replace('"main_blade"', '"disc"').replace('"held"', '"main_blade"')
    yield entry("parts.exchanged", exchanged, 'part "main_blade" does not hold 5 of the 5 nodes of its tip line: are two parts exchanged?')
    yield entry("parts.overlap", lambda text: re.sub(r"(?m) 2 1 3 0 *$", " 3 1 2 3 0 ", text), '8 of the 8 cells of part "main_blade" are also in part "disc"')


def of_faces():
    """Symptom: a stray mid-side node of a clamped face was held, and the first frequency was 84 % off."""
    yield entry("faces.stray_node", lambda text: re.sub(r"(?m)^(\d+(?: \d+){7}) \d+ $", r"\1 1 ", text), " belong to no cell in common; write the mesh again")


def of_nodes():
    yield entry("node.nan", node(3, lambda x, y, z: f"{x} nan {z}"), "node 4 stands at no finite place; write the mesh again")
    yield entry("node.infinite", node(3, lambda x, y, z: f"{x} inf {z}"), "node 4 stands at no finite place; write the mesh again")
    yield entry("node.huge", node(3, lambda x, y, z: f"1e300 {y} {z}"), "a wheel of radius ")
    yield entry("node.word", node(3, lambda x, y, z: f"{x} here {z}"), "gmsh can't read it: Could not read nodes")


ENTRIES = [*of_format(), *of_sections(), *of_groups(), *of_parts(), *of_faces(), *of_nodes()]
