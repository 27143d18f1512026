# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures 18, 19, 22, 24 to 28 of the paper: what is drawn over the speed."""
import numpy
from matplotlib.colors import LogNorm

from drawing import COLOURS, FREQUENCY, OMEGA, STYLES, borders, limit_omega, panels, save

WIDTH, HEIGHT = 420, 240      # points of a map
FLOOR = 5e-3                  # of the largest amplitude: the darkest colour
TOP = {2: 45.0, 3: 60.0}      # highest frequency drawn, by the number of lobes


def raster(scene, table, column):
    """Amplitude [mm] over frequency and speed, on a grid of points; each spectral line is a few points high."""
    speeds = numpy.unique(table["speed [rpm]"])
    picture, top = numpy.zeros((HEIGHT, WIDTH)), TOP[scene.lobes]
    at = numpy.linspace(speeds[0], speeds[-1], WIDTH)
    nearest = abs(at[:, None] - speeds).argmin(axis=1)
    for k, (_, own) in enumerate(table.groupby("speed [rpm]")):
        columns = numpy.flatnonzero(nearest == k)
        rows = (scene.frequency(own["frequency [Hz]"]) / top * HEIGHT).astype(int)
        for row, amplitude in zip(rows, own[column]):
            if 2 < row < HEIGHT and len(columns):  # without the mean
                part = picture[row - 2:row + 3, columns[0]:columns[-1] + 1]
                numpy.maximum(part, amplitude, out=part)
    return picture, scene.omega([speeds[0], speeds[-1]])


def draw_map(place, scene, picture, ends, largest):
    drawn = place.imshow(numpy.maximum(picture, FLOOR * largest), origin="lower", aspect="auto", cmap="viridis",
                         norm=LogNorm(FLOOR * largest, largest), extent=[*ends, 0, TOP[scene.lobes]], interpolation="nearest")
    for order in range(scene.lobes, 4 * scene.lobes + 1, scene.lobes):
        place.plot(ends, order * ends, color="white", linewidth=0.4, alpha=0.6)
        place.annotate(f"{order}", (ends[1], order * ends[1]), (1, -3), textcoords="offset points", fontsize=6, annotation_clip=True)
    place.set(xlim=ends, ylim=(0, TOP[scene.lobes]))
    return drawn


def parts(scene, number, edge="leading"):
    """The map and its six parts."""
    table = scene.figure(f"interaction_map_{edge}_edge")
    figure, axes = panels(2, 4, height=5.2, width=11, sharex=True, sharey=True)
    columns = ["total [mm]", *(f"nodal diameter {n} [mm]" for n in range(6))]
    largest = raster(scene, table, columns[0])[0].max()
    for place, letter, column in zip(axes, "abcdefg", columns):
        drawn = draw_map(place, scene, *raster(scene, table, column), largest)
        place.set_title(f"({letter}) {column.removesuffix(' [mm]')}")
    axes[7].axis("off")
    figure.colorbar(drawn, ax=axes[7], fraction=0.5, label=f"{edge} edge, normal [mm]")
    figure.supxlabel(f"{OMEGA}: {scene.wheel}, {scene.lobes} lobes; white: engine orders", fontsize=9)
    figure.supylabel(FREQUENCY, fontsize=9)
    save(figure, number)


def waterfall(scene):
    table = scene.figure("interaction_map_leading_edge")
    figure, (left, right) = panels(1, 2, height=3.8)
    every = numpy.unique(table["speed [rpm]"])[::3]
    step = table["total [mm]"].groupby(table["speed [rpm]"]).max().max() / 12
    for k, rpm in reversed(list(enumerate(every))):
        own = table[(table["speed [rpm]"] == rpm) & (table["engine order"] > 0)]
        base = step * k * 0.5
        left.vlines(scene.frequency(own["frequency [Hz]"]), base, base + own["total [mm]"], color=COLOURS[2], linewidth=0.8)
        left.axhline(base, color="0.9", linewidth=0.4, zorder=0)
    left.set(title="(a) spectra, from low to high speed", xlabel=FREQUENCY, xlim=(0, TOP[2]), yticks=[])
    picture, ends = raster(scene, table, "total [mm]")
    drawn = draw_map(right, scene, picture, ends, picture.max())
    right.set(title=f"(b) {scene.wheel}", xlabel=OMEGA, ylabel=FREQUENCY)
    figure.colorbar(drawn, ax=right, label="leading edge, normal [mm]")
    save(figure, "18")


def contact_image(place, scene, edge):
    rpm, _, _, shares = scene.contact_map(edge)
    ends = scene.omega([rpm[0], rpm[-1]])
    at = numpy.linspace(rpm[0], rpm[-1], WIDTH)
    nearest = abs(at[:, None] - rpm).argmin(axis=1)
    place.imshow(shares[nearest].T, origin="lower", aspect="auto", cmap="Blues", vmin=0, vmax=1, extent=[*ends, 0, 360], interpolation="nearest")
    place.set(xlabel=OMEGA, yticks=range(0, 361, 60), xlim=ends)


def contact_maps(scenes, lobes, number):
    figure, axes = panels(1, 4, width=12, sharey=True)
    for pair, cases in zip((axes[:2], axes[2:]), scenes.values()):
        for place, letter, edge in zip(pair, "ab", ("leading", "trailing")):
            contact_image(place, cases[lobes - 2], edge)
            place.set_title(f"({letter}) {cases[0].wheel}: {edge} edge")
    axes[0].set_ylabel("angle on the casing [deg]")
    save(figure, number)


def one_contact_map(scene):
    figure, (place,) = panels(1, 1, width=6)
    contact_image(place, scene, "trailing")
    place.set(title=f"{scene.wheel}, two lobes: trailing edge of sector 0", ylabel="angle on the casing [deg]")
    save(figure, "19")


def tracked(scene, order, diameter):
    """Speeds [rpm] and amplitude [mm] of an engine order on a nodal diameter."""
    table = scene.figure("interaction_map_leading_edge")
    own = table[abs(table["engine order"] - order) < 1e-6]
    return own["speed [rpm]"], own[f"nodal diameter {diameter} [mm]"]


def tracking(scenes, number, title, curves):
    """`curves`: title of a panel -> [(label, engine order, nodal diameter)]."""
    figure, axes = panels(1, 4, width=12)
    for pair, (scene, _) in zip((axes[:2], axes[2:]), scenes.values()):
        for place, (heading, lines) in zip(pair, curves.items()):
            for k, (label, order, diameter) in enumerate(lines):
                rpm, amplitude = tracked(scene, order, diameter)
                place.semilogy(scene.omega(rpm), numpy.maximum(amplitude, 1e-9), STYLES[k], color=COLOURS[k], linewidth=1, label=label)
            limit_omega(place, scene)
            place.set(title=f"{heading}, {scene.wheel}", xlabel=OMEGA, ylim=(1e-5, None))
    axes[0].set_ylabel(title)
    axes[2].legend(ncols=3, loc="lower center")
    save(figure, number)


def draw(scenes):
    paper_like, flying = scenes.values()
    waterfall(paper_like[0])
    one_contact_map(paper_like[0])
    parts(paper_like[0], "22")
    parts(flying[0], "22_flying")
    contact_maps(scenes, 2, "24")
    tracking(scenes, "25", "leading edge, normal [mm]", {f"({letter}) EO {k}": [(f"ND {n}", k, n) for n in range(6)] for letter, k in (("a", 2), ("b", 4))})
    tracking(scenes, "26", "leading edge, normal [mm]", {f"({letter}) ND {n}": [(f"EO {k}", k, n) for k in range(1, 7)] for letter, n in (("a", 2), ("b", 4))})
    parts(paper_like[1], "27")
    parts(flying[1], "27_flying")
    contact_maps(scenes, 3, "28")
