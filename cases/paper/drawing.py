# SPDX-License-Identifier: GPL-3.0-or-later
"""What the pictures share: their looks, and small files."""
import io
import os

import matplotlib
import numpy

matplotlib.use("agg")
from matplotlib import pyplot  # after the choice of a renderer without a screen
from PIL import Image

COLOURS = ["#000000", "#e69f00", "#0072b2", "#009e73", "#d55e00", "#cc79a7"]  # nodal diameters 0 to 5, safe for the colour-blind
STYLES = ["-", "--", "-", "--", "-", "--"]
OMEGA, FREQUENCY = "Ω (first family at 10)", "frequency (first family at 10)"
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "expected")
DOTS_PER_INCH, PALETTE = 90, 96
pyplot.rcParams.update({"font.size": 9, "axes.titlesize": 9, "axes.titlelocation": "left", "legend.fontsize": 8})


def panels(rows, columns, width=10.0, height=3.4, **options):
    figure, axes = pyplot.subplots(rows, columns, figsize=(width, height), layout="constrained", squeeze=False, **options)
    return figure, axes.ravel()


def save(figure, number):
    """As PNG with a palette."""
    with io.BytesIO() as buffer:
        figure.savefig(buffer, dpi=DOTS_PER_INCH, format="png")
        pyplot.close(figure)
        picture = Image.open(buffer).convert("RGB").quantize(PALETTE, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
    path = os.path.join(FOLDER, f"figure_{number}.png")
    picture.save(path, optimize=True)
    print(f"{os.path.basename(path)}: {os.path.getsize(path) / 1000:.0f} kB")


def borders(values):
    """Midway between ascending values, with half a step more at both ends."""
    middle = (values[1:] + values[:-1]) / 2
    return numpy.concatenate([[1.5 * values[0] - 0.5 * values[1]], middle, [1.5 * values[-1] - 0.5 * values[-2]]])


def limit_omega(axes, scene):
    axes.set_xlim(scene.omega(scene.speeds["speed [rpm]"].min()), scene.omega(scene.speeds["speed [rpm]"].max()))
