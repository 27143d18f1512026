# SPDX-License-Identifier: GPL-3.0-or-later
"""fields.h5."""
import numpy

from corpus_hdf5 import Stage, attribute, replaced, with_value, without, without_attribute

FIELDS = Stage("postprocess", "fields.h5", ("--fields", "fields.h5"))
SETS = ("clamped", "contact", "cyclic_low", "cyclic_high")


def of_tables():
    for name in ("nodes", "static/displacement_1", "static/displacement_2", "static/displacement_3"):
        yield FIELDS.entry(f"{name.replace('/', '.')}.two_columns", replaced(name, lambda values: values[:, :2]), f"/{name} must have three columns")
    for name in ("displacement_1", "displacement_2", "displacement_3"):
        yield FIELDS.entry(f"{name}.one_row_less", replaced(f"static/{name}", lambda values: values[1:]), "must have a row for each node")
    yield FIELDS.entry("displacement_3.absent", without("static/displacement_3"), "/static must hold displacement_1, _2, and _3, _4, ... without a gap")
    yield FIELDS.entry("nodes.one_less", replaced("nodes", lambda values: values[1:]), "names node 234, of 0 .. 233")
    yield FIELDS.entry("cells.columns", replaced("cells", lambda values: values[:, :8]), "/cells must have 10, 13, 15, 20 or 27 columns")
    yield FIELDS.entry("cells.node_beyond", replaced("cells", with_value(100000)), "/cells names node 100000, of 0 .. 234")
    yield FIELDS.entry("cells.too_few", replaced("cells", with_value(-1)), "/cells has a cell of 26 nodes; it must have 10, 13, 15, 20 or 27")
    yield FIELDS.entry("cells.fraction", replaced("cells", lambda values: values + 0.5), "/cells: has a value that is not a whole number")
    yield FIELDS.entry("cells.text", replaced("cells", lambda values: "text"), "/cells: is not real numbers")


def of_sets():
    for name in SETS:
        yield FIELDS.entry(f"{name}.absent", without(f"node_set/{name}"), f"/node_set/{name} is missing")
        yield FIELDS.entry(f"{name}.node_beyond", replaced(f"node_set/{name}", with_value(235)), f"/node_set/{name} names 235, of 0 .. 234")
        yield FIELDS.entry(f"{name}.table", replaced(f"node_set/{name}", lambda values: values[None]), f"/node_set/{name} must have one axis")
    yield FIELDS.entry("cyclic_low.one_less", replaced("node_set/cyclic_low", lambda values: values[1:]), "/node_set/cyclic_high must pair with cyclic_low")
    yield FIELDS.entry("disc.cell_beyond", replaced("part/disc", with_value(16)), "/part/disc names 16, of 0 .. 15")


def of_basis():
    for number in (0, 1, 3):
        name = f"nodal_diameter/{number}/basis"
        yield FIELDS.entry(f"basis_{number}.absent", without(name), f"/{name}: is missing")
        yield FIELDS.entry(f"basis_{number}.other_nodes", replaced(name, lambda values: values[:, 1:]), f"/{name} must have the axes model dof, node, component")
        yield FIELDS.entry(f"basis_{number}.one_dof_less", replaced(name, lambda values: values[1:]), f"dofs at nodal diameter {number}, the model has ", 2)
        yield FIELDS.entry(f"basis_{number}.matrix", replaced(name, lambda values: values[:, :, 0]), f"/{name} must have the axes")


def of_attributes():
    for name in ("sector_count", "young_modulus", "poisson_ratio", "density"):
        yield from FIELDS.of_attribute(name)
    yield FIELDS.entry("no_digest", without_attribute("model_digest"), "has no text attribute model_digest")
    yield FIELDS.entry("of_another_model", attribute("model_digest", b"0123456789abcdef"), "was written with another model of the same size", 2)
    yield FIELDS.entry("poisson_half", attribute("poisson_ratio", 0.5), "poisson_ratio")
    yield FIELDS.entry("poisson_two", attribute("poisson_ratio", 2.0), "poisson_ratio")
    yield FIELDS.entry("young_zero", attribute("young_modulus", 0.0), "young_modulus")
    yield FIELDS.entry("density_negative", attribute("density", -1.0), "density")
    yield FIELDS.entry("no_sector", attribute("sector_count", 0), "has 0 sectors, the model has 6; give the fields that were written with the model", 2)
    yield FIELDS.entry("most_sectors", attribute("sector_count", 2000000000), "is missing")
    yield FIELDS.entry("flat_cells", replaced("nodes", lambda values: numpy.zeros_like(values)), "contact node 0 is elsewhere than the model's", 2)


ENTRIES = [*FIELDS.of_file("tiprub-fields"), *FIELDS.of_dataset("nodes", 2), *FIELDS.of_dataset("static/displacement_1", 2), *of_tables(), *of_sets(),
           *of_basis(), *of_attributes()]
