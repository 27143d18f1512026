# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 2, 3, 5, 6, 7, 21 and 23 of the paper: the wheel, its mesh, modes, casing and fields."""
import os
import sys

import numpy
from matplotlib.collections import PolyCollection

from drawing import COLOURS, panels, pyplot, save

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tests", "chain"))
from vtu import read_vtu

TURN, TILT = 35, -32  # [deg] of the view
QUADS = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]  # faces of a brick, by its corners


class Surface:
    """Outer faces of a report's file for ParaView."""

    def __init__(self, scene, name):
        self.fields = read_vtu(os.path.join(scene.folder, "report", "fields", name + ".vtu"))
        self.places = self.fields["Points"].astype(float)
        ends = self.fields["offsets"]
        starts = numpy.concatenate([[0], ends[:-1]])
        bricks = self.fields["connectivity"][starts[:, None] + numpy.arange(8)]
        faces = bricks[:, QUADS].reshape(-1, 4)
        # Faces inside occur twice, also where two sectors meet, whose nodes differ.
        middle = numpy.round(self.places[faces].mean(axis=1) * 1e6).astype(int)
        _, where, count = numpy.unique(middle, axis=0, return_index=True, return_counts=True)
        self.faces = faces[where[count == 1]]

    def draw(self, axes, values=None, moved=None, colours=None, edges=False, limit=None, turn=TURN):
        """From the front and above; `values` at nodes colour the faces, or `colours` of the faces do."""
        places = self.places if moved is None else self.places + moved
        right, up, towards = view(turn, TILT)
        corners = places[self.faces]
        depth = corners.mean(axis=1) @ towards
        order = numpy.argsort(depth)
        normal = numpy.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
        shade = 0.55 + 0.45 * abs(normal @ (towards + 0.5 * up)) / numpy.maximum(numpy.linalg.norm(normal, axis=1), 1e-30) / 1.118
        if colours is None:
            scaled = numpy.clip(values[self.faces].mean(axis=1) / (limit or values.max()), 0, 1) if values is not None else None
            colours = pyplot.get_cmap("viridis")(scaled)[:, :3] if values is not None else numpy.full((len(self.faces), 3), 0.75)
        painted = colours * shade[:, None]
        flat = numpy.stack([corners @ right, corners @ up], axis=2)
        axes.add_collection(PolyCollection(flat[order], facecolors=painted[order], edgecolors="0.25" if edges else painted[order],
                                           linewidths=0.25 if edges else 0.3))
        axes.set_aspect("equal")
        axes.autoscale_view()
        axes.axis("off")


def view(turn, tilt):
    """Unit vectors to the right, up, and towards the eye; the axis of rotation points up, with the inlet on top."""
    turn, tilt = numpy.radians(turn), numpy.radians(tilt)
    towards = numpy.array([numpy.cos(tilt) * numpy.cos(turn), numpy.cos(tilt) * numpy.sin(turn), numpy.sin(tilt)])
    right = numpy.array([numpy.sin(turn), -numpy.cos(turn), 0.0])
    return right, numpy.cross(towards, right), towards


def section(scenes):
    figure, axes = panels(1, 2)
    for place, (wheel, (scene, _)) in zip(axes, scenes.items()):
        for (_, _), line in scene.figure("meridional_section").groupby(["line", "piece"], sort=False):
            place.plot(line["z [mm]"], line["r [mm]"], color="0.3", linewidth=0.8)
        place.set(title=wheel, xlabel="z [mm]", ylabel="r [mm]")
        place.set_aspect("equal")
    save(figure, "02")


def node_sets(scene):
    """The sector, and its clamped, contact and cut faces."""
    surface = Surface(scene, "modes_sector")
    kind = surface.fields["node_set"].astype(int)
    held = numpy.array([numpy.bincount(kind[face], minlength=5) for face in surface.faces])
    colours = numpy.full((len(surface.faces), 3), 0.8)
    colours[held[:, 1] == 4] = (0.85, 0.1, 0.1)
    cut = colours.copy()
    for number, colour in ((3, (0.0, 0.6, 0.45)), (4, (0.9, 0.6, 0.0))):
        cut[(held[:, number] + held[:, 1] == 4) & (held[:, number] > 0)] = colour
    contact = surface.places[kind == 2]
    for name, faces in (("03", colours), ("07", cut)):
        figure, axes = panels(1, 2, width=9, height=3.8)
        for place, turn in zip(axes, (TURN, TURN + 150)):  # from outside, and from the bore
            surface.draw(place, colours=faces, edges=True, turn=turn)
            right, up, _ = view(turn, TILT)
            place.plot(contact @ right, contact @ up, "o", color="#1040ff", markersize=4)
        save(figure, name)


def modes(scene):
    surface = Surface(scene, "modes_wheel")
    reach = 0.06 * numpy.hypot(*surface.places[:, :2].T).max()
    families = sorted({int(name.split("family")[1].split("_")[0]) for name in surface.fields if "family" in name})
    for number, family in (("05", 1), ("06", max(families))):
        names = [name for name in surface.fields if name.endswith(f"family{family}")]
        figure, axes = panels(1, len(names), width=3.4 * len(names), height=3)
        for place, name in zip(axes, names):
            motion = surface.fields[name]
            surface.draw(place, numpy.linalg.norm(motion, axis=1), moved=reach * motion)
            place.set_title(f"nodal diameter {name[2]}, family {family}", loc="center")
        save(figure, number)


def casing(scenes):
    figure, axes = panels(1, 2, width=8, height=3.6, subplot_kw={"projection": "polar"})
    for place, scene in zip(axes, scenes["paper-like wheel"]):
        table = scene.figure("casing")
        angle = numpy.radians(table["angle [deg]"])
        place.plot(angle, numpy.full(len(angle), 3.0), color="0.7", linewidth=0.8, label="round")
        place.plot(angle, 3.0 - 3 * table["distortion [mm]"], color=COLOURS[2], label="casing, distortion enlarged")
        place.set(title=f"{scene.lobes} lobes", yticks=[], ylim=(0, 3.9))
    axes[0].legend(loc="upper center", bbox_to_anchor=(1.1, 0.02))
    save(figure, "21")


def fields(scene):
    surface = Surface(scene, "contact_wheel")
    motion = numpy.linalg.norm(surface.fields["displacement_vibration"], axis=1)
    stress = surface.fields["von_mises_vibration"] / 1e6
    figure, axes = panels(1, 4, width=12, height=3.2)
    for k, (values, unit) in enumerate(((motion * 1e3, "mm"), (stress, "MPa"))):
        for place, share, what in ((axes[2 * k], 1.0, ""), (axes[2 * k + 1], 0.1, ", colours for the disc")):
            limit = share * values.max()
            surface.draw(place, values, limit=limit)
            place.set_title(f"({'abcd'[2 * k + (share < 1)]}) {'displacement' if k == 0 else 'stress'}{what}\nyellow: {limit:.3g} {unit}")
    save(figure, "23")


def draw(scenes):
    scene = scenes["paper-like wheel"][0]
    section(scenes)
    node_sets(scene)
    modes(scene)
    casing(scenes)
    fields(scene)
