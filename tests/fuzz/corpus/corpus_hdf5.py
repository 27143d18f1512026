# SPDX-License-Identifier: GPL-3.0-or-later
"""Changes of HDF5 files by name, and what every reader of them must say."""
import h5py
import numpy

from corpus import Entry


def edit(change):
    """A change of an open file as one of its path; the response's seal, which follows HDF5's end, goes with it."""
    def changed(path):
        with h5py.File(path, "r+") as file:
            if "digest" in file.attrs:
                del file.attrs["digest"]
            change(file)
    return changed


def replaced(name, make):
    """The dataset made again from its values, with its attributes."""
    def change(file):
        values, attributes = file[name][()], dict(file[name].attrs)
        del file[name]
        file[name] = make(values)
        file[name].attrs.update(attributes)
    return edit(change)


def attribute(name, value, of="/"):
    def change(file):
        file[of].attrs[name] = value
    return edit(change)


def without_attribute(name, of="/"):
    def change(file):
        del file[of].attrs[name]
    return edit(change)


def without(name):
    def change(file):
        del file[name]
    return edit(change)


def group_in_place(name):
    def change(file):
        del file[name]
        file.create_group(name)
    return edit(change)


def hollow(name):
    """A shape of terabytes, of which nothing was written."""
    def change(file):
        shape = (1 << 20,) * max(file[name].ndim, 2)
        del file[name]
        file.create_dataset(name, shape=shape, chunks=(1,) * len(shape), dtype="f8")
    return edit(change)


def with_value(value):
    def make(values):
        values = values.copy()
        values.flat[-1] = value
        return values
    return make


def bytes_of(change):
    def changed(path):
        with open(path, "rb") as file:
            data = file.read()
        with open(path, "wb") as file:
            file.write(change(data))
    return changed


class Stage:
    """Entries of one file."""
    def __init__(self, program, file, options=()):
        self.program, self.file, self.options = program, file, options

    def entry(self, name, change, phrase, code=2):
        return Entry(name, self.program, self.file, change, code, phrase, self.options)

    def of_dataset(self, name, axes, optional=False):
        """What is wrong with numbers of any shape."""
        path, said = name.strip("/").replace("/", "."), f"/{name}: "
        if not optional:
            yield self.entry(f"{path}.absent", without(name), said + "is missing")
        yield self.entry(f"{path}.group", group_in_place(name), said)
        yield self.entry(f"{path}.text", replaced(name, lambda values: "text"), said)
        yield self.entry(f"{path}.nan", replaced(name, with_value(numpy.nan)), "is not finite")
        yield self.entry(f"{path}.infinite", replaced(name, with_value(numpy.inf)), "is not finite")
        yield self.entry(f"{path}.hollow", hollow(name), said)
        if axes > 1:
            yield self.entry(f"{path}.flat", replaced(name, numpy.ravel), said + "has shape ")

    def of_file(self, schema):
        """What is wrong with a file of any schema."""
        yield self.entry("empty", bytes_of(lambda data: b""), "is not an HDF5 file, or is damaged")
        yield self.entry("text", bytes_of(lambda data: b"no HDF5"), "is not an HDF5 file, or is damaged")
        yield self.entry("half", bytes_of(lambda data: data[:len(data) // 2]), "damaged")
        yield self.entry("no_schema", without_attribute("schema"), f"has no schema; expected {schema} version ")
        yield self.entry("other_schema", attribute("schema", b"other"), f"is other version ")
        yield self.entry("other_version", attribute("schema_version", 99), f"is {schema} version 99, expected {schema} version ")
        yield self.entry("schema_of_two_lines", attribute("schema", b"a\nb"), "is a\\nb version ")
        yield self.entry("schema_is_a_number", attribute("schema", 1), "has no text attribute schema")

    def of_attribute(self, name, of="/"):
        path = f"{of.strip('/').replace('/', '.')}@{name}"
        yield self.entry(f"{path}.absent", without_attribute(name, of), f"attribute {name}")
        yield self.entry(f"{path}.text", attribute(name, b"many", of), f"attribute {name}")
        yield self.entry(f"{path}.list", attribute(name, numpy.ones(1000), of), f"attribute {name}")
        yield self.entry(f"{path}.nan", attribute(name, numpy.nan, of), f"attribute {name} is not finite")
