# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of a Response by matplotlib. Each function draws into the axes that it is given, or into new ones, and returns them."""
import numpy as np


def _axes(axes):
    from matplotlib import pyplot
    return axes or pyplot.figure(figsize=(8, 5), layout="constrained").add_subplot()


def interaction_map(response, edge="leading", axes=None, floor=3e-3):
    """Amplitude [mm] of an edge of the tip over speed [rpm] and frequency [Hz] in the rotor frame, on a logarithmic scale.

    `edge` is "leading" or "trailing". What is below `floor`, relative to the largest amplitude, has the darkest colour.

    >>> interaction_map(open_response("response.h5")).get_xlabel()
    'speed [rpm]'
    """
    import pandas
    from matplotlib.colors import LogNorm
    axes = _axes(axes)
    table = pandas.read_csv(response.report_file("figures", f"interaction_map_{edge}_edge.csv"))
    lines = [(speed, own["frequency [Hz]"].to_numpy(), own["total [mm]"].to_numpy()) for speed, own in table.groupby("speed [rpm]")]
    speeds, largest = np.array([speed for speed, _, _ in lines]), table["total [mm]"].max()
    norm = LogNorm(floor * largest, largest)
    axes.set_facecolor("#440154")  # the darkest colour of viridis
    # Each speed has frequencies of its own, and reaches halfway to the next.
    borders = _borders(speeds)
    for (_, frequencies, amplitudes), left, right in zip(lines, borders[:-1], borders[1:]):
        half = min(table["frequency [Hz]"].max() / 120, np.min(np.diff(frequencies)) / 2)
        bands = np.column_stack([amplitudes, np.zeros(len(amplitudes))]).ravel()[:-1]  # empty between the lines
        drawn = axes.pcolormesh([left, right], np.column_stack([frequencies - half, frequencies + half]).ravel(),
                                np.maximum(bands, floor * largest)[:, None], norm=norm, cmap="viridis", rasterized=True)
    axes.set(xlabel="speed [rpm]", ylabel="frequency in the rotor frame [Hz]", title=f"{edge} edge", xlim=(borders[0], borders[-1]),
             ylim=(0, table["frequency [Hz]"].max()))
    axes.figure.colorbar(drawn, ax=axes, label="amplitude [mm]")
    return axes


def _borders(values):
    """Midway between ascending values, with half a step more at both ends."""
    if len(values) == 1:
        return np.array([values[0] - 0.5, values[0] + 0.5])
    middle = (values[1:] + values[:-1]) / 2
    return np.concatenate([[1.5 * values[0] - 0.5 * values[1]], middle, [1.5 * values[-1] - 0.5 * values[-2]]])


def campbell(response, modes=2, engine_orders=None, nodal_diameters=None, axes=None):
    """Natural frequencies [Hz] over speed [rpm]: the lowest `modes` of each nodal diameter, with engine orders.

    By default the nodal diameters are those that move, and the engine orders all multiples of the lobes up to the highest
    frequency shown.

    >>> [line.get_label() for line in campbell(open_response("response.h5"), modes=1).lines][:2]
    ['ND 0', 'ND 2']
    """
    axes = _axes(axes)
    if nodal_diameters is None:
        nodal_diameters = [int(n) for n in response.file["nodal_diameters"]]
    top = 0.0
    for i, n in enumerate(nodal_diameters):
        data = response.frequencies[n][:, :modes]
        drawn = axes.plot(data.rpm, data, color=f"C{i}")
        drawn[0].set_label(f"ND {n}")
        top = max(top, data.max().item())
    fastest = data.rpm.max().item()
    if engine_orders is None:
        lobes = int(response.file["casing"].attrs["lobes"]) or 1
        engine_orders = range(lobes, max(lobes, int(1.1 * top / (response.sweep.rpm.min() / 60))) + 1, lobes)
    for order in engine_orders:
        axes.plot([0, fastest], [0, order * fastest / 60], color="0.7", linewidth=0.8, zorder=1)
        x = min(fastest, 1.1 * top / order * 60)
        axes.annotate(f"EO {order}", (x, order * x / 60), fontsize="small", color="0.4", annotation_clip=True)
    axes.set(xlabel="speed [rpm]", ylabel="frequency in the rotor frame [Hz]", xlim=(0, fastest), ylim=(0, 1.1 * top))
    axes.legend(loc="upper left")
    return axes


def budget(response, quantity="amplitude", axes=None):
    """By how many percent each uncertain input changes the critical speed with the largest amplitude, as bars.

    `quantity` is "speed", "amplitude", "|u|" or "stress". The response must hold an error budget ([simulate] budget).
    """
    axes = _axes(axes)
    table = response.table("error_budget")
    if table.empty:
        raise ValueError(f'{response.report}: holds no error budget; simulate with [simulate] budget = "largest", and report with [postprocess] component = "normal"')
    worst = table.loc[table["amplitude [mm]"].idxmax(), "critical speed [rpm]"]
    table = table[(table["critical speed [rpm]"] == worst) & (table["source"] != "as computed")]
    changes = table.set_index("source")[f"change of {quantity} [%]"].dropna()[::-1]
    sums = changes.index.isin(["root of the sum of squares", "blades that differ"])  # and bounds, without a sign
    axes.barh(changes.index, changes, color=np.where(sums, "0.7", np.where(changes < 0, "C0", "C1")))
    axes.axvline(0, color="0.3", linewidth=0.8)
    axes.set(xlabel=f"change of {quantity} [%]", title=f"critical speed at {worst:.0f} rpm, {table['wave'].iloc[0]}")
    return axes
