# SPDX-License-Identifier: GPL-3.0-or-later
"""response.h5 is what tools for netCDF-4 expect, and a file of the version before is still taken over.

    netcdf.py <tiprub-simulate> <folder>
"""
import os
import sys

from small_wheel import CASE, Bench, h5py, np, require

try:
    import netCDF4
    import xarray
except ImportError:
    print("SKIPPED: needs python3-netcdf4 and python3-xarray")
    sys.exit(77)

NUMBERS = ("amplitude", "change", "revolutions", "contact_work", "largest_penetration", "contact_steps", "excluded_growth", "multiplier")
UNITS = ("1", "m", "N", "N m", "J", "W", "rad", "rad/s", "Hz")
TEXTS = ("failure", "motion", "symmetry", "depth")
KEPT = ("nodal_diameters", "provenance", "casing/angle", "frequencies/speed")  # by version 4: what is new is an axis, or along one in the root
SHAPES = {"clearance": ("contact_node",), "displacement": ("angle", "sector", "contact_node", "component"),
          "contact_force": ("angle", "sector", "contact_node"), "contact_count": ("sector", "contact_node", "casing_angle")}


def variables(group, path=""):
    yield from ((f"{path}/{name}", variable) for name, variable in group.variables.items())
    for name, inside in group.groups.items():
        yield from variables(inside, f"{path}/{name}")


def named_axes(path):
    with netCDF4.Dataset(path) as file:
        every = dict(variables(file))
        for name, variable in every.items():
            variable[...]  # can be read
            named = not [axis for axis in variable.dimensions if axis.startswith("phony")]
            told = not variable.dimensions or "long_name" in variable.ncattrs()
            measured = not variable.dimensions or variable.dtype == str or variable.units in UNITS
            require(named and told and measured, f"{name} {variable.dimensions}")
    with h5py.File(path) as file:
        sets = []
        file.visititems(lambda name, item: sets.append("/" + name) if isinstance(item, h5py.Dataset) else None)
    require(sorted(sets) == sorted(every), f"none of {len(sets)} datasets is passed over")


def along_speed(path):
    with xarray.open_dataset(path) as all_speeds, h5py.File(path) as file:
        groups = list(file["speed"].values())
        at = [group.attrs["speed"] for group in groups]
        require(all_speeds.rotor_speed.values.tolist() == at, f"a coordinate of {len(at)} speeds")
        for name in NUMBERS:
            held = [float(group.attrs.get(name, np.nan)) if not group.attrs["failure"] else np.nan for group in groups]
            require(all_speeds[name].dims == ("rotor_speed",) and np.array_equal(all_speeds[name], held, equal_nan=True), f"{name}: as in the groups")
        for name in TEXTS:
            require(all_speeds[name].values.tolist() == [group.attrs[name].decode() for group in groups], f"{name}: as in the groups")
        nearest = all_speeds.amplitude.sel(rotor_speed=at[1] + 1, method="nearest").item()
        require(nearest == groups[1].attrs["amplitude"], "a speed is found by its coordinate")


def one_speed(path):
    with xarray.open_dataset(path, group="speed/00001") as speed, h5py.File(path) as file:
        group = file["speed/00001"]
        for name, axes in SHAPES.items():
            require(speed[name].dims == axes and np.array_equal(speed[name], group[name]), f"{name} over {axes}")
        samples = group.attrs["samples_per_revolution"]
        require(np.allclose(speed.angle, 2 * np.pi * np.arange(len(speed.angle)) / samples, atol=1e-12), "samples by the rotor's angle")
        areas = len(speed.casing_angle)
        require(np.allclose(speed.casing_angle, 2 * np.pi * (np.arange(areas) + 0.5) / areas), "areas by the casing's angle")
        require(speed.component.values.tolist() == ["r", "theta", "z"], "directions by name")
        force = group["contact_force"]
        require(force.chunks is not None and force.shuffle and force.compression == "gzip" and 1 <= force.compression_opts <= 4, "packed")
        require(force.id.get_storage_size() < 0.5 * force.nbytes, f"  {force.nbytes} bytes in {force.id.get_storage_size()}")


def seal(path):
    """By Fowler, Noll and Vo, 64 bits, variant 1a: simulate/response/sealed_file.cc."""
    value = 14695981039346656037
    with open(path, "rb") as file:
        for byte in file.read():
            value = (value ^ byte) * 1099511628211 % 2**64
    with open(path, "ab") as file:
        file.write(b"tiprub seal %016x" % value)


def former_version(path, other):
    """As version 4 had it: `unit`, contiguous, texts of fixed length, no axes and nothing along that of speed."""
    with h5py.File(path) as file, h5py.File(other, "w") as old:
        def copied(name, item):
            if isinstance(item, h5py.Group):
                old.require_group(name).attrs.update(item.attrs)
            elif name in KEPT or isinstance(item, h5py.Dataset) and "/" in name and "CLASS" not in item.attrs:
                old[name] = np.bytes_(item[()]) if h5py.check_string_dtype(item.dtype) else item[()]
                old[name].attrs["unit"] = np.bytes_(item.attrs.get("units", b"text"))
        file.visititems(copied)
        old.attrs.update(dict(file.attrs, schema_version=4))
    seal(other)


bench = Bench(sys.argv[1], sys.argv[2])
bench.write("case.toml", CASE.replace("speed_count = 40", "speed_count = 3").replace("amplitude = 2.0e-4", "amplitude = 1.3e-4"))
require(bench.run("-q").returncode == 0, "a sweep")
new = bench.path("response.h5")
named_axes(new)
along_speed(new)
one_speed(new)
former_version(new, bench.path("old.h5"))
whole = bench.read()
os.replace(bench.path("old.h5"), new)
again = bench.run()
require(" 0 computed now" in again.stderr, "a file of version 4 is taken over: " + again.stderr.strip())
require(bench.read() == whole, "  and becomes one of version 5, with the same bytes")
