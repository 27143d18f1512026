# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 4, 8, 9, 12 and 13 of the paper: frequencies of the model, and aliasing."""
import os

import numpy
import pandas

from drawing import COLOURS, FOLDER, FREQUENCY, OMEGA, STYLES, panels, save


def veering(scenes):
    figure, axes = panels(1, 2, sharey=True)
    for place, (wheel, (scene, _)) in zip(axes, scenes.items()):
        for family in range(scene.families.shape[1]):
            place.plot(scene.frequency(scene.families[:, family]), "o-", color=COLOURS[family], label=f"family {family + 1}")
        place.set(title=f"{wheel}, at rest", xlabel="nodal diameter", xticks=range(6))
        place.grid(color="0.9")
    axes[0].set(ylabel=FREQUENCY, ylim=(0, None))
    axes[0].legend(ncols=3, loc="lower center")
    save(figure, "04")


def campbell(scenes):
    figure, axes = panels(1, 2, sharey=True)
    for place, (wheel, (scene, _)) in zip(axes, scenes.items()):
        table = scene.figure("campbell").query("family <= 2")
        for (diameter, family), line in table.groupby(["nodal diameter", "family"]):
            place.plot(scene.omega(line["speed [rpm]"]), scene.frequency(line["frequency [Hz]"]), STYLES[diameter],
                       color=COLOURS[diameter], label=f"ND {diameter}" if family == 1 else None)
        top = scene.omega(table["speed [rpm]"].max())
        for order in range(2, 13, 2):
            end = min(top, 24 / order)
            place.plot([0, end], [0, order * end], color="0.75", linewidth=0.8, zorder=0)
            place.annotate(f"EO {order}", (end, order * end), (-2, 2), textcoords="offset points", ha="right", fontsize=7, color="0.4")
        place.set(title=wheel, xlabel=OMEGA, xlim=(0, top), ylim=(0, 26))
    axes[0].set_ylabel(FREQUENCY)
    axes[0].legend(ncols=6, loc="lower right", fontsize=7, handlelength=1.4, columnspacing=0.8)
    save(figure, "08")


def modes_kept(traces):
    """`traces`: radial motion over the angle for each number of modes."""
    figure, (place,) = panels(1, 1, width=7)
    angle, *columns = traces.columns
    for k, column in enumerate(columns):
        place.plot(traces[angle], traces[column], STYLES[k], color=COLOURS[k], label=column.removesuffix(" [mm]").replace("eta", "η"))
    place.set(xlabel="angle of the rotor [deg]", ylabel="leading edge, radial [mm]", xlim=(0, 360), xticks=range(0, 361, 60))
    place.legend(ncols=5, loc="upper center")
    place.margins(y=0.2)
    save(figure, "09")


def aliasing():
    figure, axes = panels(1, 2, height=2.6, sharey=True)
    fine, blades = numpy.linspace(0, 2 * numpy.pi, 721), 2 * numpy.pi * numpy.arange(1, 11) / 10
    for place, (high, low) in zip(axes, ((6, 4), (8, 2))):
        for order, colour, style in ((high, COLOURS[2], "-"), (low, COLOURS[4], "--")):
            place.plot(fine, numpy.cos(order * fine), style, color=colour, label=f"cos {order}θ")
        place.plot(blades, numpy.cos(high * blades), "ko", label="ten blades")
        place.set(xlabel="θ", xticks=numpy.arange(5) * numpy.pi / 2, xticklabels=["0", "π/2", "π", "3π/2", "2π"], ylim=(-1.2, 1.6))
        place.legend(ncols=3, loc="upper center")
    save(figure, "12")


def zigzag():
    figure, (place,) = panels(1, 1, width=7, height=2.6)
    orders = numpy.arange(31)
    diameters = numpy.minimum(orders % 10, -orders % 10)
    place.plot(orders, diameters, color="0.7", zorder=0)
    place.plot(orders[2::2], diameters[2::2], "o", fillstyle="none", markersize=9, color=COLOURS[2], label="two lobes")
    place.plot(orders[3::3], diameters[3::3], "o", markersize=4, color=COLOURS[4], label="three lobes")
    place.set(xlabel="engine order", ylabel="nodal diameter", xticks=range(0, 31, 2), yticks=range(6), ylim=(-0.4, 6.6))
    place.legend(ncols=2, loc="upper center")
    save(figure, "13")


def draw(scenes):
    veering(scenes)
    campbell(scenes)
    modes_kept(pandas.read_csv(os.path.join(FOLDER, "..", "traces.tsv"), sep="\t"))
    aliasing()
    zigzag()
