# SPDX-License-Identifier: GPL-3.0-or-later
"""response.h5, with the report beside it. The format is described in simulate/format.md, the report in postprocess/report.md."""
import json
import os

import h5py
import numpy as np

from . import wheel_files
from .models import Model, text_of
from .units import rad_per_s, rpm


def _data_array(dataset):
    """An xarray.DataArray with the names, the values and the units of the dataset's axes."""
    import xarray
    axes = [axis.keys()[0] if len(axis) else dataset.name.rsplit("/", 1)[1] for axis in dataset.dims]
    scales = {name: _values(axis[0]) for name, axis in zip(axes, dataset.dims) if len(axis)}
    attributes = {name: text_of(dataset.attrs[name]) for name in ("units", "long_name") if name in dataset.attrs}
    return xarray.DataArray(_values(dataset), scales, axes, attrs=attributes)


def _values(dataset):
    return np.array([text_of(value) for value in dataset[:]], dtype=object) if h5py.check_string_dtype(dataset.dtype) else dataset[:]


def _existing(path, advice):
    if not os.path.exists(path):
        raise FileNotFoundError(f"{path}: there is no such file; {advice}")
    return path


def _write(path, lines):
    """Makes all lines before the file, so that what is refused leaves the old file."""
    text = "".join(lines)
    with open(path, "w", encoding="ascii") as file:
        file.write(text)


class Response:
    """A response of tiprub-simulate. The numbers of all speeds stand in `sweep`, and `at` gives the motion at one speed.

    `report` is the folder that tiprub-postprocess wrote of it, by default `report` beside the file.

    >>> response = open_response("response.h5")
    >>> response.sector_count, response.independent_sectors
    (6, 3)
    >>> response.sweep.amplitude.sizes["rotor_speed"]
    4
    """

    def __init__(self, path, report=None):
        self.path = os.fspath(path)
        self.report = os.fspath(report or os.path.join(os.path.dirname(self.path), "report"))
        self.file = h5py.File(self.path)
        schema, version = (text_of(self.file.attrs.get(name, "none")) for name in ("schema", "schema_version"))
        if schema != "tiprub-response" or version < 5:
            raise ValueError(f"{self.path}: has the schema {schema!r}, version {version}; a response of tiprub-simulate has 'tiprub-response', 5")

    @property
    def sector_count(self):
        """Number N of the sectors of the wheel."""
        return int(self.file.attrs["sector_count"])

    @property
    def independent_sectors(self):
        """Number N_s of the sectors in the file; sector j moves like sector j mod N_s."""
        return int(self.file.attrs["independent_sectors"])

    @property
    def sweep(self):
        """xarray.Dataset of one number or text for each speed, with `rotor_speed` [rad/s] and `rpm` as coordinates.

        >>> sweep = open_response("response.h5").sweep
        >>> sweep.amplitude.units, [round(float(speed)) for speed in sweep.rpm]
        ('m', [20000, 24000, 27000, 30000])
        """
        import xarray
        along_speed = {name: _data_array(dataset) for name, dataset in self.file.items()
                       if isinstance(dataset, h5py.Dataset) and dataset.ndim == 1 and len(dataset.dims[0])
                       and dataset.dims[0].keys() == ["rotor_speed"]}
        attributes = {name: text_of(value) for name, value in self.file.attrs.items()}
        sweep = xarray.Dataset(along_speed, attrs=attributes)
        return sweep.assign_coords(rpm=rpm(sweep.rotor_speed))

    def at(self, speed):
        """xarray.Dataset of the motion at the simulated speed nearest to `speed` [rpm]; its attributes are those of the file.

        `displacement` [m] has the axes angle x sector x contact_node x component (r, theta, z in the rotor frame),
        `contact_force` [N] angle x sector x contact_node. The groups `snapshot` and `cycle` become variables
        `snapshot_<n>` and `cycle_<n>`: complex waves of the model's dofs on nodal diameter n.

        >>> motion = open_response("response.h5").at(27000)
        >>> round(rpm(motion.speed)), motion.motion, motion.displacement.dims
        (27000, 'periodic', ('angle', 'sector', 'contact_node', 'component'))
        """
        import xarray
        group = self._group(speed)
        parts = {"": group, **{name + "_": group[name] for name in ("snapshot", "cycle") if name in group}}
        found = {prefix + name: item for prefix, part in parts.items() for name, item in part.items() if isinstance(item, h5py.Dataset)}
        scales = {axis.keys()[0] for item in found.values() for axis in item.dims if len(axis)}
        attributes = {name: text_of(value) for name, value in group.attrs.items()}
        return xarray.Dataset({name: _data_array(item) for name, item in found.items() if name not in scales}, attrs=attributes)

    def _group(self, speed):
        groups = [group for group in self.file["speed"].values() if not group.attrs["failure"]]
        if not groups:
            raise ValueError(f"{self.path}: holds no motion; the texts of sweep.failure say why")
        return min(groups, key=lambda group: abs(group.attrs["speed"] - rad_per_s(speed)))

    def whole_wheel(self, data):
        """`data` along all N sectors: displacement or contact_force of `at`, which hold the independent sectors alone.

        >>> response = open_response("response.h5")
        >>> response.whole_wheel(response.at(27000).contact_force).sizes["sector"]
        6
        """
        sectors = np.arange(self.sector_count)
        return data.isel(sector=sectors % self.independent_sectors).assign_coords(sector=sectors)

    def _beside(self, name, advice):
        return _existing(os.path.join(os.path.dirname(self.path), name), advice)

    def normal_motion(self, speed, model="model.h5"):
        """[m] displacement towards the casing, angle x sector x contact_node, at the speed nearest to `speed` [rpm].

        `model` is a Model or its file; a relative name counts from the folder of the response.

        >>> motion = open_response("response.h5").normal_motion(27000)
        >>> (motion.max("angle") - motion.min("angle")).max().item() / 2 == open_response("response.h5").at(27000).amplitude
        True
        """
        import xarray
        if not isinstance(model, Model):
            model = Model.read(self._beside(model, "name the model of the response by model="))
        normal = xarray.DataArray(model.normal, dims=("contact_node", "component"))
        motion = (self.at(speed).displacement * normal).sum("component")
        return motion.assign_attrs(units="m", long_name="displacement towards the casing")

    def field(self, speed, fields="fields.h5"):
        """xarray.Dataset of the whole wheel at the instant of the snapshot, at the speed nearest to `speed` [rpm].

        `displacement` [m] has the axes sector x node x component (r, theta, z of each node's own place), without the
        static shift; `position` [m] has sector x node x (x, y, z) in the rotor frame. `fields` counts as in
        normal_motion.
        """
        import xarray
        turns = 2 * np.pi * np.arange(self.sector_count) / self.sector_count
        advice = "write it by tiprub-reduce --fields with the model, or name it by fields=; a model from matrices has none"
        with h5py.File(self._beside(fields, advice)) as file:
            x, y, z = file["nodes"][:].T
            displacement = 0.0
            for n, waves in self._group(speed)["snapshot"].items():
                shape = np.tensordot(waves[:, 0], file[f"nodal_diameter/{n}/basis"][:], 1)
                displacement += np.real(np.exp(1j * int(n) * turns)[:, None, None] * shape)
        cos, sin = np.cos(turns)[:, None], np.sin(turns)[:, None]
        position = np.stack([cos * x - sin * y, sin * x + cos * y, 0 * cos + z], -1)
        return xarray.Dataset({"displacement": (("sector", "node", "component"), displacement, {"units": "m"}),
                               "position": (("sector", "node", "axis"), position, {"units": "m"})},
                              {"component": ["r", "theta", "z"], "axis": ["x", "y", "z"]})

    def _wheel_for_others(self, speed, fields):
        """(position, displacement, cells) of `field`, the first two sector x node x (x, y, z), and the speed [rpm] of the motion."""
        wheel = self.field(speed, fields)
        place, (along_r, along_theta, along_z) = wheel.position.values, np.moveaxis(wheel.displacement.values, -1, 0)
        angle = np.arctan2(place[..., 1], place[..., 0])
        moved = np.stack([along_r * np.cos(angle) - along_theta * np.sin(angle),
                          along_r * np.sin(angle) + along_theta * np.cos(angle), along_z], -1)
        with h5py.File(self._beside(fields, "name the fields of the model by fields=")) as file:
            cells = file["cells"][:]
        return (place, moved, cells), rpm(float(self._group(speed).attrs["speed"]))

    def write_frd(self, path, speed, fields="fields.h5"):
        """Writes `field` as a result file of CalculiX (.frd), which cgx and PrePoMax open and cgx turns into files for others.

        It holds the nodes [m] and the quadratic cells of all sectors, each with its own nodes on the cuts, and DISP [m] along x,
        y, z. Coordinates and displacements have six digits.
        """
        wheel, at = self._wheel_for_others(speed, fields)
        _write(path, wheel_files.frd(*wheel, at))

    def write_nastran(self, path, speed, fields="fields.h5"):
        """Writes `field` for programs that read NASTRAN's files: the mesh as bulk data to `path`, which ends in .bdf, and the
        displacements as a punch file beside it (.pch).

        The wheel is that of write_frd, with nine and seven digits. Abaqus translates the bulk data with `abaqus fromnastran`.
        """
        root, ending = os.path.splitext(os.fspath(path))
        if ending != ".bdf":
            raise ValueError(f"{path}: must end in .bdf; the displacements are written to a file beside it that ends in .pch")
        wheel, at = self._wheel_for_others(speed, fields)
        _write(path, wheel_files.bulk_data(*wheel, at))
        _write(root + ".pch", wheel_files.punch(*wheel, at))

    @property
    def frequencies(self):
        """Nodal diameter -> xarray.DataArray [Hz] of natural frequencies, speed x mode; modes count from 1.

        >>> frequencies = open_response("response.h5").frequencies
        >>> list(frequencies), frequencies[0].dims
        ([0, 1, 2, 3], ('rpm', 'mode'))
        """
        found = {}
        for n, dataset in sorted(self.file["frequencies/nodal_diameter"].items(), key=lambda item: int(item[0])):
            data = _data_array(dataset)
            data = data.assign_coords({data.dims[0]: rpm(data[data.dims[0]]), data.dims[1]: data[data.dims[1]] + 1})
            found[int(n)] = data.rename({data.dims[0]: "rpm", data.dims[1]: "mode"})
        return found

    @property
    def summary(self):
        """summary.json of the report: texts and lists of rows."""
        with open(self.report_file("summary.json"), encoding="utf-8") as file:
            return json.load(file)

    def report_file(self, *names):
        """Path of a file of the report, such as report_file("figures", "response.csv")."""
        return _existing(os.path.join(self.report, *names),
                         "write the report by tiprub-postprocess, or name its folder by open_response(..., report=FOLDER)")

    def table(self, name):
        """pandas.DataFrame of a table of summary.json: "speeds", "exactness", "scene_needs", "error_budget", ...

        A table without rows is an empty DataFrame. "comparison" and "reports" are there if the report compares others.
        """
        import pandas
        tables = {key: rows for key, rows in self.summary.items() if isinstance(rows, list) and all(isinstance(row, dict) for row in rows)}
        if name not in tables:
            raise ValueError(f"{self.report}: has no table {name!r}; it has {', '.join(tables)}")
        return pandas.DataFrame(tables[name])

    @property
    def critical_speeds(self):
        """pandas.DataFrame with a row for each critical speed; the names of the columns give the units.

        >>> open_response("response.h5").critical_speeds[["speed [rpm]", "engine order", "direction"]]
           speed [rpm]  engine order direction
        0      27000.0           6.0  standing
        """
        return self.table("critical_speeds")


def open_response(path, report=None):
    """The Response in a file response.h5."""
    return Response(path, report)
