# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 10, 11, 14 to 17 and 20 of the paper: motion and force at one speed, the largest peak in two lobes."""
import numpy

from drawing import COLOURS, panels, save

HIGHEST_ORDER = 12


def shown_at(scene):
    return f"{scene.wheel}, {scene.shown:.0f} rpm, Ω = {scene.omega(scene.shown):.2f}"


def over_angle(scenes, number, name, unit, axis):
    """All sectors, each with its own shade."""
    figure, axes = panels(1, 2)
    for place, (scene, _) in zip(axes, scenes.values()):
        table = scene.figure(name)
        for sector in range(10):
            place.plot(table["rotor angle [deg]"], table[f"sector {sector} [{unit}]"], linewidth=0.9, color=str(0.09 * sector))
        place.set(title=shown_at(scene), xlabel="angle of the rotor [deg]", ylabel=f"{axis} [{unit}]", xlim=(0, 360), xticks=range(0, 361, 60))
    save(figure, number)


def by_diameter(table, value):
    """Both directions added: engine orders 0 .. HIGHEST_ORDER x nodal diameters."""
    total = numpy.zeros((HIGHEST_ORDER + 1, 6))
    for order, n, amplitude in zip(table["engine order"], table["signed nodal diameter"], table[value]):
        if order <= HIGHEST_ORDER and abs(order - round(order)) < 1e-6:
            total[round(order), abs(n)] += amplitude
    return total


def spectra(scenes, number, name, unit):
    """Two-way spectrum as bars over the engine order, by nodal diameter."""
    figure, axes = panels(1, 2, subplot_kw={"projection": "3d"}, height=4.2)
    for place, (scene, _) in zip(axes, scenes.values()):
        total = by_diameter(scene.figure(name), f"amplitude [{unit}]")
        for n in range(5, -1, -1):
            orders = numpy.arange(1, HIGHEST_ORDER + 1)
            place.bar(orders, total[1:, n], zs=n, zdir="y", width=0.5, color=COLOURS[n])
        place.set(title=shown_at(scene), xlabel="engine order", ylabel="nodal diameter", zlabel=f"amplitude [{unit}]",
                  xticks=range(2, 13, 2), yticks=range(6))
        place.view_init(28, -62)
    save(figure, number)


def force(scenes):
    figure, axes = panels(1, 2)
    for place, (scene, _) in zip(axes, scenes.values()):
        table = scene.figure("contact_force")
        for edge, colour in (("trailing", "0.7"), ("leading", COLOURS[2])):
            place.plot(table["rotor angle [deg]"], table[f"{edge} edge [N]"], color=colour, label=f"{edge} edge")
        place.set(title=shown_at(scene), xlabel="angle of the rotor [deg]", ylabel="force on sector 0 [N]", xlim=(0, 360), xticks=range(0, 361, 60))
        place.legend()
    save(figure, "14")
    figure, axes = panels(1, 2, height=2.8)
    for place, (scene, _) in zip(axes, scenes.values()):
        force = scene.figure("contact_force")["leading edge [N]"].to_numpy()
        amplitude = 2 * abs(numpy.fft.rfft(force)) / len(force)
        place.bar(range(1, 25), amplitude[1:25], width=0.4, color=COLOURS[2])
        place.set(title=shown_at(scene), xlabel="engine order", ylabel="leading edge [N]", xticks=range(0, 25, 2))
    save(figure, "15")


def bars(scenes):
    figure, axes = panels(1, 4, height=2.9, width=11)
    for pair, (scene, _) in zip((axes[:2], axes[2:]), scenes.values()):
        total = by_diameter(scene.figure("tip_spectrum"), "amplitude [mm]")
        pair[0].bar(range(6), total[4], color=COLOURS)
        pair[0].set(title=f"{scene.wheel}\nEO 4, Ω = {scene.omega(scene.shown):.2f}", xlabel="nodal diameter", ylabel="amplitude [mm]", xticks=range(6))
        pair[1].bar(range(1, HIGHEST_ORDER + 1), total[1:, 4], color=COLOURS[4])
        pair[1].set(title="nodal diameter 4", xlabel="engine order", xticks=range(2, 13, 2))
    save(figure, "20")


def draw(scenes):
    over_angle(scenes, "10", "tip_motion", "mm", "leading edge, towards the casing")
    spectra(scenes, "11", "tip_spectrum", "mm")
    force(scenes)
    over_angle(scenes, "16", "force_of_sectors", "N", "leading edge")
    spectra(scenes, "17", "force_spectrum", "N")
    bars(scenes)
