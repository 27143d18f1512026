#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes expected/numbers.tsv, from which ../fill_pages.py fills the cells of the page: a key and its value in a line.   tell_numbers.py"""
import os

import numpy

from scenes import all_scenes

HERE = os.path.dirname(os.path.abspath(__file__))
SHORT = {"paper-like wheel": "p", "flying wheel": "f"}


def span(values, form):
    low, high = f"{numpy.min(values):{form}}", f"{numpy.max(values):{form}}"
    return low if low == high else f"{low} to {high}"


def spread(frequencies):
    return f"{100 * (frequencies.max() - frequencies.min()) / frequencies.mean():.2g}"


def of_model(scene):
    families = scene.families
    first, second = families[:, 0], families[:, 1]
    table = scene.figure("campbell").query("family == 1")
    turning = table[table["speed [rpm]"] == table["speed [rpm]"].max()]["frequency [Hz]"].mean()
    rpm = scene.speeds["speed [rpm]"]
    return {"first_hz": span(first, ".0f"), "first_spread": spread(first), "second": span(scene.frequency(second), ".1f"),
            "second_spread": spread(second), "first_turning": f"{scene.frequency(turning):.1f}",
            "omega": span(scene.omega(rpm), ".1f"), "rpm": span(rpm, ",.0f")}


def peak(row, scene):
    return (f"EO {row['engine order']:g} ND {row['signed nodal diameter']:+g} at Ω = {scene.omega(row['speed [rpm]']):.2f} "
            f"({row['speed [rpm]']:,.0f} rpm)")


def of_motion(scene):
    critical, rules = scene.critical, scene.report("linear_rules").set_index("rule")
    largest, at = scene.largest, scene.speeds
    return {"speeds": str(len(at)), "periodic": str((at["motion"] == "periodic").sum()), "critical": str(len(critical)),
            "eq2_missed": str(rules.loc["eq. 2", "missed"]), "alias_missed": str(rules.loc["with aliasing", "missed"]),
            "alias_false": str(rules.loc["with aliasing", "false alarms"]),
            "peak": peak(largest, scene), "peak_mm": f"{largest['amplitude [mm]']:.3f}", "shown": f"{scene.omega(scene.shown):.2f}",
            "by_order": ", ".join(f"EO {k:g}: {value:.3f}" for k, value in highest_by_order(scene).items())}


def highest_by_order(scene):
    """[mm] largest amplitude of the leading edge on each of the first multiples of the lobes."""
    table = scene.figure("interaction_map_leading_edge")
    on = table[(table["engine order"] % scene.lobes == 0) & table["engine order"].between(1, 12)]
    return on.groupby("engine order")["total [mm]"].max()


def by_diameter(scene):
    table = scene.figure("interaction_map_leading_edge")
    table = table[table["engine order"] > 0]
    power = (table.filter(like="nodal diameter") ** 2).sum().to_numpy()
    return ", ".join(f"{n}: {100 * share:.2g} %" for n, share in enumerate(power / power.sum()))


def of_contact(scene):
    found = {}
    for edge in ("leading", "trailing"):
        rpm, places, contrast, _ = scene.contact_map(edge)
        found[f"{edge}_places"] = f"{numpy.median(places):.0f}"
        found[f"{edge}_most"] = str(places.max())
        found[f"{edge}_share"] = f"{100 * (places == scene.lobes).mean():.0f}"
        found[f"{edge}_contrast"] = f"{numpy.median(contrast):.2f}"
    return found


def of_drift(scene):
    rows = scene.report("contact_drift").set_index("what")
    middle, lag = rows.loc["leading edge's middle"], rows.loc["leading edge's force after the trailing edge's"]
    return {"middle_r2": f"{middle['R^2']:.2f}", "lag_r2": f"{lag['R^2']:.2f}", "lag_us": f"{1e6 * lag['median lag [s]']:.0f}",
            "lag_quartiles": f"{1e6 * lag['lower quartile [s]']:.0f} to {1e6 * lag['upper quartile [s]']:.0f}"}


def main():
    rows = {}
    for wheel, cases in all_scenes(HERE).items():
        for scene in cases:
            found = {**(of_model(scene) if scene.lobes == 2 else {}), **of_motion(scene), **of_contact(scene),
                     **(of_drift(scene) if scene.lobes == 2 else {}), "by_diameter": by_diameter(scene)}
            rows |= {f"{SHORT[wheel]}{scene.lobes}.{key}": value for key, value in found.items()}
    with open(os.path.join(HERE, "expected", "numbers.tsv"), "w", encoding="utf-8") as file:
        file.write("key\tvalue\n")
        file.writelines(f"{key}\t{value}\n" for key, value in rows.items())


if __name__ == "__main__":
    main()
