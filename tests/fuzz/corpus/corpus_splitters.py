# SPDX-License-Identifier: GPL-3.0-or-later
"""sector.msh and model.h5 of a wheel with contact on its splitters."""
import re

import numpy

from corpus_hdf5 import Stage, replaced
from corpus_mesh import entry

MODEL = Stage("simulate", "model.h5")
BLADE = "contact/blade"
MUST_BE = "/contact/blade must hold, for each of the 4 contact nodes, 0 for those of the main blade, which come first, and 1 for the splitter's"


def of_lines():
    yield entry("contact_splitter.surface", lambda text: re.sub(r'1 12 "contact_splitter"\n(?s:(.*))"splitter_tip"', r'1 12 "line"\n\1"contact_splitter"', text),
                "\"contact_splitter\" names neither a curve nor points")
    yield entry("contact_splitter.short", lambda text: text, "[reduce] contact_nodes = 6 asks for more segments than the 21 nodes of the splitter's tip can tell apart",
                ("--set", "reduce.contact_nodes=6"))
    yield entry("splitter_tip.absent", lambda text: text.replace('"splitter_tip"', '"tip"'),
                "has no surface group \"splitter_tip\" with the faces of the splitter's tip", ("--set", "reduce.contact=\"segments\""))


def of_blade():
    yield from MODEL.of_dataset(BLADE, 1, optional=True)
    for name, make in {"one_less": lambda values: values[:-1], "one_more": lambda values: numpy.append(values, 1.0), "splitter_first": lambda values: values[::-1],
                       "mixed": lambda values: numpy.array([0.0, 1.0, 0.0, 1.0]), "third_blade": lambda values: 2 * values,
                       "splitter_only": lambda values: 0 * values + 1}.items():
        yield MODEL.entry(f"blade.{name}", replaced(BLADE, make), MUST_BE)
    yield MODEL.entry("blade.matrix", replaced(BLADE, lambda values: values[:, None]), "/contact/blade: has shape 4 x 1, must have one axis")
    yield MODEL.entry("blade.all_main", replaced(BLADE, lambda values: 0 * values), "/contact/arc_length must increase from the leading edge")


ENTRIES = [*of_lines(), *of_blade()]
