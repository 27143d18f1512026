#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The first family on all nodal diameters, and what contact does to it: critical speeds of the family lie above the crossings.
campbell.py CASE_FOLDER"""
import sys

import tiprub

response = tiprub.open_response(sys.argv[1] + "/response.h5")
axes = tiprub.plots.campbell(response, modes=1)
peaks = response.critical_speeds
peaks = peaks[peaks["family"] == 1]
axes.plot(peaks["speed [rpm]"], peaks["engine order"] * peaks["speed [rpm]"] / 60, "k*", markersize=12, label="critical speed")
axes.set_ylim(0.95 * min(data.min() for data in response.frequencies.values()))
axes.legend(loc="upper left")
axes.figure.savefig("campbell.png", dpi=120)
