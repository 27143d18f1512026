# SPDX-License-Identifier: GPL-3.0-or-later
"""fields.h5."""
import h5py
import numpy

from corpus_hdf5 import Stage, attribute, edit, replaced, with_value, without, without_attribute

FIELDS = Stage("postprocess", "fields.h5", ("--fields", "fields.h5"))
SETS = ("clamped", "contact", "cyclic_low", "cyclic_high")


def exchanged(one, other):
    def change(file):
        file.move(one, "held")
        file.move(other, one)
        file.move("held", other)
    return edit(change)


def of_itself(file):
    """A virtual dataset that maps to itself."""
    name = "node_set/cyclic_high"
    count = file[name].shape
    del file[name]
    layout = h5py.VirtualLayout(count, "i4")
    layout[:] = h5py.VirtualSource(".", name, count)
    file.create_virtual_dataset(name, layout)


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
    for name in ("clamped", "contact_line", "cyclic_low", "cyclic_high"):
        yield FIELDS.entry(f"{name}.one_node", replaced(f"node_set/{name}", lambda values: 0 * values), f"/node_set/{name} lists node 0 twice")
    yield FIELDS.entry("contact.one_node", replaced("node_set/contact", lambda values: 0 * values), "contact node 0 is elsewhere than the model's")
    yield FIELDS.entry("cyclic_high.reversed", replaced("node_set/cyclic_high", lambda values: values[::-1]), "both list partners in the same order")
    yield FIELDS.entry("cyclic_high.exchanged", exchanged("node_set/cyclic_low", "node_set/cyclic_high"), "both list partners in the same order")
    yield FIELDS.entry("cyclic_high.of_itself", edit(of_itself), "has its numbers in other datasets or files")
    yield FIELDS.entry("disc.one_cell", replaced("part/disc", lambda values: 0 * values), '/part: part "disc" lists cell 0 (from 0) twice')
    yield FIELDS.entry("disc.empty", replaced("part/disc", lambda values: values[:0]), '/part: part "disc" has no cell of the sector')
    yield FIELDS.entry("disc.exchanged", exchanged("part/disc", "part/main_blade"), '/part: part "main_blade" does not hold ')
    yield FIELDS.entry("main_blade.is_disc", edit(lambda file: file["part/main_blade"].write_direct(file["part/disc"][()])),
                       '/part: 8 of the 8 cells of part "main_blade" are also in part "disc"')
    yield FIELDS.entry("disc.cell_beyond", replaced("part/disc", with_value(16)), "/part/disc names 16, of 0 .. 15")


def of_basis():
    for number in (0, 1, 3):
        name = f"nodal_diameter/{number}/basis"
        yield FIELDS.entry(f"basis_{number}.absent", without(name), f"/{name}: is missing")
        yield FIELDS.entry(f"basis_{number}.other_nodes", replaced(name, lambda values: values[:, 1:]), f"/{name} must have the axes model dof, node, component")
        yield FIELDS.entry(f"basis_{number}.one_dof_less", replaced(name, lambda values: values[1:]), f"dofs at nodal diameter {number}, the model has ", 2)
        yield FIELDS.entry(f"basis_{number}.in_mm", replaced(name, lambda values: values * values.dtype.type(1000)), "moves the contact nodes by up to ", 2)
        yield FIELDS.entry(f"basis_{number}.matrix", replaced(name, lambda values: values[:, :, 0]), f"/{name} must have the axes")


def of_attributes():
    for name in ("sector_count", "young_modulus", "poisson_ratio", "density"):
        yield from FIELDS.of_attribute(name)
    yield FIELDS.entry("twice_as_stiff", lambda path: h5py.File(path, "r+").attrs.modify("young_modulus", 2e11), "its sector is not the one that was written")
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
