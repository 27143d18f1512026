#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where in the interaction map the critical speeds lie: each is marked with its engine order.   interaction_map.py CASE_FOLDER"""
import sys

import tiprub

response = tiprub.open_response(sys.argv[1] + "/response.h5")
axes = tiprub.plots.interaction_map(response)
peaks = response.critical_speeds
for _, peak in peaks[peaks["engine order"] <= 12].iterrows():  # the map ends with [postprocess] engine_order_max
    frequency = peak["engine order"] * peak["speed [rpm]"] / 60
    axes.plot(peak["speed [rpm]"], frequency, "o", markersize=12, markerfacecolor="none", markeredgecolor="white")
    axes.annotate(f"EO {peak['engine order']:.0f}", (peak["speed [rpm]"], frequency), (8, -14), textcoords="offset points", color="white")
axes.figure.savefig("interaction_map.png", dpi=120)
