#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the picture of glossary.md: a wave on a wheel, and the nodal diameters that engine orders drive.   waves.py"""
import numpy as np
from matplotlib import pyplot

SECTORS, LOBES, DIAMETERS, ORDERS = 10, 2, 4, 20

figure, (wheel, map_) = pyplot.subplots(1, 2, figsize=(11, 5), layout="constrained", width_ratios=(1, 1.25))
angle = np.linspace(0, 2 * np.pi, 361)
casing = 1.62 - 0.12 * np.cos(LOBES * angle)
wheel.plot(casing * np.cos(angle), casing * np.sin(angle), color="0.4", linewidth=3)
wheel.fill(0.55 * np.cos(angle), 0.55 * np.sin(angle), color="0.85")
for j in range(SECTORS):
    place = 2 * np.pi * j / SECTORS
    lean = 0.28 * np.cos(DIAMETERS * place)
    radius = np.linspace(0.55, 1.38, 20)
    turned = place + lean * ((radius - 0.55) / 0.83) ** 2
    wheel.plot(radius * np.cos(place), radius * np.sin(place), color="0.75", linewidth=1)
    wheel.plot(radius * np.cos(turned), radius * np.sin(turned), linewidth=4, color="0.2")
border = np.radians([18, 54])  # of the sector with the blade at 36 degrees
wheel.fill(np.append(0, 1.45 * np.cos(border)), np.append(0, 1.45 * np.sin(border)), color="C2", alpha=0.2)
wheel.text(1.72, 0.55, "one sector", color="C2")
wheel.annotate("", (-0.3, 0.1), (0.3, 0.1), arrowprops={"arrowstyle": "->", "connectionstyle": "arc3,rad=0.6"})
wheel.text(0, -0.2, "rotation", ha="center")
wheel.text(1.05, 1.45, "casing with\ntwo lobes", color="0.3")
wheel.set(aspect="equal", title="nodal diameter 4 on ten sectors", xlim=(-1.8, 2.4), ylim=(-1.9, 1.9))
wheel.axis("off")

orders = np.arange(ORDERS + 1)
signed = (orders + SECTORS // 2 - 1) % SECTORS - (SECTORS // 2 - 1)
map_.plot(np.linspace(0, ORDERS, 401), np.abs((np.linspace(0, ORDERS, 401) + 5) % SECTORS - 5), color="0.8", zorder=0)
for colour, chosen, label in (("C0", signed > 0, "ND +n: backward"), ("C3", signed < 0, "ND -n: forward"), ("0.4", signed % 5 == 0, "standing")):
    map_.scatter(orders[chosen], np.abs(signed[chosen]), color=colour, label=label, s=45)
reached = orders % LOBES == 0
map_.scatter(orders[reached], np.abs(signed[reached]), facecolor="none", edgecolor="black", s=150, label="multiples of the lobes")
map_.annotate("EO 6 drives ND -4", (6, 4), (7.2, 4.6), arrowprops={"arrowstyle": "->"})
map_.set(xlabel="engine order", ylabel="nodal diameter", xticks=orders[::2], yticks=range(SECTORS // 2 + 1), title="aliasing on ten sectors", ylim=(-0.3, 6.9))
map_.legend(loc="upper right", ncols=2)
figure.savefig("waves.png", dpi=100)
